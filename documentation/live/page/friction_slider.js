/**
 * The slider beside the runner: the friction, over the range of figure 9.
 * @module
 */
import { HIGH, LOW } from "./friction_plot.js";
import { FRICTION } from "./gaits.js";
import { digits } from "./numbers.js";

const STEPS = 1000;

export class FrictionSlider {
  /**
   * @param {HTMLInputElement} slider
   * @param {HTMLOutputElement} output
   * @param {function(number): void} changed
   */
  constructor(slider, output, changed) {
    Object.assign(this, { slider, output });
    Object.assign(slider, { min: 0, max: STEPS, step: 1 });
    slider.addEventListener("input", () => {
      changed(Number((LOW * (HIGH / LOW) ** (Number(slider.value) / STEPS)).toPrecision(3)));
    });
  }

  /** @param {Object<string, number>} values */
  show(values) {
    const friction = values[FRICTION];
    const share = Math.log(friction / LOW) / Math.log(HIGH / LOW);
    this.slider.value = STEPS * Math.max(0, Math.min(1, share));
    this.output.value = digits(friction);
    this.slider.setAttribute("aria-valuetext", digits(friction));
  }
}
