/**
 * The live page: puts its parts together and runs them, frame by frame.
 * @module
 */
import { Controls, fillPresets } from "./controls.js";
import { compileCore, Core } from "./core.js";
import { defaults, hasState } from "./address.js";
import { EnergyBars } from "./energy_bars.js";
import { FrictionPlot } from "./friction_plot.js";
import { FRICTION } from "./gaits.js";
import { GaitPanel, lambdaMax } from "./gait_panel.js";
import { listenToKeys } from "./keys.js";
import { digits, shownWord } from "./numbers.js";
import { changesAtTouchdown, paceOf } from "./pace.js";
import { isStart, PageState } from "./page_state.js";
import { Pool, processors } from "./pool.js";
import { described, Readout } from "./readout.js";
import { apexText, Region } from "./region.js";
import { Run } from "./run.js";
import { fillLegend, Scene } from "./scene.js";
import { GaitSearch } from "./search.js";
import { StancePlots } from "./stance_plots.js";
import { watchTheme } from "./theme.js";

const LONGEST_FRAME = 0.05; // s; after a pause of the browser nothing is made up for
const STEP = 0.01; // sqrt(m/k)
const NEXT_EVENT_WITHIN = 100; // sqrt(m/k)
const NUMBERS_EVERY = 120; // ms, while it runs
const FRAMES_KEPT = 600;
const SEARCHERS = 2; // a gait's curve goes both ways

const $ = (id) => document.getElementById(id);

class Page {
  constructor(core, painters, searchers) {
    this.core = core;
    this.painters = painters;
    this.run = new Run(core);
    this.state = new PageState(core, this.run);
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.frames = [];
    const redraw = () => this.run.outputs && this.draw();
    this.scene = new Scene($("scene"), redraw);
    this.plots = new StancePlots($("velocity"), $("ratio"), redraw);
    this.bars = new EnergyBars($("energy"));
    this.readout = new Readout($("numbers"));
    this.gaitPanel = new GaitPanel($("gait"), $("circle"), $("eigenvalues"));
    this.frictionPlot = new FrictionPlot($("friction"), (friction) => this.set(FRICTION, friction));
    this.controls = new Controls($("controls"), (name, value) => this.set(name, value));
    const selects = { rows: $("region-rows"), columns: $("region-columns"), points: $("region-points") };
    this.region = new Region(
      { ...selects, canvas: $("region"), width: $("region-width"), legend: $("region-legend") },
      (apex) => this.startFrom(apex),
    );
    this.search = new GaitSearch(searchers, () => this.runner(), {
      found: (gait, message) => this.showGait(gait, message),
      point: (friction, gait) => this.frictionPlot.add(friction, gait),
      cleared: () => this.clearGait(),
    });
    this.listen();
  }

  listen() {
    fillLegend($("legend"));
    fillPresets($("preset"), (preset) => this.choose(preset));
    const actions = {
      play: () => (this.run.over ? this.begin(this.state.values) : this.play(!this.running)),
      step: () => this.step(() => this.run.advance(STEP * this.core.timeScale)),
      "step-event": () => this.step(() => this.run.advanceToEvent(NEXT_EVENT_WITHIN * this.core.timeScale)),
      restart: () => this.begin(this.state.values),
      find: () => this.find(),
      "start-gait": () => this.startFrom(this.search.gait.apex),
      paint: () => this.paint(),
      defaults: () => this.choose({ name: "defaults", values: {} }),
      link: () => this.copyLink(),
    };
    Object.entries(actions).forEach(([id, action]) => $(id).addEventListener("click", action));
    $("scene").addEventListener("click", actions.play);
    addEventListener("hashchange", () => hasState(location.hash) && this.readAddress());
    watchTheme($("theme"), () => this.redrawAll());
    listenToKeys({
      " ": actions.play,
      ".": actions.step,
      e: actions["step-event"],
      r: actions.restart,
      g: actions.find,
      p: () => this.nextPace(),
      "[": () => this.scaleFriction(1 / 1.05),
      "]": () => this.scaleFriction(1.05),
    });
  }

