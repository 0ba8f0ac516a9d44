/**
 * A race on one ground: the page's runner against another that differs in the friction alone, each from the apex of its
 * gait, side by side in time.
 * @module
 */
import { differences } from "./address.js";
import { FRICTION } from "./gaits.js";
import { $, announce, guarded, report } from "./messages.js";
import { digits, inShownUnits, numberIn, printed } from "./numbers.js";
import { startOf } from "./page_state.js";
import { Run } from "./run.js";

/** Legs from start to finish. */
export const DISTANCE = 100;

export class Race {
  /**
   * @param {Core} core The rival's own.
   * @param {Pool} pool Whose workers find the gaits.
   * @param {Page} page Whose runner races.
   */
  constructor(core, pool, page) {
    Object.assign(this, { core, pool, page, rival: new Run(core), on: false, attempt: 0, winner: null });
    $("race").addEventListener("click", () => (this.on ? this.end() : this.ask()));
    for (const id of ["race-own", "race-rival"]) {
      $(id).addEventListener("change", () => this.on && this.ask());
    }
  }

  /** What the two fields say; who asks to see a race sees it move. */
  async ask() {
    await this.start(numberIn($("race-own").value), numberIn($("race-rival").value));
    if (this.on) {
      this.page.player.play(true);
    }
  }

  /**
   * Both at the start, and off.
   * @param {number} own Friction of the page's runner.
   * @param {number} other Friction of the rival.
   */
  start(own, other) {
    const attempt = ++this.attempt;
    $("race-text").value = "Looking for both gaits …";
    return guarded(async () => {
      const lanes = await Promise.all([own, other].map((friction) => this.lane(friction)));
      if (attempt !== this.attempt) {
        return;
      }
      const problem = lanes.map((lane) => lane.problem).find(Boolean) ?? "";
      report(problem);
      if (problem) {
        $("race-text").value = this.on ? this.standing : "";
        return;
      }
      this.lanes = lanes.map((lane) => lane.start);
      this.frictions = [own, other];
      this.again();
    });
  }

  /** A runner at the apex of its gait; or why there is none. */
  async lane(friction) {
    const { apex } = this.page.state.runner;
    const given = { ...this.page.state.values, [FRICTION]: friction };
    const { start, message } = await this.pool.run("lane", { given, apex });
    const changed = Number.isFinite(friction) ? differences(given) : [];
    const why = changed.length ? ` With ${changed.join(", ")}.` : "";
    return { start, problem: start ? "" : `No race: ${inShownUnits(message)}${why}` };
  }

  /** The same race from its start. */
  again() {
    const [own, other] = this.lanes;
    this.core.accept(other);
    this.rival.restart(other);
    Object.assign(this, { on: true, winner: null });
    ["race-own", "race-rival"].forEach((id, i) => ($(id).value = String(this.frictions[i])));
    $("race").textContent = "End the race";
    $("pace").value = "full";
    this.page.state.rival = this.frictions[1];
    this.page.beginRun(own);
    this.last = this.distances;
    this.tell();
  }

  /** Another run begins, without a rival. */
  end() {
    this.attempt += 1;
    $("race-text").value = "";
    if (!this.on) {
      return;
    }
    this.on = false;
    this.page.state.rival = null;
    $("race").textContent = "Race";
    this.page.state.writeAddress();
    this.page.view.draw();
  }

  /** Every value but the friction is that of both. */
  change(values) {
    if (this.on) {
      this.core.accept({ ...values, [FRICTION]: this.frictions[1] });
      this.rival.change(true);
      this.frictions[0] = values[FRICTION];
      this.lanes = this.lanes.map((lane, i) => ({ ...values, ...startOf(lane), [FRICTION]: this.frictions[i] }));
      $("race-own").value = String(values[FRICTION]);
    }
  }

  /** The rival gets to where the page's runner is in time. */
  follow() {
    if (this.on) {
      this.rival.advance(this.page.run.time - this.rival.time);
      this.judge();
      this.tell();
    }
  }

  /** Legs that both have run. */
  get distances() {
    const length = this.page.state.values["leg.free_length"];
    return [this.page.run, this.rival].map(({ outputs }) => outputs["com.x"] / length);
  }

  /** The first beyond the line has won, and the run rests there. */
  judge() {
    const now = this.distances;
    const first = now[0] >= now[1] ? 0 : 1;
    if (this.winner === null && now[first] >= DISTANCE) {
      const share = (DISTANCE - this.last[first]) / (now[first] - this.last[first]);
      const other = this.last[1 - first];
      Object.assign(this, { winner: first, margin: DISTANCE - (other + share * (now[1 - first] - other)) });
      this.page.player.play(false);
      announce(this.standing);
    }
    this.last = now;
  }

  /** Who is ahead, or by how much the winner was when it crossed the line. */
  get standing() {
    const [own, other] = this.distances;
    const length = this.page.state.values["leg.free_length"];
    const distance = (legs, count) => `${digits(legs * length, count)} ${printed("m")}`;
    if (own === other) {
      return `Ready: ${distance(DISTANCE)} to run.`;
    }
    const fallen = [this.page.run, this.rival].flatMap(({ fallen: fell }, i) => (fell ? [this.frictions[i]] : []));
    const falls = fallen.map((friction) => ` The runner on friction ${digits(friction)} has fallen.`).join("");
    const first = this.frictions[this.winner ?? (own >= other ? 0 : 1)];
    const verb = this.winner === null ? "is ahead" : `wins over ${distance(DISTANCE)}`;
    const lead = this.winner === null ? Math.abs(own - other) : this.margin;
    return `Friction ${digits(first)} ${verb} by ${distance(lead, 3)}.${falls}`;
  }

  tell() {
    const text = this.standing;
    if ($("race-text").value !== text) {
      $("race-text").value = text;
    }
  }
}
