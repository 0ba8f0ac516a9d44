/**
 * Words of the field, explained where they stand: on hover, on focus, on a tap.
 * @module
 */
import { terms } from "./data.js";

const GAP = 6; // px between a word and its note

const termAt = ({ target }) => target.closest?.("[data-term]");

/** Explains every element that has a term, also those that come later. */
export function explainTerms() {
  const note = Object.assign(document.createElement("div"), { id: "term-note", role: "tooltip", hidden: true });
  document.body.append(note);
  const hide = () => {
    note.hidden = true;
  };
  const show = (element) => {
    note.textContent = terms[element.dataset.term];
    note.hidden = false;
    const { left, bottom, top } = element.getBoundingClientRect();
    const { width, height } = note.getBoundingClientRect();
    const room = document.documentElement.clientWidth - width - GAP;
    const below = bottom + GAP + height < innerHeight;
    note.style.left = `${Math.max(GAP, Math.min(left, room))}px`;
    note.style.top = `${below ? bottom + GAP : top - GAP - height}px`;
  };
  for (const type of ["pointerover", "focusin", "click"]) {
    document.addEventListener(type, (event) => {
      const element = termAt(event);
      if (element) {
        show(element);
      } else {
        hide();
      }
    });
  }
  document.addEventListener("keydown", ({ key }) => key === "Escape" && hide());
  addEventListener("scroll", hide, { passive: true });
}

/** Makes an element explain a term; it can be reached by keyboard, too. */
export function mark(element, term) {
  if (!terms[term]) {
    return;
  }
  element.dataset.term = term;
  element.tabIndex = 0;
  element.setAttribute("aria-describedby", "term-note");
}
