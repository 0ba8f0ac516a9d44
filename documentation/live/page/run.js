/**
 * The run on the page: the core's runner, what it has done in this stride and in the last, its tracks on the ground.
 * @module
 */
import { ARRIVED, FELL } from "./core.js";
import { contactModes, outputs } from "./data.js";

const SAMPLING = 0.008; // of sqrt(m/k), on the ground
const CALLS_AT_ONCE = 200; // of the core, so that no runner holds up the page
const TRACKS = 400;
const TRAIL = 700;

/** What goes into a runner and what comes out, by the outputs that add it up. */
export const SUPPLIES = ["hip.work", "leg.work", "energy.external_work"].filter((name) =>
  outputs.some((output) => output.name === name),
);
export const LOSSES = outputs.map(({ name }) => name).filter((name) => /^energy\..*_loss$/.test(name));

/** The name of a contact mode, by its number. */
export const modeName = (number) => contactModes[number].name;

/** Whether the ground bears the foot. */
export const isLoaded = (mode) => ["stick", "slip_positive", "slip_negative"].includes(modeName(mode));
export const isSlip = (mode) => modeName(mode).startsWith("slip");

/** Differences of the ledger's entries, and of the energy, from one instant to another. */
function ledger(from, to) {
  const names = [...SUPPLIES, ...LOSSES, "energy.total"];
  return Object.fromEntries(names.map((name) => [name, to[name] - from[name]]));
}

export class Run {
  /** @param {Core} core Whose runner this is. */
  constructor(core) {
    this.core = core;
    this.trouble = "";
  }

  /** Begins anew; where the start is refused, the core's message says why, and the run before goes on. */
  restart(starts) {
    if (!this.core.start(starts)) {
      return false;
    }
    Object.assign(this, { trouble: "", word: "", tracks: [], trail: [], lastLedger: null, disturbed: false });
    Object.assign(this, { stance: [], lastStance: [], touching: false, stanceIsOver: false });
    this.outputs = this.core.read();
    this.strideStart = this.outputs;
    return true;
  }

  /** The run goes on under other values. The ledger of this stride would not close, and is not shown as a whole one. */
  change(unaccounted) {
    this.core.goOn();
    this.outputs = this.core.read();
    this.disturbed ||= unaccounted;
  }

  get openWord() {
    return this.core.openWord;
  }

  get fallen() {
    return Boolean(this.outputs["status.fallen"]);
  }

  get over() {
    return this.fallen || this.trouble !== "";
  }

  get time() {
    return this.core.time;
  }

  /** Differences since the stride began. */
  get ledger() {
    return ledger(this.strideStart, this.outputs);
  }

  /** Advances by a time, s, event by event, so that what is read at an apex is of the apex. */
  advance(duration) {
    const until = this.time + duration;
    for (let i = 0; i < CALLS_AT_ONCE && !this.over && this.time < until; ++i) {
      this.advanceOnce(until, true);
    }
    this.leaveTrail();
  }

  /** Advances to the next event, but not beyond a time, s, from now. */
  advanceToEvent(most) {
    if (!this.over) {
      this.advanceOnce(this.time + most, true);
      this.leaveTrail();
    }
  }

  advanceOnce(until, toEvent) {
    const before = this.outputs;
    const { outcome, samples } = this.core.advance(until, SAMPLING * this.core.timeScale, toEvent);
    this.record(samples);
    this.outputs = this.core.read();
    if (outcome !== ARRIVED && outcome !== FELL) {
      this.trouble = this.core.message;
    }
    if (this.outputs["apex.time"] !== before["apex.time"]) {
      this.passApex(this.outputs["stride.count"] > before["stride.count"]);
    }
  }

  /** A stride ends here, if one began at an apex, and the next begins. */
  passApex(closed) {
    this.word = this.core.word;
    this.lastLedger = closed && !this.disturbed ? ledger(this.strideStart, this.outputs) : null;
    this.strideStart = this.outputs;
    this.disturbed = false;
    this.stanceIsOver = true;
  }

  record(samples) {
    for (const sample of samples) {
      const loaded = isLoaded(sample.mode);
      if (loaded) {
        this.recordContact(sample);
      }
      this.touching = loaded;
    }
  }

  recordContact(sample) {
    if (this.stanceIsOver) {
      Object.assign(this, { lastStance: this.stance, stance: [], stanceIsOver: false });
    }
    const last = this.stance.at(-1);
    const goesOn = this.touching && last?.mode === sample.mode;
    if (goesOn && isSlip(sample.mode)) {
      this.tracks.push({ from: last.footX, to: sample.footX, mode: sample.mode });
      this.tracks.splice(0, this.tracks.length - TRACKS);
    }
    this.stance.push({ ...sample, begins: !goesOn });
  }

  leaveTrail() {
    this.trail.push([this.outputs["com.x"], this.outputs["com.y"]]);
    this.trail.splice(0, this.trail.length - TRAIL);
  }
}

/** A stance in pieces of one contact mode; time counts from touchdown. */
export function pieces(stance) {
  const found = [];
  for (const sample of stance) {
    if (sample.begins) {
      found.push({ mode: sample.mode, rows: [] });
    }
    found.at(-1).rows.push({ ...sample, time: sample.time - stance[0].time });
  }
  return found;
}
