/**
 * The energy ledger's bars: what went into the runner in this stride, what was lost, what is left over.
 * @module
 */
import { digits } from "./numbers.js";
import { LOSSES, SUPPLIES } from "./run.js";

const TEXT = {
  "hip.work": "work of the hip",
  "leg.work": "work of the leg",
  "energy.external_work": "work from outside",
  "energy.damper_loss": "lost in the damper",
  "energy.friction_loss": "lost to friction",
  "energy.impact_loss": "lost in impacts",
  "energy.total": "change of energy",
};
const COLOURS = { "energy.damper_loss": "--stick", "energy.friction_loss": "--slip_positive",
  "energy.impact_loss": "--slip_negative", "energy.total": "--soft" };

export class EnergyBars {
  /** @param {HTMLElement} parent Filled with a row for each entry. */
  constructor(parent) {
    this.rows = [...SUPPLIES, ...LOSSES, "energy.total"].map((name) => {
      const row = document.createElement("div");
      row.className = "bar";
      const label = document.createElement("span");
      label.textContent = TEXT[name] ?? name;
      const track = document.createElement("span");
      track.className = "track";
      const bar = document.createElement("i");
      bar.style.background = `var(${COLOURS[name] ?? "--second"})`;
      const last = document.createElement("i");
      last.className = "last";
      track.append(bar, last);
      const value = document.createElement("output");
      value.setAttribute("aria-live", "off");
      row.append(label, track, value);
      parent.append(row);
      return { name, bar, last, value };
    });
  }

  /** @param {Run} run */
  draw(run) {
    const { ledger, lastLedger } = run;
    const all = [...Object.values(ledger), ...Object.values(lastLedger ?? {})].map(Math.abs);
    const most = Math.max(...all, Number.MIN_VALUE);
    for (const { name, bar, last, value } of this.rows) {
      bar.style.width = `${(100 * Math.abs(ledger[name])) / most}%`;
      last.hidden = !lastLedger;
      last.style.width = `${(100 * Math.abs(lastLedger?.[name] ?? 0)) / most}%`;
      value.value = `${digits(ledger[name], 3)} J`;
    }
  }
}
