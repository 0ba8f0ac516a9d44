/**
 * The run in time: frame by frame at a pace, paused, stepped.
 * @module
 */
import { $, announce, guarded, report } from "./messages.js";
import { changesAtTouchdown, paceOf, paceText } from "./pace.js";

const LONGEST_FRAME = 0.05; // s; after a pause of the browser nothing is made up for
const STEP = 0.01; // sqrt(m/k)
const NEXT_EVENT_WITHIN = 100; // sqrt(m/k)
const FRAMES_KEPT = 600;

export class Player {
  /**
   * @param {Run} run
   * @param {RunView} view
   */
  constructor(run, view) {
    this.run = run;
    this.view = view;
    this.running = false;
    $("pace").addEventListener("change", () => this.tellPace());
    /** What the last frames took of the main thread, ms. */
    this.frames = [];
    /** Are told whenever the run has advanced. */
    this.followers = [];
  }

  play(running) {
    this.running = running && !this.run.over;
    $("play").textContent = this.running ? "Pause" : this.run.over ? "Run again" : "Run";
    if (!this.running && !this.run.over) {
      this.view.tell();
    }
  }

  /** A run that nobody asked to see move: it moves if the last one did, and unless motion is unwelcome. */
  present() {
    this.play(this.running || !matchMedia("(prefers-reduced-motion: reduce)").matches);
  }

  /** How fast the run is shown, which depends on the runner, too. */
  tellPace() {
    $("pace-text").value = paceText($("pace").value, this.run);
  }

  /** A hundredth of sqrt(m/k). */
  step() {
    this.advanceBy(() => this.run.advance(STEP * this.run.core.timeScale));
  }

  /** To the next change of contact or hip phase. */
  stepToEvent() {
    this.advanceBy(() => this.run.advanceToEvent(NEXT_EVENT_WITHIN * this.run.core.timeScale));
  }

  /** Pauses, and lets the run advance once. */
  advanceBy(advance) {
    this.play(false);
    advance();
    this.followers.forEach((follow) => follow());
    this.noticeEnd();
    this.view.draw();
    if (!this.run.over) {
      this.view.tell();
    }
  }

  nextPace() {
    const { options, selectedIndex } = $("pace");
    $("pace").selectedIndex = (selectedIndex + 1) % options.length;
    this.tellPace();
  }

  /** Asks the browser for frames, from now on. */
  begin() {
    requestAnimationFrame((now) => this.frame(now));
  }

  async frame(now) {
    const before = performance.now();
    const elapsed = Math.min((now - (this.last ?? now)) / 1000, LONGEST_FRAME);
    this.last = now;
    this.begin();
    if (!this.running) {
      return;
    }
    const done = guarded(() => {
      this.advance(elapsed);
      this.view.drawFrame();
    });
    this.frames.push(performance.now() - before);
    this.frames.splice(0, this.frames.length - FRAMES_KEPT);
    if (!(await done)) {
      this.running = false;
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
    this.followers.forEach((follow) => follow());
    this.noticeEnd();
  }

  noticeEnd() {
    if (this.run.over) {
      this.play(false);
      report(this.run.trouble);
      announce(this.run.trouble || "The runner fell.");
    }
  }
}
