/**
 * The page's state in its address: what differs from the defaults, by the unit's names, as in
 * `live.html#ground.friction=0.3&hip.touchdown_angle=45deg`, or by short names as in `live.html#friction=0.3`; a number
 * without a unit is in the variable's own.
 * `race=10` is no value of the runner: it races against one at friction 10.
 * @module
 */
import { aliases, displayUnits, starts, values } from "./data.js";
import { numberIn, shownValue } from "./numbers.js";

const known = new Map([...values, ...starts].map((variable) => [variable.name, variable]));

const RACE = "race";
const DIGITS = [4, 7, 12, 14, 15, 16, 17]; // tried in turn

/** The defaults of parameters, inputs and start, by name. */
export function defaults() {
  return Object.fromEntries([...known.values()].map(({ name, start }) => [name, start]));
}

const FLAGS = { true: 1, false: 0, 1: 1, 0: 0 };

/** Inverse of written; not a number where it is none. */
function read({ unit, isFlag }, text) {
  if (isFlag) {
    return FLAGS[text.trim()] ?? NaN;
  }
  const shown = displayUnits[unit];
  const number = shown && text.endsWith(shown.name) ? text.slice(0, -shown.name.length).trim() : text;
  return number.trim() === "" ? NaN : Number(number) / (number === text ? 1 : shown.factor);
}

/** A value in the unit of its field, in as few digits as give it back; else in the variable's own unit. */
function written(variable, value) {
  const { unit, isFlag } = variable;
  if (isFlag) {
    return shownValue(variable, value);
  }
  const shown = displayUnits[unit];
  const numbers = shown ? DIGITS.map((count) => Number((value * shown.factor).toPrecision(count))) : [];
  const exact = numbers.find((number) => number / shown.factor === value);
  return exact === undefined ? String(value) : `${exact}${shown.name}`;
}

/**
 * Reads the state that an address holds.
 * @param {string} hash With or without its #.
 * @returns {{state: Object<string, number>, rival: ?number, problem: string}} The defaults, and over them what was
 *   understood; the friction of a rival, or null.
 */
export function stateOf(hash) {
  const state = defaults();
  const problems = [];
  let rival = null;
  for (const [given, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    const name = aliases[given] ?? given;
    if (name === RACE) {
      rival = numberIn(text);
    } else if (!known.has(name)) {
      problems.push(`${name} in the address is no parameter, input or start value of the runner.`);
    } else if (known.get(name).isFlag && Number.isNaN(read(known.get(name), text))) {
      problems.push(`${name} = ${text} in the address is refused: allowed are true and false.`);
    } else {
      state[name] = read(known.get(name), text);
    }
  }
  return { state, rival, problem: problems.join(" ") };
}

/** Whether an address says anything of a runner; else it names a place on the page. */
export function hasState(hash) {
  return hash.length < 2 || hash.includes("=");
}

/** What differs from the defaults, as the fields show it, for a sentence. */
export function differences(state) {
  return values
    .filter(({ name, start }) => state[name] !== start)
    .map((variable) => `${variable.name} = ${shownValue(variable, state[variable.name])}`);
}

/** The address of a state, and of a race against another friction. */
export function hashOf(state, rival = null) {
  const pairs = [...known.values()]
    .filter(({ name, start }) => state[name] !== start)
    .map((variable) => `${variable.name}=${written(variable, state[variable.name])}`);
  if (rival !== null) {
    pairs.push(`${RACE}=${rival}`);
  }
  return pairs.length ? `#${pairs.join("&")}` : "";
}
