/**
 * Axes of a plot: scales, ticks, labels, lines.
 * @module
 */
import { digits } from "./numbers.js";
import { palette } from "./theme.js";

const MARGIN = { left: 52, right: 12, top: 24, bottom: 36 };
const MAX_TICKS = 100;
const TICK_ROOM = 24; // px of height for each, about

/** Round steps of 1, 2 or 5 that give about so many ticks. */
export function niceTicks(low, high, count) {
  const rough = (high - low) / count;
  const size = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * size).find((candidate) => candidate >= rough);
  const first = Math.ceil(low / step - 1e-9);
  const number = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, Math.min(MAX_TICKS, number)) }, (_, i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
}

/** A rectangle of a canvas with a horizontal and a vertical scale. */
export class Axes {
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {{x: number, y: number, width: number, height: number}} box In pixels, labels included.
   * @param {{x: number[], y: number[], log?: boolean, ticksX?: number[], labelX?: string, title?: string}} scales
   */
  constructor(context, box, scales) {
    this.context = context;
    this.scales = scales;
    this.left = box.x + this.marginLeft(box);
    this.right = box.x + box.width - MARGIN.right;
    this.top = box.y + MARGIN.top;
    this.bottom = box.y + box.height - (scales.labelX ? MARGIN.bottom : 14);
    this.warp = scales.log ? Math.log : (value) => value;
    this.unwarp = scales.log ? Math.exp : (value) => value;
  }

  /** Wide enough for every label of the ticks. */
  marginLeft({ height }) {
    const { context, scales } = this;
    context.font = `11.5px ${palette().sans}`;
    this.ticksY = niceTicks(...scales.y, Math.max(2, (height - MARGIN.top - 14) / TICK_ROOM));
    const widest = Math.max(0, ...this.ticksY.map((tick) => context.measureText(digits(tick)).width));
    return Math.max(MARGIN.left, widest + 10);
  }

  x(value) {
    const [low, high] = this.scales.x.map(this.warp);
    return this.left + ((this.warp(value) - low) / (high - low)) * (this.right - this.left);
  }

  y(value) {
    const [low, high] = this.scales.y;
    return this.bottom - ((value - low) / (high - low)) * (this.bottom - this.top);
  }

  /** The value at a pixel, within the scale. */
  valueAtX(pixel) {
    const [low, high] = this.scales.x.map(this.warp);
    const share = Math.max(0, Math.min(1, (pixel - this.left) / (this.right - this.left)));
    return this.unwarp(low + share * (high - low));
  }

  valueAtY(pixel) {
    const [low, high] = this.scales.y;
    return low + Math.max(0, Math.min(1, (this.bottom - pixel) / (this.bottom - this.top))) * (high - low);
  }

  /** Frame, ticks and labels. */
  draw() {
    const { context, scales } = this;
    const { ink, soft, line, sans } = palette();
    context.font = `11.5px ${sans}`;
    context.lineWidth = 1;
    context.fillStyle = soft;
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (const tick of this.ticksY) {
      this.rule(this.left, this.y(tick), this.right, this.y(tick), line);
      context.fillText(digits(tick), this.left - 6, this.y(tick));
    }
    context.textBaseline = "top";
    context.textAlign = "center";
    const ticks = scales.ticksX ?? niceTicks(...scales.x, Math.max(2, (this.right - this.left) / 70));
    for (const tick of ticks.filter((value) => value >= scales.x[0] && value <= scales.x[1])) {
      this.rule(this.x(tick), this.bottom, this.x(tick), this.bottom + 4, soft);
      if (scales.labelX) {
        context.fillText(digits(tick), this.x(tick), this.bottom + 6);
      }
    }
    this.rule(this.left, this.bottom, this.right, this.bottom, soft);
    if (scales.labelX) {
      context.fillText(scales.labelX, 0.5 * (this.left + this.right), this.bottom + 21);
    }
    context.fillStyle = ink;
    context.textAlign = "left";
    context.textBaseline = "alphabetic";
    if (scales.title) {
      context.fillText(scales.title, this.left, this.top - 9);
    }
  }

  rule(x0, y0, x1, y1, colour, dash = []) {
    const { context } = this;
    context.strokeStyle = colour;
    context.setLineDash(dash);
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
    context.setLineDash([]);
  }

  /** Draws inside the frame only. */
  inside(draw) {
    const { context } = this;
    context.save();
    context.beginPath();
    context.rect(this.left, this.top - 2, this.right - this.left, this.bottom - this.top + 4);
    context.clip();
    draw();
    context.restore();
  }

  /** A line through points. */
  line(points, colour, width = 2, dash = []) {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineJoin = "round";
    context.setLineDash(dash);
    context.beginPath();
    points.forEach(([x, y], i) => context[i ? "lineTo" : "moveTo"](this.x(x), this.y(y)));
    context.stroke();
    context.setLineDash([]);
  }

  dot(x, y, colour, radius = 4) {
    const { context } = this;
    context.fillStyle = colour;
    context.beginPath();
    context.arc(this.x(x), this.y(y), radius, 0, 2 * Math.PI);
    context.fill();
  }
}

/**
 * A range about values, with a little room; never empty.
 * @param {number[]} values
 * @param {number} [least] The room at the least: what is less is noise.
 */
export function rangeOf(values, least = 0) {
  const finite = values.filter(Number.isFinite);
  const low = Math.min(...finite, Infinity);
  const high = Math.max(...finite, -Infinity);
  if (!(low <= high)) {
    return [0, 1];
  }
  const size = Math.max(Math.abs(low), Math.abs(high));
  const room = Math.max(0.07 * (high - low), least, high - low <= 1e-9 * size ? 0.07 * size || 1 : 0);
  return [low - room, high + room];
}