  /** Reads the address, shows the state, lets the runner run. */
  open() {
    this.readAddress();
    for (const id of ["play", "step", "step-event", "restart", "find", "paint"]) {
      $(id).disabled = false;
    }
    requestAnimationFrame((now) => this.frame(now));
  }

  readAddress() {
    this.report(this.state.readAddress());
    this.controls.centre(this.state.values);
    this.afterStart();
  }

  // ---- values ---------------------------------------------------------------------------------------------------

  /** One control's value; where it is refused, the page says so and goes on as before. */
  set(name, value) {
    const problem = this.state.set(name, value);
    this.report(problem);
    if (problem) {
      this.controls.refuse(name);
      return;
    }
    if (isStart(name)) {
      this.afterStart();
    } else if (name === FRICTION) {
      this.search.frictionChanged();
    } else {
      this.search.changed();
      this.region.clear();
    }
    this.showValues();
  }

  scaleFriction(factor) {
    this.set(FRICTION, Number((this.state.values[FRICTION] * factor).toPrecision(4)));
  }

  showValues() {
    this.controls.show(this.state.values);
    this.frictionPlot.mark(this.state.values[FRICTION], this.search.gait);
    this.draw();
  }

  choose(preset) {
    const state = { ...defaults(), ...preset.values };
    this.controls.centre(state);
    if (preset.apex && this.core.accept(state)) {
      Object.assign(state, this.core.stateAt(preset.apex));
    }
    this.begin(state);
    this.announce(`Preset: ${preset.name}`);
  }

  /** A new run. */
  begin(state) {
    const problem = this.state.startAt(state);
    this.report(problem);
    if (!problem) {
      this.afterStart();
      this.play(true);
    }
  }

  /** A new run of the same runner, from an apex. */
  startFrom(apex) {
    this.begin({ ...this.state.values, ...this.core.stateAt(apex) });
    this.announce(`The runner starts from ${apexText(apex)}`);
  }

  /** A gait that was found stays if the runner is the same. */
  afterStart() {
    const given = JSON.stringify(this.runner().given);
    if (given !== this.startedWith) {
      this.startedWith = given;
      this.search.forget();
      this.search.wanted = false;
      this.region.clear();
    }
    this.showValues();
  }

  /** Who runs: parameters and inputs, and the apex of its start. */
  runner() {
    const given = Object.fromEntries(Object.entries(this.state.values).filter(([name]) => !isStart(name)));
    return { given, apex: this.core.apexOf(this.state.values) };
  }

  report(problem) {
    $("problem").textContent = problem;
    $("problem").hidden = !problem;
  }

  announce(text) {
    $("announcement").textContent = text;
  }

  async copyLink() {
    history.replaceState(null, "", this.state.link);
    try {
      await navigator.clipboard.writeText(location.href);
      this.announce("The link was copied");
      $("link").textContent = "Copied";
    } catch {
      $("link").textContent = "It is in the address";
    }
    setTimeout(() => ($("link").textContent = "Copy a link"), 2000);
  }

  // ---- the gait -------------------------------------------------------------------------------------------------

  async find() {
    $("gait-hint").textContent = "Looking for the gait …";
    await this.guarded(() => this.search.find());
  }

  showGait(gait, message) {
    this.gaitPanel.show(gait);
    this.frictionPlot.mark(this.state.values[FRICTION], gait);
    $("start-gait").disabled = !gait;
    $("friction-hint").hidden = Boolean(gait);
    const text = gait ? gaitText(gait) : message;
    $("gait-hint").textContent = text;
    this.announce(text);
  }

  clearGait() {
    this.gaitPanel.show(null);
    this.frictionPlot.clear();
    $("start-gait").disabled = true;
    $("friction-hint").hidden = false;
    $("gait-hint").textContent = "Newton’s method on the return map, from where the runner settles.";
  }

