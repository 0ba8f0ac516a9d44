/**
 * Search for gaits by the core's Newton's method, from where a runner settles and along the friction, as
 * `tdmf-slip gait` does it.
 * @module
 */
import { values } from "./data.js";

export const FRICTION = "ground.friction";
const SETTLING_STRIDES = 400;
const SMALLEST_STEP = 1e-4; // in the logarithm of the friction
const HOME = values.find(({ name }) => name === FRICTION).start;

/** Follows a gait to another friction by steps of its logarithm, halved where Newton's method does not get there. */
export function followFriction(core, given, from, gait, to) {
  let here = Math.log(from);
  const end = Math.log(to);
  let step = end - here;
  let found = gait;
  while (here !== end) {
    const next = Math.abs(end - here) <= Math.abs(step) ? end : here + step;
    core.accept({ ...given, [FRICTION]: next === end ? to : Math.exp(next) });
    const tried = core.gaitNear(found.apex);
    if (tried) {
      found = tried;
      here = next;
      step *= 2;
    } else if (Math.abs(step) < SMALLEST_STEP) {
      return null;
    } else {
      step /= 2;
    }
  }
  return found;
}

function settled(core, apex) {
  return core.gaitNear(core.settle(apex, SETTLING_STRIDES).apex);
}

/**
 * The gait of a runner.
 * @param {Core} core
 * @param {Object<string, number>} given Parameters and inputs, accepted before.
 * @param {number[]} apex Where the runner starts.
 * @returns {{gait: ?Gait, message: string}}
 */
export function findGait(core, given, apex) {
  core.accept(given);
  const gait = settled(core, apex);
  const { message } = core;
  if (gait || !(given[FRICTION] > 0)) {
    return { gait, message };
  }
  const home = { ...given, [FRICTION]: HOME };
  const start = core.accept(home) ? settled(core, apex) : null;
  const followed = start && followFriction(core, given, HOME, start, given[FRICTION]);
  core.accept(given);
  return { gait: followed, message: followed ? "" : message };
}

/**
 * A runner at the apex of its gait, its centre of mass at x = 0.
 * @returns {{start: ?Object<string, number>, message: string}} All its values by name, or why there is no such start.
 */
export function startOnGait(core, given, apex) {
  if (!core.accept(given)) {
    return { start: null, message: core.message };
  }
  const { gait, message } = findGait(core, given, apex);
  if (!gait) {
    return { start: null, message };
  }
  const state = core.stateAt(gait.apex);
  core.start(state);
  const shift = core.read()["com.x"];
  state["foot.x"] -= shift;
  state["foot.y"] -= shift * Math.tan(given["ground.slope"]);
  return { start: { ...given, ...state }, message: "" };
}
