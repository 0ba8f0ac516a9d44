/**
 * The cards of the gait: its numbers, its curve against friction, its region of attraction.
 * @module
 */
import { differences } from "./address.js";
import { FrictionPlot } from "./friction_plot.js";
import { GaitPanel, lambdaMax } from "./gait_panel.js";
import { FRICTION } from "./gaits.js";
import { $, announce, guarded } from "./messages.js";
import { digits, printed, shownWord } from "./numbers.js";
import { Region } from "./region.js";
import { GaitSearch } from "./search.js";

const PAINT_DELAY = 600; // ms
const REGION_HINT = $("region-hint").textContent;
const FRICTION_HINT = $("friction-hint").textContent;
const NO_GAIT = "There is no gait.";

export class GaitCards {
  /**
   * @param {{painters: Pool, searchers: Pool}} pools
   * @param {Core} core
   * @param {PageState} state Has the runner whose gait it is.
   * @param {function(number): void} setFriction
   * @param {function(number[]): void} startFrom Is handed an apex.
   */
  constructor({ painters, searchers }, core, state, setFriction, startFrom) {
    this.painters = painters;
    this.state = state;
    this.panel = new GaitPanel($("gait"), $("circle"), $("eigenvalues"));
    this.frictionPlot = new FrictionPlot($("friction"), setFriction);
    const selects = { rows: $("region-rows"), columns: $("region-columns"), points: $("region-points") };
    this.region = new Region(
      { ...selects, canvas: $("region"), width: $("region-width"), legend: $("region-legend") },
      core,
      startFrom,
    );
    this.search = new GaitSearch(searchers, () => state.runner, {
      found: (gait, message) => this.show(gait, message),
      point: (friction, gait) => this.frictionPlot.add(friction, gait),
      cleared: () => this.clear(),
    });
  }

  /** @param {boolean} [aloud] Whether a screen reader reads out what is found: it was asked for. */
  async find(aloud = true) {
    this.aloud = aloud;
    $("gait-hint").textContent = "Looking for the gait …";
    await guarded(() => this.search.find());
  }

  show(gait, message) {
    this.panel.show(gait);
    this.mark();
    $("start-gait").disabled = !gait;
    if (gait) {
      performance.mark("gait found");
      this.paintSoon();
    } else {
      $("region-hint").textContent = this.region.map ? `${NO_GAIT} The picture is for other values of the parameters.` : NO_GAIT;
    }
    $("friction-hint").hidden = Boolean(gait);
    $("friction-hint").textContent = NO_GAIT;
    const text = gait ? gaitText(gait) : withChanges(message, this.state.values);
    $("gait-hint").textContent = text;
    if (this.aloud) {
      announce(text);
    }
  }

  clear() {
    this.panel.show(null);
    this.frictionPlot.clear();
    $("start-gait").disabled = true;
    $("friction-hint").hidden = false;
    $("friction-hint").textContent = FRICTION_HINT;
    $("gait-hint").textContent = "Newton’s method looks for the gait once the runner has settled.";
  }

  /** The present friction, and the gait if there is one, on the curve. */
  mark() {
    this.frictionPlot.mark(this.state.values[FRICTION], this.search.gait);
  }

  /** The runner is another: its gait is looked for, and its region painted. */
  renew() {
    this.search.forget();
    this.search.wanted = true;
    this.outdate();
    this.find(false);
  }

  /** A parameter or an input is another: a gait that was asked for is looked for again. */
  changed(name) {
    this.aloud = true;
    if (name === FRICTION) {
      this.search.frictionChanged();
    } else {
      this.search.changed();
    }
    this.outdate();
  }

  /** Once the runner has been left as it is for a moment. */
  paintSoon() {
    clearTimeout(this.soon);
    this.soon = setTimeout(() => this.paint(), PAINT_DELAY);
  }

  /** The painted region is not this runner's. */
  outdate() {
    const { map } = this.region;
    this.region.outdate();
    $("region-hint").textContent = map ? "The picture is for other values of the parameters. It is painted again when the new gait is found." : REGION_HINT;
  }

  paint() {
    clearTimeout(this.soon);
    return guarded(async () => {
      if (!this.search.gait) {
        $("region-hint").textContent = "Waiting for the gait …";
        await this.find();
        clearTimeout(this.soon);
      }
      const { gait } = this.search;
      if (!gait || lambdaMax(gait) >= 1) {
        $("region-hint").textContent = gait ? "The gait is unstable, so no start settles on it." : NO_GAIT;
        return;
      }
      $("region-hint").textContent = "Painting …";
      if (await this.region.paint(this.painters, this.state.runner.given, gait)) {
        const share = digits(100 * this.region.settledShare, 3);
        $("region-hint").textContent = `${share} % of these starts settle on the gait.`;
      }
    });
  }

  redraw() {
    this.panel.drawCircle();
    this.frictionPlot.draw();
    this.region.redraw();
  }
}

/** Why there is no gait, and what differs from the runner of the defaults, which has one. */
function withChanges(message, given) {
  const changed = differences(given);
  return changed.length ? `${message} With ${changed.join(", ")}.` : message;
}

/** A gait in a sentence. */
function gaitText(gait) {
  const stability = lambdaMax(gait) < 1 ? "stable" : "unstable";
  const speed = `speed ${digits(gait.stride["stride.speed"])} ${printed("m/s")}`;
  return `Gait ${shownWord(gait.word)}, ${stability}: ${speed}, largest eigenvalue ${digits(lambdaMax(gait))}.`;
}
