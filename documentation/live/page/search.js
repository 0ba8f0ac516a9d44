/**
 * The gait of the runner on the page: found on demand, followed while the friction is dragged, continued over the
 * friction by workers.
 * @module
 */
import { frictionsFrom, HIGH, LOW } from "./friction_plot.js";
import { FRICTION } from "./gaits.js";
import { seen } from "./visibility.js";

const AGAIN_DELAY = 350; // ms after the last change of a parameter

export class GaitSearch {
  /**
   * @param {Pool} pool Whose workers have nothing else to do.
   * @param {function(): {given: Object<string, number>, apex: number[]}} runner Whose gait is looked for.
   * @param {{found: function(?Gait, string), point: function(number, Gait), cleared: function()}} listener
   */
  constructor(pool, runner, listener) {
    Object.assign(this, { pool, runner, listener, gait: null, version: 0, following: null, wanted: false });
  }

  /** Settles, then Newton's method; then the curve against friction. */
  async find() {
    const version = this.forget();
    this.wanted = true;
    const { given, apex } = this.runner();
    const { gait, message } = await this.pool.run("find", { given, apex });
    if (version !== this.version) {
      return;
    }
    this.accept(gait, given[FRICTION], message);
    if (gait) {
      this.continueBothWays(given, gait, version);
    }
  }

  accept(gait, friction, message) {
    this.gait = gait;
    this.friction = friction;
    this.listener.found(gait, message);
    if (gait) {
      this.listener.point(friction, gait);
    }
  }

  /** The curve from the gait to both ends of the axis. */
  async continueBothWays(given, gait, version) {
    await seen();
    if (version !== this.version) {
      return;
    }
    for (const end of [LOW, HIGH]) {
      const send = ({ friction, gait: point }) => version === this.version && this.listener.point(friction, point);
      this.pool.run("curve", { given, gait, frictions: frictionsFrom(given[FRICTION], end) }, send);
    }
  }

  /** What was found, or is looked for, is of another runner. */
  forget() {
    clearTimeout(this.again);
    this.pool.abandon();
    this.following = null;
    this.gait = null;
    this.listener.cleared();
    return ++this.version;
  }

  /** Something else than the friction has changed: where a gait was wanted, it is looked for again. */
  changed() {
    if (this.wanted) {
      this.forget();
      this.again = setTimeout(() => this.find(), AGAIN_DELAY);
    }
  }

  /** The friction has changed: from the last gait on, one search at a time, the newest friction next. */
  async frictionChanged() {
    if (!this.wanted || this.following || !this.gait) {
      this.stale = Boolean(this.following);
      if (this.wanted && !this.gait && !this.following) {
        this.changed();
      }
      return;
    }
    const { version } = this;
    const { given } = this.runner();
    this.following = this.pool.run("follow", { given, from: this.friction, gait: this.gait });
    const { gait, message } = await this.following;
    this.following = null;
    if (version === this.version) {
      if (gait) {
        this.accept(gait, given[FRICTION], "");
      } else {
        this.listener.found(null, message);
      }
    }
    if (this.stale) {
      this.stale = false;
      this.frictionChanged();
    }
  }
}
