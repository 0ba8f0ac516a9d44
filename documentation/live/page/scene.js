/**
 * The runner as a drawing: ground and tracks of slip, leg with spring, body, foot, ground force in its friction cone.
 * @module
 */
import { Surface } from "./canvas.js";
import { isLoaded, modeName } from "./run.js";
import { niceTicks } from "./axes.js";
import { digits, printed } from "./numbers.js";
import { drawPatch, frictionBelow } from "./patch.js";
import { DISTANCE } from "./race.js";
import { disc, spring } from "./shapes.js";
import { palette } from "./theme.js";

const BODY = 0.1; // radii, over l0
const FOOT = 0.05;
const SHOWN_HEIGHT = 1.95; // of the leg's length, at the least
const FORCE_LENGTH = 0.75; // of the leg's length, for the stride's peak
const CONE_LENGTH = 0.5;
const BESIDE = 2.2; // legs of ground beside runners that race
const RIVAL = 0.55; // opacity
const TICK_EVERY = 120; // px of the ruler, about
const TICK_DIGITS = 7;
const RULER_HEIGHT = 28; // px

export class Scene {
  constructor(canvas, redraw) {
    this.surface = new Surface(canvas, redraw);
    this.tall = SHOWN_HEIGHT;
  }

  /**
   * @param {Run} run
   * @param {Object<string, number>} given Parameters and inputs, by name.
   * @param {?Race} race Whose rival runs behind the runner, both in sight.
   */
  draw(run, given, race = null) {
    const context = this.surface.clear();
    const { outputs } = run;
    this.line = run.core.ground;
    this.aim(race ? [run, race.rival] : [run], given["leg.free_length"]);
    context.fillStyle = palette().card;
    context.fillRect(0, 0, this.surface.width, this.surface.height);
    this.ground(context);
    drawPatch(context, given, this.view, (x) => this.groundAt(x), this.surface.width);
    this.nextGround(context, given);
    if (race) {
      this.lanes(context, race);
    }
    this.trail(context, run.trail);
    this.tracks(context, run.tracks);
    if (!run.fallen) {
      this.forces(context, run, given);
    }
    this.runner(context, outputs, run.fallen);
    if (race) {
      this.label(context, outputs, `μ ${digits(race.frictions[0])}`, palette().ink);
    }
  }

  /** So that the runners are in sight: where they are in pixels. The picture grows at once, and shrinks slowly. */
  aim(runs, length) {
    const { width, height } = this.surface;
    const along = runs.map(({ outputs }) => outputs["com.x"]);
    const ends = [Math.min(...along), Math.max(...along)];
    const centre = 0.5 * (ends[0] + ends[1]);
    const base = this.groundAt(centre);
    const high = Math.max(...runs.map(({ outputs }) => outputs["com.y"])) - base;
    const wide = ends[1] - ends[0] + BESIDE * length;
    const wanted = Math.max(SHOWN_HEIGHT, (1.2 * high) / length, (0.86 * height * wide) / (width * length));
    this.tall += (wanted - this.tall) * (wanted > this.tall ? 1 : 0.02);
    const scale = (0.86 * height) / (this.tall * length);
    this.view = {
      length,
      scale,
      centre,
      x: (x) => 0.5 * width + (x - centre) * scale,
      y: (y) => Math.min(0.9 * height, height - RULER_HEIGHT) - (y - base) * scale,
    };
  }

  /** The start, the finish, and the rival, faint. */
  lanes(context, { rival, frictions }) {
    const { soft, sans } = palette();
    const { x, y, length } = this.view;
    context.strokeStyle = context.fillStyle = soft;
    context.font = `12px ${sans}`;
    context.textAlign = "center";
    for (const [at, text] of [[0, "start"], [DISTANCE * length, "finish"]]) {
      const foot = y(this.groundAt(at));
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(x(at), foot);
      context.lineTo(x(at), 0.3 * foot);
      context.stroke();
      context.fillText(text, x(at), 0.3 * foot - 16);
    }
    context.globalAlpha = RIVAL;
    this.tracks(context, rival.tracks);
    this.runner(context, rival.outputs, rival.fallen);
    context.globalAlpha = 1;
    this.label(context, rival.outputs, `μ ${digits(frictions[1])}`, soft);
  }

