/**
 * A region of attraction over two coordinates of the apex section, painted by workers; a click starts the runner there.
 * @module
 */
import { Axes } from "./axes.js";
import { Surface } from "./canvas.js";
import { apex as coordinates } from "./data.js";
import { digits, printed } from "./numbers.js";
import { palette } from "./theme.js";
import { seen } from "./visibility.js";

/** When a runner has settled; as `tdmf-slip basin` has it. */
const RULES = { tolerance: 1e-5, distance: 1e-2, strides: 400 };
const ROWS_AT_ONCE = 2;
const COARSE = [16, 32]; // points each way before the finest
const OUTDATED = 0.25; // opacity of what was painted for another runner
const LEG_LENGTH = 2; // it and the coordinates before are positive
const MIN_SHARE = 0.1; // of the gait's, for what is positive
const FATES = [
  { name: "settled", text: "settles on the gait (stronger colour: sooner)", colour: "accent" },
  { name: "fell", text: "falls", colour: "bad" },
  { name: "undecided", text: "neither in 400 strides", colour: "slip_positive" },
  { name: "no_start", text: "no start: the foot is not above the ground", colour: "faint" },
  { name: "unsolved", text: "the solver could not follow", colour: "ink" },
];
const NAMES = coordinates.map(({ name }) => name.replace("apex.", ""));

const rounded = (value) => (value ? Number(value.toPrecision(6)) : 0);

/**
 * Ends of a range of a coordinate that has the gait in it.
 * @param {number} width 1 for the range of `tdmf-slip basin`.
 */
function rangeAround(apex, scales, index, width) {
  const here = apex[index];
  if (index > LEG_LENGTH) {
    return [here - 0.5 * width * scales[index], here + 0.5 * width * scales[index]].map(rounded);
  }
  return [Math.max(1 - 0.3 * width, MIN_SHARE) * here, (1 + 0.5 * width) * here].map(rounded);
}

const spaced = ([low, high], count) =>
  Array.from({ length: count }, (_, i) => (i === count - 1 ? high : low + (i * (high - low)) / (count - 1)));

