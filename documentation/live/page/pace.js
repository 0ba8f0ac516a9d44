/**
 * Speed at which the run is shown.
 * @module
 */
import { digits, printed } from "./numbers.js";
import { isLoaded, modeName } from "./run.js";

/** sqrt(m/k) in a second: real time for a runner of human scale. */
const FULL_SPEED = Math.sqrt(20000 / 80);
/** Of full speed, in flight and on the ground. */
const PACES = { full: [1, 1], stance: [1, 0.1], slow: [0.1, 0.1], slowest: [0.02, 0.02] };

/** @returns {number} Simulated seconds to a second, where the runner is now. */
export function paceOf(name, run) {
  const [flight, ground] = PACES[name];
  const mode = run.outputs["contact.mode"];
  const touches = isLoaded(mode) || modeName(mode) === "graze";
  return (touches ? ground : flight) * FULL_SPEED * run.core.timeScale;
}

/** A pace in words: how much of the run passes in a second of the page's. */
export function paceText(name, run) {
  const [flight, ground] = PACES[name].map(
    (share) => `${digits(share * FULL_SPEED * run.core.timeScale, 3)} ${printed("s")}`,
  );
  return flight === ground
    ? `each second shows ${flight} of the run`
    : `each second shows ${flight} of a flight, ${ground} of a stance`;
}

/** Whether the pace changes where the foot lands, so that a frame has to end there. */
export const changesAtTouchdown = (name) => PACES[name][0] !== PACES[name][1];
