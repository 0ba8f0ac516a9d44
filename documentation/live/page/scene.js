/**
 * The runner as a drawing: ground and tracks of slip, leg with spring, body, foot, ground force in its friction cone.
 * @module
 */
import { Surface } from "./canvas.js";
import { isLoaded, modeName } from "./run.js";
import { niceTicks } from "./axes.js";
import { digits } from "./numbers.js";
import { palette } from "./theme.js";

const COILS = 7;
const BODY = 0.1; // radii, over l0
const FOOT = 0.05;
const SHOWN_HEIGHT = 1.95; // of the leg's length, at the least
const FORCE_LENGTH = 0.75; // of the leg's length, for the stride's peak
const CONE_LENGTH = 0.5;
const TICK_EVERY = 120; // px of the ruler, about
const TICK_DIGITS = 7;

export class Scene {
  constructor(canvas, redraw) {
    this.surface = new Surface(canvas, redraw);
    this.tall = SHOWN_HEIGHT;
  }

  /**
   * @param {Run} run
   * @param {Object<string, number>} given Parameters and inputs, by name.
   */
  draw(run, given) {
    const context = this.surface.clear();
    const { outputs } = run;
    const length = given["leg.free_length"];
    const { width, height } = this.surface;
    const centre = outputs["com.x"];
    this.line = run.core.ground;
    const base = this.groundAt(centre);
    const wanted = Math.max(SHOWN_HEIGHT, (1.2 * (outputs["com.y"] - base)) / length);
    this.tall += (wanted - this.tall) * (wanted > this.tall ? 1 : 0.02);
    const scale = (0.86 * height) / (this.tall * length);
    this.place = {
      length,
      scale,
      x: (x) => 0.5 * width + (x - centre) * scale,
      y: (y) => 0.9 * height - (y - base) * scale,
    };
    context.fillStyle = palette().card;
    context.fillRect(0, 0, width, height);
    this.ground(context, centre);
    this.nextGround(context, given);
    this.trail(context, run.trail);
    this.tracks(context, run.tracks);
    if (!run.fallen) {
      this.forces(context, run, given);
    }
    this.runner(context, outputs, run.fallen);
  }

  /** Height of the ground, m. */
  groundAt(x) {
    return this.line.height + x * Math.tan(this.line.slope);
  }

  ground(context, centre) {
    const { ink, ground, soft, sans } = palette();
    const { width, height } = this.surface;
    const { x, y, scale } = this.place;
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
        context.fillText(`${digits(tick, TICK_DIGITS)} m`, x(tick), at + 14);
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
    const { x, y, scale } = this.place;
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
    const { x, y } = this.place;
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
    const { x, y } = this.place;
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
      const peak = outputs["stride.peak_force"] || given["leg.stiffness"] * this.place.length;
      const to = FORCE_LENGTH * this.place.length;
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
    const arrow = share.map((part) => (part / most) * this.place.length);
    this.arrow(context, [outputs["body.x"], outputs["body.y"]], arrow, palette().second);
  }

  cone(context, outputs, given) {
    const { cone } = palette();
    const { x, y, scale, length } = this.place;
    const resting = modeName(outputs["contact.mode"]) === "stick" ? (given["ground.static_friction_ratio"] ?? 1) : 1;
    const half = Math.atan(resting * given["ground.friction"]);
    const upright = -0.5 * Math.PI - this.line.slope;
    context.fillStyle = cone;
    context.beginPath();
    context.moveTo(x(outputs["foot.x"]), y(outputs["foot.y"]));
    const radius = CONE_LENGTH * length * scale;
    context.arc(x(outputs["foot.x"]), y(outputs["foot.y"]), radius, upright - half, upright + half);
    context.fill();
  }

  arrow(context, from, by, colour) {
    const { x, y } = this.place;
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
    const { x, y, scale, length } = this.place;
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
    const { x, y, scale, length } = this.place;
    const foot = [x(outputs["foot.x"]), y(outputs["foot.y"])];
    const body = [x(outputs["body.x"]), y(outputs["body.y"])];
    spring(context, foot, body, 0.055 * length * scale, ink);
    disc(context, body, BODY * length * scale, ink, ink);
    const mode = modeName(outputs["contact.mode"]);
    disc(context, foot, FOOT * length * scale, fallen || mode === "flight" ? card : palette()[mode], ink);
  }
}

function disc(context, [x, y], radius, fill, rim) {
  context.fillStyle = fill;
  context.strokeStyle = rim;
  context.lineWidth = 1.6;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** A coil spring, straight at both ends. */
function spring(context, from, to, width, colour) {
  const along = [to[0] - from[0], to[1] - from[1]];
  const size = Math.max(Math.hypot(...along), 1e-9);
  const across = [(-along[1] / size) * width, (along[0] / size) * width];
  const count = 24 * COILS;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.lineJoin = "round";
  context.beginPath();
  for (let i = 0; i <= count; ++i) {
    const share = i / count;
    const winding = Math.max(0, Math.min(1, (share - 0.2) / 0.55));
    const side = Math.sin(2 * Math.PI * COILS * winding);
    context.lineTo(from[0] + share * along[0] + side * across[0], from[1] + share * along[1] + side * across[1]);
  }
  context.stroke();
}
