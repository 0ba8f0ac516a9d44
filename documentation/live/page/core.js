/**
 * The C core, compiled to WebAssembly: its functions, and the arrays through which numbers go in and out. Every number
 * of physics on this page comes from here.
 * @module
 */
import { outputs, starts, values } from "./data.js";

/** How an advance ends, as tdmf_outcome has it. */
export const ARRIVED = 0;
export const FELL = 1;

/** What a sample of a run has, in this order. */
const SAMPLE = ["time", "footX", "velocity", "tangential", "normal", "mode"];

const SECTION = 6;

/** The core needs nothing of a system but a number for checking its stack. */
const system = (memory) => ({
  random_get: (address, size) => {
    crypto.getRandomValues(new Uint8Array(memory().buffer, address, size));
    return 0;
  },
});

/** @returns {Promise<WebAssembly.Module>} The module beside this file; workers are handed it. */
export async function compileCore() {
  const answer = await fetch(new URL("live_core.wasm", import.meta.url));
  if (!answer.ok) {
    throw new Error(`live_core.wasm: ${answer.status} ${answer.statusText}`);
  }
  return WebAssembly.compile(await answer.arrayBuffer());
}

/** One instance: a runner with its values, its run, its gait. */
export class Core {
  /** @param {WebAssembly.Module} module Of compileCore. */
  static async of(module) {
    let exports = null;
    const imports = { wasi_snapshot_preview1: system(() => exports.memory) };
    const instance = await WebAssembly.instantiate(module, imports);
    exports = instance.exports;
    exports._initialize?.();
    return new Core(exports);
  }

  constructor(exports) {
    this.exports = exports;
    if (exports.live_value_count() !== values.length || exports.live_output_count() !== outputs.length) {
      throw new Error("live_core.wasm and data.js are of different builds; please reload the page");
    }
  }

  /** A view of doubles in the core's memory, good until the next call. */
  doubles(address, count) {
    return new Float64Array(this.exports.memory.buffer, address, count);
  }

  /** A text in the core's memory. */
  text(address) {
    const bytes = new Uint8Array(this.exports.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  /** What the last call refused, or why it failed; else empty. */
  get message() {
    return this.text(this.exports.live_message());
  }

  /**
   * Takes parameters and inputs by name; where one is refused, nothing changes.
   * @param {Object<string, number>} given All of them, in the units of the model description.
   * @returns {boolean} Accepted; else `message` says why not.
   */
  accept(given) {
    const array = this.doubles(this.exports.live_values(), values.length);
    values.forEach(({ name }, i) => (array[i] = given[name]));
    return Boolean(this.exports.live_accept());
  }

  /** Begins a run from states by name; where it is refused, the run before stays. */
  start(given) {
    this.putState(given);
    return Boolean(this.exports.live_start());
  }

  putState(given) {
    const array = this.doubles(this.exports.live_state(), starts.length);
    starts.forEach(({ name }, i) => (array[i] = given[name]));
  }

  /** The run goes on with the values accepted last. */
  goOn() {
    this.exports.live_go_on();
  }

  /**
   * Advances the run.
   * @param {number} until s.
   * @param {number} interval s, between samples on the ground.
   * @param {boolean} [toEvent] Stop after the first event.
   * @returns {{outcome: number, samples: Object<string, number>[]}} With what SAMPLE names.
   */
  advance(until, interval, toEvent = false) {
    const outcome = this.exports.live_advance(until, interval, toEvent ? 1 : 0);
    const count = this.exports.live_sample_count();
    const width = SAMPLE.length;
    const all = this.doubles(this.exports.live_samples(), count * width);
    const samples = Array.from({ length: count }, (_, i) =>
      Object.fromEntries(SAMPLE.map((name, k) => [name, all[i * width + k]])),
    );
    return { outcome, samples };
  }

  /** @returns {Object<string, number>} The run's outputs at this instant, by name. */
  read() {
    this.exports.live_read();
    return this.named();
  }

  named() {
    const array = this.doubles(this.exports.live_outputs(), outputs.length);
    return Object.fromEntries(outputs.map(({ name }, i) => [name, array[i]]));
  }

  get time() {
    return this.exports.live_time();
  }

  /** The ground that is in force: y = height + x tan(slope). */
  get ground() {
    return { height: this.exports.live_ground_height(), slope: this.exports.live_ground_slope() };
  }

  /** sqrt(m/k), s. */
  get timeScale() {
    return this.exports.live_time_scale();
  }

  /** The gait word of the last completed stride. */
  get word() {
    return this.text(this.exports.live_word());
  }

  /** The gait word of the stride under way; a contact is in it once it is over. */
  get openWord() {
    return this.text(this.exports.live_open_word());
  }

  get section() {
    return Array.from(this.doubles(this.exports.live_section(), SECTION));
  }

  set section(apex) {
    this.doubles(this.exports.live_section(), SECTION).set(apex);
  }

  /** Scales of the section's coordinates. */
  get sectionScales() {
    return Array.from(this.doubles(this.exports.live_section_scales(), SECTION));
  }

  /** The states at an apex, by name. */
  stateAt(apex) {
    this.section = apex;
    this.exports.live_state_at_section();
    const array = this.doubles(this.exports.live_state(), starts.length);
    return Object.fromEntries(starts.map(({ name }, i) => [name, array[i]]));
  }

  /** The apex that has the height, the speed and the leg of states by name. */
  apexOf(given) {
    this.putState(given);
    this.exports.live_section_at_state();
    return this.section;
  }

  /** Strides from an apex: how many closed, and the last apex. */
  settle(apex, strides) {
    this.section = apex;
    const closed = this.exports.live_settle(strides);
    return { closed, apex: this.section };
  }

  /**
   * The gait near an apex, by Newton's method.
   * @returns {?Gait} null where there is none: `message` says why.
   * @typedef {{apex: number[], word: string, stride: Object<string, number>, eigenvalues: number[][]}} Gait
   */
  gaitNear(apex) {
    this.section = apex;
    if (!this.exports.live_find_gait()) {
      return null;
    }
    const pairs = this.doubles(this.exports.live_gait_eigenvalues(), 2 * SECTION);
    const eigenvalues = Array.from({ length: SECTION }, (_, i) => [pairs[2 * i], pairs[2 * i + 1]]);
    const word = this.text(this.exports.live_gait_word());
    const named = Object.entries(this.named()).filter(([name]) => name.startsWith("stride."));
    return { apex: this.section, word, stride: Object.fromEntries(named), eigenvalues };
  }

  /**
   * Fates of runners that may settle on a gait.
   * @param {number[]} apex Apex of the gait.
   * @param {number[][]} from Apices to start from.
   * @param {{tolerance: number, distance: number, strides: number}} rules When a runner has settled.
   * @returns {Int32Array} Two to a start: its fate, and the strides until then.
   */
  fates(apex, from, rules) {
    const capacity = this.exports.live_block_capacity();
    const found = new Int32Array(2 * from.length);
    this.section = apex;
    for (let first = 0; first < from.length; first += capacity) {
      const block = from.slice(first, first + capacity);
      this.doubles(this.exports.live_starts(), block.length * SECTION).set(block.flat());
      if (!this.exports.live_run_block(block.length, rules.tolerance, rules.distance, rules.strides)) {
        throw new Error("the ensemble engine found no memory");
      }
      const fates = new Int32Array(this.exports.memory.buffer, this.exports.live_fates(), 2 * block.length);
      found.set(fates, 2 * first);
    }
    return found;
  }
}
