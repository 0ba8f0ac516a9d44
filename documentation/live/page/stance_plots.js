/**
 * The paper's figure 7 for the running stride: foot velocity, and force ratio with the friction cone.
 * @module
 */
import { Axes, rangeOf } from "./axes.js";
import { Surface } from "./canvas.js";
import { isSlip, modeName, pieces } from "./run.js";
import { palette } from "./theme.js";

const ROOM = 0.06;
const MOST_CONE = 2.2; // of a larger friction only the ratios are shown

const velocity = ({ footVx }) => footVx;
const ratio = ({ fx, fy }) => (fy > 0 ? fx / fy : NaN);

export class StancePlots {
  constructor(velocityCanvas, ratioCanvas, redraw) {
    this.velocity = new Surface(velocityCanvas, redraw);
    this.ratio = new Surface(ratioCanvas, redraw);
  }

  /** @param {Run} run @param {number} friction */
  draw(run, friction) {
    const present = pieces(run.stance);
    const last = pieces(run.lastStance);
    const ends = [...present, ...last].map(({ rows }) => rows.at(-1).time);
    const length = Math.max(...ends, 0) || 1;
    const x = [-ROOM * length, (1 + ROOM) * length];
    this.panel(this.velocity, present, last, velocity, { x, title: "foot velocity, m/s", zero: true });
    const cone = friction <= MOST_CONE ? [-friction, friction] : [];
    this.panel(this.ratio, present, last, ratio, { x, title: "force ratio, fx/fy", cone, labelX: "time since touchdown, s" });
  }

  panel(surface, present, last, value, { x, title, labelX, cone = [], zero }) {
    const context = surface.clear();
    const shown = [...present, ...last].flatMap(({ rows }) => rows.map(value));
    const y = rangeOf([...shown, ...cone, ...(zero ? [0] : [])], zero ? 0 : 0.05);
    const box = { x: 0, y: 0, width: surface.width, height: surface.height };
    const axes = new Axes(context, box, { x, y, title, labelX });
    axes.draw();
    this.coneOf(axes, cone, x);
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

  coneOf(axes, cone, x) {
    const { accent, cone: tint } = palette();
    if (cone.length) {
      axes.context.fillStyle = tint;
      axes.context.fillRect(axes.left, axes.y(cone[1]), axes.right - axes.left, axes.y(cone[0]) - axes.y(cone[1]));
      cone.forEach((edge) => axes.line([[x[0], edge], [x[1], edge]], accent, 1, [4, 3]));
      axes.context.fillStyle = accent;
      axes.context.textAlign = "right";
      axes.context.fillText("+μ", axes.right - 4, axes.y(cone[1]) + 12);
      axes.context.fillText("−μ", axes.right - 4, axes.y(cone[0]) - 5);
    }
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
