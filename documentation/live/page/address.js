/**
 * The page's state in its address: what differs from the defaults, by the unit's names, as in
 * `live.html#ground.friction=0.3&hip.kp=0.2`.
 * @module
 */
import { starts, values } from "./data.js";

const known = new Map([...values, ...starts].map((variable) => [variable.name, variable]));

/** The defaults of parameters, inputs and start, by name. */
export function defaults() {
  return Object.fromEntries([...known.values()].map(({ name, start }) => [name, start]));
}

/**
 * What an address says.
 * @param {string} hash With or without its #.
 * @returns {{state: Object<string, number>, problem: string}} The defaults, and over them what was understood.
 */
export function stateOf(hash) {
  const state = defaults();
  const problems = [];
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (!known.has(name)) {
      problems.push(`${name} in the address is no parameter, input or start value of the runner.`);
    } else {
      state[name] = text.trim() === "" ? NaN : Number(text);
    }
  }
  return { state, problem: problems.join(" ") };
}

/** Whether an address says anything of a runner; else it names a place on the page. */
export function hasState(hash) {
  return hash.length < 2 || hash.includes("=");
}

/** The address of a state. */
export function hashOf(state) {
  const pairs = [...known.values()]
    .filter(({ name, start }) => state[name] !== start)
    .map(({ name }) => `${name}=${state[name]}`);
  return pairs.length ? `#${pairs.join("&")}` : "";
}
