/**
 * Numbers and words as people read them.
 * @module
 */
import { displayUnits } from "./data.js";

const MINUS = "\u2212";

/** A number to so many significant digits, with a minus sign as wide as a plus. */
export function digits(value, count = 4) {
  if (!Number.isFinite(value)) {
    return "–";
  }
  const size = Math.abs(value);
  const text =
    value !== 0 && (size < 1e-3 || size >= 1e6)
      ? value.toExponential(count - 1).replace("e+", "e")
      : String(Number(value.toPrecision(count)));
  return text.replaceAll("-", MINUS);
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

/** A unit in print. */
export function printed(unit) {
  return unit
    .replace("m/s2", "m/s²")
    .replaceAll(".", "·")
    .replace("deg", "°");
}
