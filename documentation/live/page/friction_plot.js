/**
 * The paper's figure 9: largest eigenvalue, speed and cost of transport of the gaits against friction, with their
 * words. It grows while the friction is dragged and while workers follow the gait.
 * @module
 */
import { Axes, rangeOf } from "./axes.js";
import { Surface } from "./canvas.js";
import { listenToDrags } from "./drags.js";
import { lambdaMax } from "./gait_panel.js";
import { printed, shownWord } from "./numbers.js";
import { palette } from "./theme.js";

export const LOW = 0.05;
export const HIGH = 10;
const TICKS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const POINTS = 70; // on each side
const WORDS_HEIGHT = 22;
const PANELS = [
  { title: "largest eigenvalue", value: (gait) => lambdaMax(gait), colour: "ink" },
  { title: "speed", unit: "m/s", value: (gait) => gait.stride["stride.speed"], colour: "accent" },
  { title: "cost of transport", value: (gait) => gait.stride["stride.cost_of_transport"], colour: "second" },
];

/** Frictions from one to the end of the axis, evenly on its logarithm. */
export function frictionsFrom(friction, end) {
  const count = Math.max(2, Math.ceil((POINTS * Math.abs(Math.log(end / friction))) / Math.log(HIGH / LOW)) + 6);
  return Array.from({ length: count }, (_, i) => friction * (end / friction) ** ((i + 1) / count));
}

export class FrictionPlot {
  /** @param {function(number): void} dragged Is told the friction that the pointer is at. */
  constructor(canvas, dragged) {
    this.points = [];
    this.friction = 1;
    this.surface = new Surface(canvas, () => this.draw());
    listenToDrags(canvas, (event) => dragged(Number(this.axes.valueAtX(this.surface.at(event).x).toPrecision(4))));
    canvas.addEventListener("keydown", (event) => {
      const factor = { ArrowLeft: 1 / 1.03, ArrowRight: 1.03 }[event.key];
      if (factor) {
        event.preventDefault();
        dragged(Number((this.friction * factor).toPrecision(4)));
      }
    });
  }

  clear() {
    this.points = [];
    this.draw();
  }

  /** Puts a gait into the curve. */
  add(friction, gait) {
    const index = this.points.findIndex((point) => point.friction >= friction);
    const same = index >= 0 && this.points[index].friction === friction;
    this.points.splice(index < 0 ? this.points.length : index, same ? 1 : 0, { friction, gait });
    this.schedule();
  }

  /** Marks the present friction, and its gait if there is one. */
  mark(friction, gait) {
    this.friction = friction;
    this.gait = gait;
    this.schedule();
  }

  schedule() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.draw();
    });
  }

  draw() {
    const context = this.surface.clear();
    const { width, height } = this.surface;
    const each = (height - WORDS_HEIGHT - 22) / PANELS.length;
    PANELS.forEach((panel, i) => {
      const last = i === PANELS.length - 1;
      const box = { x: 0, y: WORDS_HEIGHT + i * each, width, height: each + (last ? 22 : 0) };
      const y = rangeOf(this.points.map(({ gait }) => panel.value(gait)));
      const scales = { x: [LOW, HIGH], y, log: true, ticksX: TICKS, title: panel.unit ? `${panel.title}, ${printed(panel.unit)}` : panel.title };
      this.axes = new Axes(context, box, { ...scales, labelX: last ? "friction coefficient μ" : "" });
      this.axes.draw();
      this.borders();
      this.curve(panel);
    });
    this.words(context);
  }

  curve({ value, colour }) {
    const { axes } = this;
    const colours = palette();
    axes.inside(() => {
      axes.line(this.points.map(({ friction, gait }) => [friction, value(gait)]), colours[colour], 2);
      axes.line([[this.friction, axes.scales.y[0]], [this.friction, axes.scales.y[1]]], colours.slip_positive, 1.5);
      if (this.gait) {
        axes.dot(this.friction, value(this.gait), colours.slip_positive, 4.5);
      }
    });
  }

  /** Runs of points with one word. */
  get spans() {
    const spans = [];
    for (const { friction, gait } of this.points) {
      if (spans.at(-1)?.word !== gait.word) {
        spans.push({ word: gait.word, from: friction, to: friction });
      }
      spans.at(-1).to = friction;
    }
    return spans;
  }

  borders() {
    const { axes } = this;
    this.spans.slice(1).forEach(({ from }, i) => {
      const between = Math.sqrt(from * this.spans[i].to);
      axes.rule(axes.x(between), axes.top, axes.x(between), axes.bottom, palette().faint, [4, 3]);
    });
  }

  words(context) {
    const { ink, sans } = palette();
    context.font = `600 12px ${sans}`;
    context.fillStyle = ink;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const { word, from, to } of this.spans) {
      const text = shownWord(word);
      const room = this.axes.x(to) - this.axes.x(from);
      if (context.measureText(text).width < room + 6) {
        context.fillText(text, this.axes.x(Math.sqrt(from * to)), 0.6 * WORDS_HEIGHT);
      }
    }
  }
}