export class Region {
  /**
   * @param {object} elements Canvas, selects for rows, columns, points and width, list of colours.
   * @param {Core} core
   * @param {function(number[]): void} chosen Is handed the apex that was clicked.
   */
  constructor({ canvas, rows, columns, points, width, legend }, core, chosen) {
    this.core = core;
    this.chosen = chosen;
    this.selects = { rows, columns, points, width };
    this.painting = 0;
    coordinates.forEach(({ description }, i) => {
      const text = description.replace(" at the last apex", "").toLowerCase();
      rows.append(new Option(text, i, i === 0, i === 0));
      columns.append(new Option(text, i, i === 1, i === 1));
    });
    keepApart(rows, columns);
    FATES.forEach(({ text, colour }) => legend.append(legendItem(text, colour)));
    this.surface = new Surface(canvas, () => this.draw());
    canvas.addEventListener("click", (event) => this.click(this.surface.at(event)));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /**
   * Paints the region of a gait.
   * @param {Pool} pool
   * @param {Object<string, number>} given Parameters and inputs.
   * @param {Gait} gait
   * @returns {Promise<boolean>} False where another painting has begun meanwhile.
   */
  async paint(pool, given, gait) {
    const painting = ++this.painting;
    this.map = null;
    const finest = Number(this.selects.points.value);
    for (const count of [...COARSE.filter((coarse) => coarse < finest), finest]) {
      await this.paintGrid({ pool, given, gait, count, painting });
      if (painting !== this.painting) {
        return false;
      }
      performance.mark("region painted", { detail: count });
    }
    return true;
  }

  /** One grid of so many points each way over what was painted before. */
  async paintGrid({ pool, given, gait, count, painting }) {
    const axes = [Number(this.selects.rows.value), Number(this.selects.columns.value)];
    const width = Number(this.selects.width.value);
    const scales = this.core.sectionScales;
    const [rows, columns] = axes.map((axis) => spaced(rangeAround(gait.apex, scales, axis, width), count));
    const under = this.map ? this.image : null;
    this.map = { axes, rows, columns, apex: gait.apex, under, fates: new Int32Array(count * count).fill(-1) };
    this.map.strides = new Int32Array(count * count);
    this.cross = [gait.apex[axes[1]], gait.apex[axes[0]]];
    const blocks = Array.from({ length: Math.ceil(count / ROWS_AT_ONCE) }, (_, i) => i * ROWS_AT_ONCE);
    const work = async (hand) => {
      for (await seen(); blocks.length && painting === this.painting; await seen()) {
        const first = blocks.shift();
        const from = this.starts(first, Math.min(first + ROWS_AT_ONCE, count));
        const found = await hand.run("block", { given, apex: gait.apex, from, rules: RULES });
        if (painting === this.painting) {
          this.fill(first * count, found);
        }
      }
    };
    await Promise.all(pool.hands.map(work));
  }

  /** What is painted is of another runner from now on, and faint; what is being painted is given up. */
  outdate() {
    this.painting += 1;
    if (this.map) {
      this.map.outdated = true;
    }
    this.draw();
  }

  starts(first, end) {
    const { rows, columns } = this.map;
    return rows.slice(first, end).flatMap((row) => columns.map((column) => this.apexAt(column, row)));
  }

  apexAt(column, row) {
    const apex = [...this.map.apex];
    [apex[this.map.axes[0]], apex[this.map.axes[1]]] = [row, column];
    return apex;
  }

  fill(offset, found) {
    for (let i = 0; i < found.length / 2; ++i) {
      this.map.fates[offset + i] = found[2 * i];
      this.map.strides[offset + i] = found[2 * i + 1];
    }
    this.map.image = null;
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.draw();
    });
  }

  /** Share of the starts that settle. */
  get settledShare() {
    const { fates } = this.map;
    return fates.filter((fate) => fate === 0).length / fates.length;
  }

  /** The map as a picture of one pixel to a start. */
  get image() {
    const { rows, columns, fates, strides } = this.map;
    const canvas = Object.assign(document.createElement("canvas"), { width: columns.length, height: rows.length });
    const context = canvas.getContext("2d");
    const colours = palette();
    const most = FATES.map((_, fate) => Math.max(1, ...strides.filter((_s, i) => fates[i] === fate)));
    fates.forEach((fate, i) => {
      if (fate >= 0) {
        context.globalAlpha = fate < 2 ? 1 - 0.72 * (strides[i] / most[fate]) ** 0.6 : 1;
        context.fillStyle = colours[FATES[fate].colour];
        context.fillRect(i % columns.length, rows.length - 1 - Math.floor(i / columns.length), 1, 1);
      }
    });
    return canvas;
  }

  /** Paints what is known in the colours that are in force now. */
  redraw() {
    if (this.map) {
      this.map.image = this.map.under = null;
    }
    this.draw();
  }

  draw() {
    const context = this.surface.clear();
    if (!this.map) {
      return;
    }
    const { width, height } = this.surface;
    const { rows, columns, axes: names } = this.map;
    const half = [columns, rows].map((along) => 0.5 * (along[1] - along[0]));
    this.axes = new Axes(context, { x: 0, y: 0, width, height }, {
      x: [columns[0] - half[0], columns.at(-1) + half[0]],
      y: [rows[0] - half[1], rows.at(-1) + half[1]],
      title: label(names[0]),
      labelX: label(names[1]),
    });
    const { axes } = this;
    axes.draw();
    context.imageSmoothingEnabled = false;
    this.map.image ??= this.image;
    context.globalAlpha = this.map.outdated ? OUTDATED : 1;
    for (const image of [this.map.under, this.map.image].filter(Boolean)) {
      context.drawImage(image, axes.left, axes.top, axes.right - axes.left, axes.bottom - axes.top);
    }
    context.globalAlpha = 1;
    this.mark(this.map.apex[names[1]], this.map.apex[names[0]], palette().card, palette().ink, 5);
    this.mark(...this.cross, palette().slip_positive, palette().card, 8);
  }

  /** A cross with a rim. */
  mark(x, y, colour, rim, size) {
    const { context } = this.surface;
    const at = [this.axes.x(x), this.axes.y(y)];
    for (const [stroke, width] of [[rim, 4.5], [colour, 2]]) {
      context.strokeStyle = stroke;
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(at[0] - size, at[1]);
      context.lineTo(at[0] + size, at[1]);
      context.moveTo(at[0], at[1] - size);
      context.lineTo(at[0], at[1] + size);
      context.stroke();
    }
  }

  click({ x, y }) {
    if (this.map) {
      this.start(this.axes.valueAtX(x), this.axes.valueAtY(y));
    }
  }

  start(column, row) {
    this.cross = [column, row];
    this.draw();
    this.chosen(this.apexAt(column, row));
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (this.map && steps) {
      event.preventDefault();
      const { columns, rows } = this.map;
      const ends = [columns, rows].map((along) => [along[0], along.at(-1), along[1] - along[0]]);
      this.cross = this.cross.map((value, i) =>
        Math.max(ends[i][0], Math.min(ends[i][1], value + steps[i] * ends[i][2])),
      );
      this.draw();
    } else if (this.map && event.key === "Enter") {
      this.start(...this.cross);
    }
  }

  /** The map for scripts: names and values of both axes, fates by name, strides. */
  get read() {
    const { axes, rows, columns, fates, strides } = this.map;
    return {
      axes: axes.map((axis) => NAMES[axis]),
      rows,
      columns,
      fates: Array.from(fates, (fate) => FATES[fate]?.name ?? ""),
      strides: Array.from(strides),
    };
  }
}

/** Two axes are never the same: the other one takes what this one had. */
function keepApart(...selects) {
  let before = selects.map(({ value }) => value);
  selects.forEach((select, i) => {
    select.addEventListener("change", () => {
      if (select.value === selects[1 - i].value) {
        selects[1 - i].value = before[i];
      }
      before = selects.map(({ value }) => value);
    });
  });
}

function label(axis) {
  const { description, unit } = coordinates[axis];
  return `${description.replace(" at the last apex", "").toLowerCase()}, ${printed(unit)}`;
}

function legendItem(text, colour) {
  const item = document.createElement("li");
  const dot = document.createElement("i");
  dot.style.background = `var(--${colour})`;
  item.append(dot, text);
  return item;
}

/** An apex in words. */
export function apexText(apex) {
  return coordinates.map(({ unit }, i) => `${NAMES[i]} ${digits(apex[i], 4)} ${printed(unit)}`).join(", ");
}
