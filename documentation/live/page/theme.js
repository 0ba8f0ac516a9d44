/**
 * Colours of the page, as canvases need them.
 * @module
 */
const NAMES = [
  "paper", "card", "ink", "soft", "faint", "line", "ground", "accent", "second", "bad", "cone",
  "flight", "stick", "slip_positive", "slip_negative", "graze",
];

const KEY = "theme";

let colours = null;
const dark = matchMedia("(prefers-color-scheme: dark)");

/** @returns {Object<string, string>} By the names of style.css. */
export function palette() {
  if (!colours) {
    const style = getComputedStyle(document.documentElement);
    colours = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    colours.sans = style.getPropertyValue("--sans").trim();
  }
  return colours;
}

/** The theme that was chosen, here or in the guides, whose key and words these are; storage may be forbidden. */
function chosenTheme() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function choose(theme) {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // it holds until the page is left
  }
  apply(theme);
}

function apply(theme) {
  if (["light", "dark"].includes(theme)) {
    document.documentElement.dataset.theme = theme;
  } else {
    delete document.documentElement.dataset.theme;
  }
}

/** Whether the page is dark now. */
function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === "dark" : dark.matches;
}

/** Calls back when the colours have changed. */
export function watchTheme(button, changed) {
  const renew = () => {
    colours = null;
    changed();
  };
  button.addEventListener("click", () => {
    choose(isDark() ? "light" : "dark");
    renew();
  });
  addEventListener("storage", ({ key, newValue }) => {
    if (key === KEY) {
      apply(newValue);
      renew();
    }
  });
  dark.addEventListener("change", renew);
}

apply(chosenTheme());
