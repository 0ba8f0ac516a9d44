/**
 * One sentence on what the runner does now, and the stride's word, which grows letter by letter.
 * @module
 */
import { hipPhases } from "./data.js";
import { MINUS } from "./numbers.js";
import { isLoaded, modeName } from "./run.js";

const LETTERS = { stick: "0", slip_positive: "+", slip_negative: "-" };
const ON_THE_GROUND = {
  stick: "The foot sticks: friction resists the push of the leg.",
  slip_negative: "The foot slides backward: the leg pushes harder than friction can resist.",
  graze: "The foot grazes: it touches the ground, but nothing presses it down.",
};

function slipsForward(run) {
  const landed = run.stance.every(({ mode }) => modeName(mode) === "slip_positive");
  return landed
    ? "The foot slides forward: it landed faster than friction can stop at once."
    : "The foot slides forward: the leg pushes it forward harder than friction can resist.";
}

/** @returns {string} What the runner does now. */
export function sentenceOf(run) {
  if (run.over) {
    return run.fallen ? "The runner has fallen." : "The run has stopped.";
  }
  const mode = modeName(run.outputs["contact.mode"]);
  if (mode === "flight") {
    return hipPhases[run.outputs["hip.phase"]].name === "retract"
      ? "The runner rises in flight, the foot off the ground."
      : "The runner falls in flight, and the hip places the leg for landing.";
  }
  return mode === "slip_positive" ? slipsForward(run) : ON_THE_GROUND[mode];
}

/** The word of this stride so far: what the core has written, and the contact that is not over. */
export function wordSoFar(run) {
  const { openWord, outputs } = run;
  const letter = isLoaded(outputs["contact.mode"]) ? LETTERS[modeName(outputs["contact.mode"])] : "";
  return openWord.endsWith(letter) ? openWord : openWord + letter;
}

/** The line under the runner. */
export class Now {
  /**
   * @param {HTMLElement} line
   * @param {HTMLElement} word
   */
  constructor(line, word) {
    Object.assign(this, { line, word });
  }

  /** @param {Run} run */
  show(run) {
    const text = sentenceOf(run);
    if (this.line.textContent !== text) {
      this.line.textContent = text;
      this.line.classList.toggle("over", run.over);
    }
    const soFar = wordSoFar(run);
    const whole = run.word.startsWith(soFar) ? run.word : soFar;
    if (this.shown !== `${soFar} ${whole}`) {
      this.shown = `${soFar} ${whole}`;
      this.word.replaceChildren(...Array.from(whole, (letter, i) => letterOf(letter, i < soFar.length)));
      this.word.setAttribute("aria-label", `Gait word: ${whole || "none yet"}`);
    }
  }
}

function letterOf(letter, lit) {
  const element = document.createElement("span");
  element.textContent = letter === "-" ? MINUS : letter;
  const mode = Object.keys(LETTERS).find((name) => LETTERS[name] === letter);
  element.className = lit ? "lit" : "";
  element.style.color = lit && mode ? `var(--${mode})` : "";
  return element;
}
