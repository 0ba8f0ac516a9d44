/**
 * Colours of the page, as canvases need them.
 * @module
 */
const NAMES = [
  "paper", "card", "ink", "soft", "faint", "line", "ground", "accent", "second", "bad", "cone",
  "flight", "stick", "slip_positive", "slip_negative", "graze",
];

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
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    renew();
  });
  dark.addEventListener("change", renew);
}
