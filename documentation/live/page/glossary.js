/**
 * Words of the field, explained where they stand: on hover, on focus, on a tap.
 * @module
 */
const TERMS = {
  graze: "Graze: the foot is on the ground but nothing presses it down, for the moment between stance and flight.",
  stick: "Stick, 0 in the gait word: the foot is at rest, as the ground force is inside the wedge of friction.",
  slip_positive: "Slip forward, + in the gait word: the foot slides the way the runner goes, and friction brakes it.",
  slip_negative: "Slip backward, − in the gait word: the foot slides back, as the leg pushes harder than friction holds.",
  flight: "Flight: the foot is off the ground, and the centre of mass follows a parabola.",
  word: "Gait word: what the foot does in one stride, a letter for each part of the stance: + slips forward, 0 sticks, − slips backward.",
  hip: "Hip: drives the leg in the first half of the stance, coasts in the second, retracts the leg while the runner rises, and places it from the apex on.",
  drive: "Drive: from touchdown to mid-stance the hip's torque pushes the runner on.",
  coast: "Coast: from mid-stance to lift-off the hip gives no torque.",
  retract: "Retract: while the runner rises in flight, the hip stops the backward swing that the leg has from lift-off.",
  place: "Place: from the apex on the hip turns the leg to the angle at which it is to land.",
  wedge: "The wedge at the foot is the friction cone: the ground bears any force inside it without slip; its half angle is arctan μ.",
  arrows: "Arrows: at the foot the force of the ground, in the colour of the contact; about the body the hip's torque; at the body what pushes it from outside.",
  gait: "Gait: a stride that comes back to the apex it began at, found by Newton's method on the return map from apex to apex.",
  eigenvalue: "Eigenvalue of the return map: what one stride makes of a small disturbance; below 1 in size the runner recovers.",
  friction: "Friction coefficient μ: the ground holds the foot while the force along it is less than μ times the force across it. Ice has 0.05, rubber on concrete 1.",
};

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
    note.textContent = TERMS[element.dataset.term];
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
  if (!TERMS[term]) {
    return;
  }
  element.dataset.term = term;
  element.tabIndex = 0;
  element.setAttribute("aria-describedby", "term-note");
}
