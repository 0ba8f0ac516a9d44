/**
 * Numbers and words as people read them.
 * @module
 */
import { displayUnits, paperUnits } from "./data.js";

export const MINUS = "\u2212";
const NOISE = 1e-9; // of a quantity's scale: rounding, and where Newton's method stops

/** A number to so many significant digits, with a minus sign as wide as a plus. */
export function digits(value, count = 4) {
  if (!Number.isFinite(value)) {
    return "–";
  }
  const size = Math.abs(value);
  const text =
    value !== 0 && (size < 1e-3 || size >= 1e6)
      ? Number(value.toPrecision(count)).toExponential().replace("e+", "e")
      : String(Number(value.toPrecision(count)));
  return text.replaceAll("-", MINUS);
}

/** A value, or 0 where it is noise on its scale. */
export const withoutNoise = (value, scale) => (Math.abs(value) < NOISE * scale ? 0 : value);

/** What a person typed as a number; not a number where it is none. */
export function numberIn(text) {
  const typed = text.trim().replace(MINUS, "-").replace(",", ".");
  return typed === "" ? NaN : Number(typed);
}

/** As digits, but of the same width from one moment to the next. */
export function steady(value, decimals) {
  return Number.isFinite(value) ? value.toFixed(decimals).replaceAll("-", MINUS) : "–";
}

/** A gait word with a wide minus sign; a dash where there is none. */
export function shownWord(word) {
  return word ? word.replaceAll("-", MINUS) : "–";
}

/** Unit in which values of a unit are shown, and how many of it make one. */
export function shownUnit(unit) {
  return displayUnits[unit] ?? { name: unit === "1" ? "" : unit, factor: 1 };
}

/** A value with its unit, as its field shows it. */
export function shownValue({ unit, isFlag }, value) {
  if (isFlag) {
    return String(value !== 0);
  }
  const { name, factor } = shownUnit(unit);
  return `${digits(value * factor)}${name ? ` ${printed(name)}` : ""}`.replace(" °", "°");
}

/** What the core refuses, with its numbers in the units of the fields; what was no number is called so. */
export function inShownUnits(message) {
  const told = message.replace(
    /= (\S+) (\S+) (is refused: allowed from) (\S+) to (\S+) \2$/,
    (whole, value, unit, refused, low, high) => {
      const { name, factor } = shownUnit(unit);
      const [given, least, most] = [value, low, high].map((text) => Number((Number(text) * factor).toPrecision(4)));
      return factor === 1 ? whole : `= ${given} ${name} ${refused} ${least} to ${most} ${name}`;
    },
  );
  return told.replace(/= nan( \S+)? is refused: /i, "is no number: ");
}

const SCALES = ["body.mass", "leg.stiffness", "leg.free_length"];
let inPaperUnits = true;

/** Labels units from now on for a runner of these values: in the paper's where all scales are exactly 1. */
export function labelUnitsFor(values) {
  inPaperUnits = SCALES.every((name) => values[name] === 1);
  for (const element of document.querySelectorAll("[data-unit]")) {
    element.textContent = printed(element.dataset.unit);
  }
}

/** An element that shows a unit, and shows another label for it when the runner's units change. */
export function unitElement(tag, unit) {
  const element = document.createElement(tag);
  element.dataset.unit = unit;
  element.textContent = printed(unit);
  return element;
}

/** A unit in print. */
export function printed(unit) {
  return ((inPaperUnits && paperUnits[unit]) || unit)
    .replace("l0", "l₀")
    .replace(/ ?sqrt/, "√")
    .replace("^2", "²")
    .replace("^4", "⁴")
    .replace("m/s2", "m/s²")
    .replaceAll(".", "·")
    .replace("deg", "°");
}
