/**
 * The paper's figure 7 for the running stride: foot velocity, and force ratio with the friction cone.
 * @module
 */
import { Axes, rangeOf } from "./axes.js";
import { Surface } from "./canvas.js";
import { printed } from "./numbers.js";
import { isSlip, modeName, pieces } from "./run.js";
import { palette } from "./theme.js";

const ROOM = 0.06;
const STILL = 0.01; // of the leg's length over sqrt(m/k): a foot that is slower than that is drawn at rest
const MAX_CONE = 2.2; // of a larger friction only the ratios are shown

const speed = ({ velocity }) => velocity;
const ratio = ({ tangential, normal }) => (normal > 0 ? tangential / normal : NaN);

export class StancePlots {
  constructor(velocityCanvas, ratioCanvas, redraw) {
    this.velocity = new Surface(velocityCanvas, redraw);
    this.ratio = new Surface(ratioCanvas, redraw);
  }

  /**
   * @param {Run} run
   * @param {Object<string, number>} given Parameters and inputs, by name.
   */
  draw(run, given) {
    const friction = given["ground.friction"];
    const resting = friction * (given["ground.static_friction_ratio"] ?? 1);
    const present = pieces(run.stance);
    const last = pieces(run.lastStance);
    const ends = [...present, ...last].map(({ rows }) => rows.at(-1).time);
    const length = Math.max(...ends, 0) || 1;
    const x = [-ROOM * length, (1 + ROOM) * length];
    const least = (STILL * given["leg.free_length"]) / run.core.timeScale;
    this.panel(this.velocity, present, last, speed, { x, title: `foot velocity, ${printed("m/s")}`, zero: true, least });
    const cone = resting <= MAX_CONE ? { friction, resting } : null;
    const labelX = `time since touchdown, ${printed("s")}`;
    const title = "force ratio, along over across the ground";
    this.panel(this.ratio, present, last, ratio, { x, title, cone, labelX, least: 0.05 });
  }

  panel(surface, present, last, value, { x, title, labelX, cone, zero, least }) {
    const context = surface.clear();
    const shown = [...present, ...last].flatMap(({ rows }) => rows.map(value));
    const edges = cone ? [-cone.resting, cone.resting] : [];
    const y = rangeOf([...shown, ...edges, ...(zero ? [0] : [])], least);
    const box = { x: 0, y: 0, width: surface.width, height: surface.height };
    const axes = new Axes(context, box, { x, y, title, labelX });
    axes.draw();
    if (cone) {
      this.cone(axes, cone, x);
    }
    axes.inside(() => {
      context.globalAlpha = 0.3;
      last.forEach((piece) => this.piece(axes, piece, value));
      context.globalAlpha = 1;
      present.forEach((piece) => this.piece(axes, piece, value));
    });
    const end = present.at(-1);
    if (end) {
      const row = end.rows.at(-1);
      axes.dot(row.time, value(row), palette()[modeName(end.mode)]);
    }
  }

  /** The cone of a foot that slips, and around it that of a foot at rest. */
  cone(axes, { friction, resting }, x) {
    const { accent, cone: tint } = palette();
    const { context } = axes;
    for (const edge of new Set([friction, resting])) {
      context.fillStyle = tint;
      context.fillRect(axes.left, axes.y(edge), axes.right - axes.left, axes.y(-edge) - axes.y(edge));
      [-edge, edge].forEach((at) => axes.line([[x[0], at], [x[1], at]], accent, 1, [4, 3]));
    }
    context.fillStyle = accent;
    context.textAlign = "right";
    context.fillText("+μ", axes.right - 4, axes.y(friction) + 12);
    context.fillText("−μ", axes.right - 4, axes.y(-friction) - 5);
  }

  piece(axes, { mode, rows }, value) {
    const points = rows.map((row) => [row.time, value(row)]).filter(([, y]) => Number.isFinite(y));
    const colour = palette()[modeName(mode)];
    axes.line(points, colour, 2.2, isSlip(mode) ? [6, 3] : []);
    if (points.length && points.at(-1)[0] - points[0][0] < 0.01 * (axes.scales.x[1] - axes.scales.x[0])) {
      axes.dot(...points.at(-1), colour, 3);
    }
  }
}
