/**
 * View of a run: the scene, the plots of the stance, the energy bars, the numbers.
 * @module
 */
import { EnergyBars } from "./energy_bars.js";
import { fillLegend } from "./legend.js";
import { $, announce } from "./messages.js";
import { Now } from "./now.js";
import { digits } from "./numbers.js";
import { described, Readout } from "./readout.js";
import { Scene } from "./scene.js";
import { StancePlots } from "./stance_plots.js";

const NUMBERS_EVERY = 120; // ms, while it runs

export class RunView {
  /**
   * @param {Run} run
   * @param {PageState} state Whose values tell of the runner's size and of the ground.
   * @param {Race} race
   */
  constructor(run, state, race) {
    this.race = race;
    this.run = run;
    this.state = state;
    const redraw = () => run.outputs && this.draw();
    this.scene = new Scene($("scene"), redraw);
    this.plots = new StancePlots($("velocity"), $("ratio"), redraw);
    this.bars = new EnergyBars($("energy"));
    this.readout = new Readout($("numbers"));
    this.now = new Now($("now"), $("word"));
    fillLegend($("legend"));
  }

  /** All of it, as it is now. */
  draw() {
    this.drawPictures();
    this.drawNumbers();
  }

  /** One frame of many: who reads the numbers needs some time for each. */
  drawFrame() {
    this.drawPictures();
    if (performance.now() - (this.written ?? 0) > NUMBERS_EVERY) {
      this.drawNumbers();
    }
  }

  drawPictures() {
    this.scene.draw(this.run, this.state.values, this.race.on ? this.race : null);
    this.plots.draw(this.run, this.state.values);
    this.now.show(this.run);
  }

  drawNumbers() {
    this.written = performance.now();
    this.bars.draw(this.run);
    this.readout.show(this.run);
  }

  /** The present numbers, for a screen reader: when something was asked for, not at every frame. */
  tell() {
    $("scene").setAttribute("aria-label", `The runner: ${described(this.run)}`);
    announce(`Time ${digits(this.run.time)} s: ${described(this.run)}`);
  }
}
