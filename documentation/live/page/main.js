/**
 * The live page: puts its parts together, and lets the runner's values and its run be changed.
 * @module
 */
import { Controls, fillPresets } from "./controls.js";
import { compileCore, Core } from "./core.js";
import { defaults, hasState } from "./address.js";
import { FrictionSlider } from "./friction_slider.js";
import { FRICTION } from "./gaits.js";
import { GaitCards } from "./gait_cards.js";
import { explainTerms } from "./glossary.js";
import { listenToKeys } from "./keys.js";
import { $, announce, report } from "./messages.js";
import { labelUnitsFor } from "./numbers.js";
import { isStart, PageState } from "./page_state.js";
import { Player } from "./player.js";
import { Pool, processors } from "./pool.js";
import { Race } from "./race.js";
import { apexText } from "./region.js";
import { Run } from "./run.js";
import { RunView } from "./run_view.js";
import { watchTheme } from "./theme.js";
import { Video } from "./video.js";

const SEARCHERS = 2; // a gait's curve goes both ways
const TOLD = 2000; // ms for which a button says what it did

class Page {
  /**
   * @param {Core[]} cores The runner's, and its rival's.
   * @param {Object<string, Pool>} pools
   */
  constructor([core, other], pools) {
    this.core = core;
    this.run = new Run(core);
    this.state = new PageState(core, this.run);
    this.race = new Race(other, pools.painters, this);
    this.view = new RunView(this.run, this.state, this.race);
    this.player = new Player(this.run, this.view);
    this.player.followers.push(() => this.race.follow());
    this.controls = new Controls($("controls"), (name, value) => this.set(name, value));
    const setFriction = (friction) => this.set(FRICTION, friction);
    this.video = new Video($("video"), $("scene"), this.run, this.player);
    this.friction = new FrictionSlider($("friction-slider"), $("friction-text"), setFriction);
    this.gaits = new GaitCards(pools, core, this.state, setFriction, (apex) => this.startFrom(apex));
    this.listen();
  }

  listen() {
    fillPresets($("preset"), (preset) => this.choose(preset));
    const actions = {
      play: () => this.playOrPause(),
      step: () => this.player.step(),
      "step-event": () => this.player.stepToEvent(),
      restart: () => this.restart(),
      find: () => this.gaits.find(),
      "start-gait": () => this.startFrom(this.gaits.search.gait.apex),
      paint: () => this.gaits.paint(),
      defaults: () => this.choose({ name: "defaults", values: {} }),
      video: () => this.video.start(),
      link: () => this.copyLink(),
    };
    Object.entries(actions).forEach(([id, action]) => $(id).addEventListener("click", action));
    $("scene").addEventListener("click", actions.play);
    addEventListener("hashchange", () => hasState(location.hash) && this.readAddress());
    $("filter").addEventListener("input", ({ target }) => this.controls.filter(target.value));
    explainTerms();
    watchTheme($("theme"), () => this.redraw());
    listenToKeys({
      " ": actions.play,
      ".": actions.step,
      e: actions["step-event"],
      r: actions.restart,
      g: actions.find,
      p: () => this.player.nextPace(),
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
    this.player.begin();
    this.player.present();
  }

  playOrPause() {
    const wanted = this.run.over || !this.player.running;
    if (this.run.over) {
      this.restart();
    }
    this.player.play(wanted);
  }

  readAddress() {
    this.race.end();
    const { problem, rival } = this.state.readAddress();
    report(problem);
    this.controls.centre(this.state.values);
    this.afterStart();
    if (rival !== null) {
      this.race.start(this.state.values[FRICTION], rival);
    }
  }

  /** One control's value; where it is refused, the page says so and goes on as before. */
  set(name, value) {
    const problem = this.state.set(name, value);
    report(problem);
    if (problem) {
      this.controls.refuse(name);
    } else if (isStart(name)) {
      this.race.end();
      this.afterStart();
    } else {
      this.race.change(this.state.values);
      this.gaits.changed(name);
      this.showValues();
    }
  }

  scaleFriction(factor) {
    this.set(FRICTION, Number((this.state.values[FRICTION] * factor).toPrecision(4)));
  }

  showValues() {
    labelUnitsFor(this.state.values);
    this.controls.show(this.state.values);
    this.friction.show(this.state.values);
    this.gaits.mark();
    this.player.tellPace();
    this.view.draw();
  }

  choose(preset) {
    const state = { ...defaults(), ...preset.values };
    this.controls.centre(state);
    if (preset.apex && this.core.accept(state)) {
      Object.assign(state, this.core.stateAt(preset.apex));
    }
    this.begin(state);
    announce(`Preset: ${preset.name}`);
  }

  /** The same run, or race, from its start. */
  restart() {
    if (this.race.on) {
      this.race.again();
    } else {
      this.begin(this.state.values);
    }
  }

  /** A new run of one runner. */
  begin(state) {
    this.race.end();
    this.beginRun(state);
  }

  beginRun(state) {
    const problem = this.state.startAt(state);
    report(problem);
    if (!problem) {
      this.afterStart();
      this.player.present();
    }
  }

  /** A new run of the same runner, from an apex. */
  startFrom(apex) {
    this.begin({ ...this.state.values, ...this.core.stateAt(apex) });
    announce(`The runner starts from ${apexText(apex)}`);
  }

  /** A gait that was found stays if the runner is the same. */
  afterStart() {
    const given = JSON.stringify(this.state.runner.given);
    if (given !== this.startedWith) {
      this.startedWith = given;
      this.gaits.renew();
    }
    this.showValues();
  }

  async copyLink() {
    history.replaceState(null, "", this.state.link);
    try {
      await navigator.clipboard.writeText(location.href);
      announce("The link was copied");
      $("link").textContent = "Copied";
    } catch {
      $("link").textContent = "It is in the address";
    }
    setTimeout(() => ($("link").textContent = "Copy a link"), TOLD);
  }

  redraw() {
    this.view.draw();
    this.gaits.redraw();
  }
}

try {
  const module = await compileCore();
  const pools = { painters: new Pool(module, processors()), searchers: new Pool(module, SEARCHERS) };
  document.querySelector("main").hidden = false; // a page that was opened as a file gets no further than its first lines
  const page = new Page([await Core.of(module), await Core.of(module)], pools);
  await Promise.all([pools.painters.ready, pools.searchers.ready]);
  /** For scripts and tests: the page as it is. */
  globalThis.tdmfSlip = page;
  $("loading").hidden = true;
  page.open();
} catch (problem) {
  report(`The page could not start: ${problem.message ?? problem}`);
  throw problem;
}
