/**
 * A worker with a core of its own, for what would hold up the page: the search for gaits, their continuation along the
 * friction, and blocks of a region of attraction.
 * @module
 */
import { Core } from "./core.js";
import { findGait, followFriction, FRICTION, startOnGait } from "./gaits.js";

let core = null;

/** One branch of the gaits against friction, sent point by point. */
function followCurve({ given, gait, frictions }, send) {
  let from = given[FRICTION];
  let here = gait;
  for (const friction of frictions) {
    here = followFriction(core, given, from, here, friction);
    if (!here) {
      return;
    }
    from = friction;
    send({ friction, gait: here });
  }
}

const jobs = {
  async start({ module }) {
    core = await Core.of(module);
  },
  find({ given, apex }) {
    return findGait(core, given, apex);
  },
  lane({ given, apex }) {
    return startOnGait(core, given, apex);
  },
  follow({ given, from, gait }) {
    const found = followFriction(core, given, from, gait, given[FRICTION]);
    return { gait: found, message: found ? "" : core.message };
  },
  curve(job, send) {
    followCurve(job, send);
  },
  block({ given, apex, from, rules }) {
    core.accept(given);
    return core.fates(apex, from, rules);
  },
};

self.addEventListener("message", async ({ data: { number, name, job } }) => {
  const send = (part) => self.postMessage({ number, part });
  try {
    self.postMessage({ number, result: await jobs[name](job, send) });
  } catch (problem) {
    self.postMessage({ number, problem: String(problem.message ?? problem) });
  }
});
