/**
 * The values of the page, each accepted by the core before it counts; the address follows them.
 * @module
 */
import { defaults, hashOf, stateOf } from "./address.js";
import { starts, values } from "./data.js";
import { inShownUnits } from "./numbers.js";

const FIXED = new Set(values.filter(({ variability }) => variability === "fixed").map(({ name }) => name));
const STARTS = new Set(starts.map(({ name }) => name));
const ADDRESS_DELAY = 250; // ms; browsers limit how often an address may change

export const isStart = (name) => STARTS.has(name);

/** Of a runner's values those at which it starts. */
export const startOf = (state) => Object.fromEntries(Object.entries(state).filter(([name]) => isStart(name)));

export class PageState {
  constructor(core, run) {
    this.core = core;
    this.run = run;
    this.values = defaults();
    /** The friction of who races against the runner; null where nobody does. */
    this.rival = null;
  }

  /** @returns {{problem: string, rival: ?number}} Why the state of the address, or a part of it, was refused; else empty. */
  readAddress() {
    const { state, rival, problem } = stateOf(location.hash);
    const refused = this.startAt(state);
    if (refused && !this.run.outputs) {
      this.startAt(defaults());
    }
    return { problem: [problem, refused].filter(Boolean).join(" "), rival };
  }

  /** A new run with these values; where they are refused, all stays as it is, and a sentence is given. */
  startAt(state) {
    const before = this.values;
    if (!this.core.accept(state)) {
      return inShownUnits(this.core.message);
    }
    if (!this.run.restart(state)) {
      const { message } = this.core;
      this.core.accept(before);
      return inShownUnits(message);
    }
    this.values = { ...state };
    this.writeAddress();
    return "";
  }

  /** One value is another from now on; the run goes on, but for a start value, which begins a new one. */
  set(name, value) {
    const next = { ...this.values, [name]: value };
    if (isStart(name)) {
      return this.startAt(next);
    }
    if (!this.core.accept(next)) {
      return inShownUnits(this.core.message);
    }
    this.values = next;
    this.run.change(FIXED.has(name)); // of these changes the energy ledger knows nothing
    this.writeAddress();
    return "";
  }

  /** Who runs: parameters and inputs, and the apex of its start. */
  get runner() {
    const given = Object.fromEntries(Object.entries(this.values).filter(([name]) => !isStart(name)));
    return { given, apex: this.core.apexOf(this.values) };
  }

  /** Soon, unless somebody goes elsewhere on the page until then. */
  writeAddress() {
    const { hash } = location;
    clearTimeout(this.writing);
    this.writing = setTimeout(() => {
      if (location.hash === hash) {
        history.replaceState(null, "", this.link);
      }
    }, ADDRESS_DELAY);
  }

  /** The address of this state. */
  get link() {
    return location.pathname + location.search + hashOf(this.values, this.rival);
  }
}