  async paint() {
    await this.guarded(async () => {
      if (!this.search.gait) {
        await this.find();
      }
      const { gait } = this.search;
      if (!gait || lambdaMax(gait) >= 1) {
        $("region-hint").textContent = gait ? "The gait is unstable: it attracts nothing." : "There is no gait.";
        return;
      }
      const { given } = this.runner();
      $("region-hint").textContent = "Painting …";
      const done = await this.region.paint(this.painters, given, gait, this.core.sectionScales, () => {});
      if (done) {
        const share = digits(100 * this.region.settledShare, 3);
        $("region-hint").textContent = `${share} % of these starts settle on the gait.`;
      }
    });
  }

  /** What goes wrong where nobody expects it is told, too, and the page goes on to answer. */
  async guarded(work) {
    try {
      await work();
    } catch (problem) {
      this.running = false;
      this.report(`Something went wrong: ${problem.message ?? problem}`);
      console.error(problem);
    }
  }

  // ---- frames ---------------------------------------------------------------------------------------------------

  play(running) {
    this.running = running && !this.run.over;
    $("play").textContent = this.running ? "Pause" : this.run.over ? "Run again" : "Run";
    if (!this.running && !this.run.over) {
      this.tell();
    }
  }

  step(advance) {
    this.play(false);
    advance();
    this.noticeEnd();
    this.draw();
    if (!this.run.over) {
      this.tell();
    }
  }

  nextPace() {
    const { options, selectedIndex } = $("pace");
    $("pace").selectedIndex = (selectedIndex + 1) % options.length;
  }

  frame(now) {
    const before = performance.now();
    const elapsed = Math.min((now - (this.last ?? now)) / 1000, LONGEST_FRAME);
    this.last = now;
    requestAnimationFrame((next) => this.frame(next));
    if (this.running) {
      this.guarded(() => {
        this.advance(elapsed);
        this.draw();
      });
      this.keepFrame(performance.now() - before);
    }
  }

  /** In slow motion on the ground only, flight ends at touchdown. */
  advance(elapsed) {
    const pace = $("pace").value;
    const duration = paceOf(pace, this.run) * elapsed;
    if (changesAtTouchdown(pace)) {
      this.run.advanceToEvent(duration);
    } else {
      this.run.advance(duration);
    }
    this.noticeEnd();
  }

  noticeEnd() {
    if (this.run.over) {
      this.play(false);
      this.report(this.run.trouble);
      this.announce(this.run.trouble || "The runner fell.");
    }
  }

  keepFrame(duration) {
    this.frames.push(duration);
    this.frames.splice(0, this.frames.length - FRAMES_KEPT);
  }

  draw() {
    this.scene.draw(this.run, this.state.values);
    this.plots.draw(this.run, this.state.values);
    const now = performance.now();
    if (!this.running || now - (this.told ?? 0) > NUMBERS_EVERY) {
      this.told = now;
      this.bars.draw(this.run);
      this.readout.show(this.run);
    }
  }

  /** The present numbers, for a screen reader: when something was asked for, not at every frame. */
  tell() {
    $("scene").setAttribute("aria-label", `The runner: ${described(this.run)}`);
    this.announce(`Time ${digits(this.run.time)} s: ${described(this.run)}`);
  }

  redrawAll() {
    this.draw();
    this.gaitPanel.drawCircle();
    this.frictionPlot.draw();
    if (this.region.map) {
      this.region.map.image = null;
    }
    this.region.draw();
  }
}

/** A gait in a sentence. */
function gaitText(gait) {
  const stability = lambdaMax(gait) < 1 ? "stable" : "unstable";
  const speed = `speed ${digits(gait.stride["stride.speed"])} m/s`;
  return `Gait ${shownWord(gait.word)}, ${stability}: ${speed}, largest eigenvalue ${digits(lambdaMax(gait))}.`;
}

async function main() {
  try {
    const module = await compileCore();
    const painters = new Pool(module, processors());
    const searchers = new Pool(module, SEARCHERS);
    const page = new Page(await Core.of(module), painters, searchers);
    await Promise.all([painters.ready, searchers.ready]);
    /** For scripts and tests: the page as it is. */
    globalThis.tdmfSlip = page;
    $("loading").hidden = true;
    page.open();
  } catch (problem) {
    $("problem").textContent = `The page could not start: ${problem.message ?? problem}`;
    $("problem").hidden = false;
    throw problem;
  }
}

main();
