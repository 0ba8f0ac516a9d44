/**
 * Contact modes in words, and what the colours and shapes of the scene mean.
 * @module
 */
import { contactModes } from "./data.js";
import { mark } from "./glossary.js";

/** Names for people, by the unit's names of contact modes. */
export const MODE_TEXT = {
  flight: "flight",
  stick: "stick (0)",
  slip_positive: "slip forward (+)",
  slip_negative: "slip backward (−)",
  graze: "graze",
};

/** Fills the list of colours. */
export function fillLegend(list) {
  for (const { name } of Object.values(contactModes)) {
    const item = document.createElement("li");
    const dot = document.createElement("i");
    dot.style.background = `var(--${name})`;
    item.append(dot, MODE_TEXT[name] ?? name);
    mark(item, name);
    list.append(item);
  }
  for (const [name, text] of Object.entries({ wedge: "friction cone", arrows: "forces" })) {
    const item = document.createElement("li");
    item.append(text);
    mark(item, name);
    list.append(item);
  }
}