  /** Whose body it is. */
  label(context, outputs, text, colour) {
    const { x, y, scale, length } = this.view;
    context.font = `600 13px ${palette().sans}`;
    context.fillStyle = colour;
    context.textAlign = "center";
    context.textBaseline = "bottom";
    context.fillText(text, x(outputs["body.x"]), y(outputs["body.y"]) - 2 * BODY * length * scale);
  }

  /** Height of the ground, m. */
  groundAt(x) {
    return this.line.height + x * Math.tan(this.line.slope);
  }

  ground(context) {
    const { ink, ground, soft, sans } = palette();
    const { width, height } = this.surface;
    const { x, y, scale, centre } = this.view;
    const half = (0.5 * width) / scale;
    const ends = [centre - half, centre + half];
    context.fillStyle = ground;
    context.beginPath();
    context.moveTo(0, y(this.groundAt(ends[0])));
    context.lineTo(width, y(this.groundAt(ends[1])));
    context.lineTo(width, height);
    context.lineTo(0, height);
    context.fill();
    context.strokeStyle = ink;
    context.lineWidth = 1.2;
    context.beginPath();
    context.moveTo(0, y(this.groundAt(ends[0])));
    context.lineTo(width, y(this.groundAt(ends[1])));
    context.stroke();
    context.font = `11px ${sans}`;
    context.fillStyle = soft;
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const tick of niceTicks(...ends, Math.max(2, width / TICK_EVERY))) {
      const at = y(this.groundAt(tick));
      context.fillRect(Math.round(x(tick)), at + 9, 1, 4);
      if (x(tick) > 18 && x(tick) < width - 18) {
        context.fillText(`${digits(tick, TICK_DIGITS)} ${printed("m")}`, x(tick), at + 14);
      }
    }
  }

  /** The line that was set last, while it is not in force: the foot has to leave the ground first. */
  nextGround(context, given) {
    const next = { height: given["ground.height"], slope: given["ground.slope"] };
    if (next.height === this.line.height && next.slope === this.line.slope) {
      return;
    }
    const { width } = this.surface;
    const { x, y, scale } = this.view;
    context.strokeStyle = palette().soft;
    context.setLineDash([6, 5]);
    context.beginPath();
    for (const pixel of [0, width]) {
      const at = (pixel - x(0)) / scale;
      context.lineTo(pixel, y(next.height + at * Math.tan(next.slope)));
    }
    context.stroke();
    context.setLineDash([]);
  }

  trail(context, points) {
    const { soft } = palette();
    const { x, y } = this.view;
    context.strokeStyle = soft;
    context.lineWidth = 1.2;
    context.setLineDash([1, 4]);
    context.beginPath();
    points.forEach(([px, py], i) => context[i ? "lineTo" : "moveTo"](x(px), y(py)));
    context.stroke();
    context.setLineDash([]);
  }

  /** Where the foot has slipped. */
  tracks(context, tracks) {
    const colours = palette();
    const { x, y } = this.view;
    context.lineWidth = 5;
    for (const { from, to, mode } of tracks) {
      context.strokeStyle = colours[modeName(mode)];
      context.beginPath();
      context.moveTo(x(from), y(this.groundAt(from)) + 4);
      context.lineTo(x(to), y(this.groundAt(to)) + 4);
      context.stroke();
    }
  }

  forces(context, run, given) {
    const { outputs } = run;
    if (isLoaded(outputs["contact.mode"])) {
      this.cone(context, outputs, given);
      const peak = outputs["stride.peak_force"] || given["leg.stiffness"] * this.view.length;
      const to = FORCE_LENGTH * this.view.length;
      const arrow = [(outputs["contact.fx"] / peak) * to, (outputs["contact.fy"] / peak) * to];
      this.arrow(context, [outputs["foot.x"], outputs["foot.y"]], arrow, palette()[modeName(outputs["contact.mode"])]);
    }
    this.torque(context, outputs, given);
    this.push(context, outputs, given);
  }

  /** What pushes the body from outside, over its weight. */
  push(context, outputs, given) {
    const weight = given["body.mass"] * given.gravity;
    const share = ["body.external_fx", "body.external_fy"].map((name) => (given[name] ?? 0) / weight);
    const most = Math.max(1, Math.hypot(...share));
    const arrow = share.map((part) => (part / most) * this.view.length);
    this.arrow(context, [outputs["body.x"], outputs["body.y"]], arrow, palette().second);
  }

  cone(context, outputs, given) {
    const { cone } = palette();
    const { x, y, scale, length } = this.view;
    const resting = modeName(outputs["contact.mode"]) === "stick" ? (given["ground.static_friction_ratio"] ?? 1) : 1;
    const half = Math.atan(resting * frictionBelow(given, outputs["foot.x"]));
    const upright = -0.5 * Math.PI - this.line.slope;
    context.fillStyle = cone;
    context.beginPath();
    context.moveTo(x(outputs["foot.x"]), y(outputs["foot.y"]));
    const radius = CONE_LENGTH * length * scale;
    context.arc(x(outputs["foot.x"]), y(outputs["foot.y"]), radius, upright - half, upright + half);
    context.fill();
  }

  arrow(context, from, by, colour) {
    const { x, y } = this.view;
    const start = [x(from[0]), y(from[1])];
    const end = [x(from[0] + by[0]), y(from[1] + by[1])];
    const size = Math.hypot(end[0] - start[0], end[1] - start[1]);
    if (size < 2) {
      return;
    }
    const head = Math.min(9, 0.6 * size);
    const direction = [(end[0] - start[0]) / size, (end[1] - start[1]) / size];
    const neck = [end[0] - head * direction[0], end[1] - head * direction[1]];
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(...start);
    context.lineTo(...neck);
    context.stroke();
    context.beginPath();
    context.moveTo(...end);
    context.lineTo(neck[0] - 0.5 * head * direction[1], neck[1] + 0.5 * head * direction[0]);
    context.lineTo(neck[0] + 0.5 * head * direction[1], neck[1] - 0.5 * head * direction[0]);
    context.fill();
  }

  /** The hip's torque as an arc about the body, as long as the torque is large. */
  torque(context, outputs, given) {
    const { second } = palette();
    const { x, y, scale, length } = this.view;
    const most = Math.abs(given["hip.stance_torque"]) || given["leg.stiffness"] * length ** 2;
    const share = Math.max(-1, Math.min(1, outputs["hip.torque"] / most));
    if (Math.abs(share) < 0.01) {
      return;
    }
    const radius = 1.7 * BODY * length * scale;
    const centre = [x(outputs["body.x"]), y(outputs["body.y"])];
    const from = -0.5 * Math.PI;
    const to = from - share * 1.4 * Math.PI * 0.5;
    context.strokeStyle = context.fillStyle = second;
    context.lineWidth = 3;
    context.beginPath();
    context.arc(...centre, radius, from, to, share > 0);
    context.stroke();
    const tip = [centre[0] + radius * Math.cos(to), centre[1] + radius * Math.sin(to)];
    const onward = to - Math.sign(share) * 0.5 * Math.PI;
    context.beginPath();
    for (const turn of [0, 2.4, -2.4]) {
      context.lineTo(tip[0] + 7 * Math.cos(onward + turn), tip[1] + 7 * Math.sin(onward + turn));
    }
    context.fill();
  }

  runner(context, outputs, fallen) {
    const { ink, card } = palette();
    const { x, y, scale, length } = this.view;
    const foot = [x(outputs["foot.x"]), y(outputs["foot.y"])];
    const body = [x(outputs["body.x"]), y(outputs["body.y"])];
    spring(context, foot, body, 0.055 * length * scale, ink);
    disc(context, body, BODY * length * scale, ink, ink);
    const mode = modeName(outputs["contact.mode"]);
    disc(context, foot, FOOT * length * scale, fallen || mode === "flight" ? card : palette()[mode], ink);
  }
}
