/**
 * The run in numbers, and in a sentence for who does not see it.
 * @module
 */
import { hipPhases } from "./data.js";
import { Numbers } from "./gait_panel.js";
import { MODE_TEXT } from "./legend.js";
import { digits, printed, shownWord, steady, withoutNoise } from "./numbers.js";
import { modeName } from "./run.js";

const ROWS = [
  ["time", "time", "s"],
  ["contact.mode", "contact", ""],
  ["hip.phase", "hip", ""],
  ["word", "gait word", ""],
  ["stride.count", "strides", ""],
  ["stride.speed", "speed", "m/s"],
  ["stride.cost_of_transport", "cost of transport", ""],
  ["stride.slip_distance", "slip in a stride", "m"],
];
const OF_A_STRIDE = ["stride.speed", "stride.cost_of_transport", "stride.slip_distance"];
const FAST = 0.3; // s; with a shorter sqrt(m/k) time needs more decimals

export class Readout {
  /** @param {HTMLElement} list A dl. */
  constructor(list) {
    this.numbers = new Numbers(list, ROWS);
  }

  /** @param {Run} run */
  show(run) {
    const { outputs, time, word } = run;
    const mode = modeName(outputs["contact.mode"]);
    const phase = hipPhases[outputs["hip.phase"]].name;
    const strides = outputs["stride.count"];
    this.numbers.show("time", time, steady(time, run.core.timeScale < FAST ? 2 : 1));
    this.numbers.show("contact.mode", run.fallen ? "fallen" : mode, contactText(run));
    this.numbers.show("hip.phase", phase, phase);
    this.numbers.show("word", word, shownWord(word));
    this.numbers.show("stride.count", strides, String(strides));
    for (const name of OF_A_STRIDE) {
      const scale = name === "stride.slip_distance" ? outputs["stride.length"] : 0;
      this.numbers.show(name, outputs[name], strides ? digits(withoutNoise(outputs[name], scale)) : "–");
    }
  }
}

/** Contact of the foot; a runner that has fallen has none of a gait's. */
const contactText = ({ fallen, outputs }) => (fallen ? "fallen" : MODE_TEXT[modeName(outputs["contact.mode"])]);

/** What there is to see, in words. */
export function described(run) {
  const { outputs } = run;
  const force = Math.hypot(outputs["contact.fx"], outputs["contact.fy"]);
  const com = `${digits(outputs["com.y"], 3)} ${printed("m")} high, ${digits(outputs["com.vx"], 3)} ${printed("m/s")}`;
  return `${contactText(run)}; centre of mass ${com}; ground force ${digits(force, 3)} ${printed("N")}`;
}
