/**
 * The gait in numbers, and its eigenvalues in the unit circle.
 * @module
 */
import { Surface } from "./canvas.js";
import { mark } from "./glossary.js";
import { digits, shownWord, unitElement, withoutNoise } from "./numbers.js";
import { palette } from "./theme.js";

const ROWS = [
  ["word", "gait word", ""],
  ["stride.period", "period", "s"],
  ["stride.speed", "speed", "m/s"],
  ["stride.length", "stride length", "m"],
  ["stride.cost_of_transport", "cost of transport", ""],
  ["stride.slip_distance", "slip in a stride", "m"],
  ["lambda_max", "largest eigenvalue", ""],
  ["stable", "the gait is", ""],
];
const RING = 72; // px
const TERM_OF = { word: "word", "hip.phase": "hip", "contact.mode": "stick", lambda_max: "eigenvalue" };

const sizeOf = ([re, im]) => Math.hypot(re, im);
export const lambdaMax = (gait) => sizeOf(gait.eigenvalues[0]);

/** A list of named numbers that are written over, not made anew. */
export class Numbers {
  constructor(list, rows) {
    this.cells = new Map(rows.map(([name, title, unit]) => [name, this.row(list, name, title, unit)]));
  }

  row(list, name, title, unit) {
    const box = document.createElement("div");
    const term = document.createElement("dt");
    term.textContent = title;
    mark(term, TERM_OF[name]);
    const value = document.createElement("dd");
    value.dataset.name = name;
    const text = document.createTextNode("–");
    value.append(text);
    if (unit) {
      value.append(unitElement("small", unit));
    }
    box.append(term, value);
    list.append(box);
    return { value, text };
  }

  /** @param {number|string} exact Kept in `data-value`, every digit of it. */
  show(name, exact, text) {
    const cell = this.cells.get(name);
    cell.text.data = text;
    cell.value.dataset.value = exact;
    cell.value.title = String(exact);
    cell.value.classList.toggle("word", name === "word");
  }
}

export class GaitPanel {
  constructor(list, circle, eigenvalues) {
    this.numbers = new Numbers(list, ROWS);
    this.surface = new Surface(circle, () => this.drawCircle());
    this.list = eigenvalues;
    this.gait = null;
  }

  /** @param {?Gait} gait null while there is none. */
  show(gait) {
    this.gait = gait;
    for (const [name] of ROWS.filter(([row]) => row.startsWith("stride."))) {
      const value = gait?.stride[name] ?? NaN;
      const scale = name === "stride.slip_distance" ? gait?.stride["stride.length"] : 0;
      this.numbers.show(name, gait ? value : "", digits(withoutNoise(value, scale), 6));
    }
    this.numbers.show("word", gait?.word ?? "", shownWord(gait?.word));
    this.numbers.show("lambda_max", gait ? lambdaMax(gait) : "", digits(gait ? lambdaMax(gait) : NaN, 6));
    const stable = gait ? (lambdaMax(gait) < 1 ? "stable" : "unstable") : "";
    this.numbers.show("stable", stable, stable || "–");
    this.list.replaceChildren(...(gait?.eigenvalues ?? []).map(eigenvalueItem));
    this.drawCircle();
  }

  drawCircle() {
    const { soft, line, accent, bad, cone, sans } = palette();
    const context = this.surface.clear();
    const { width, height } = this.surface;
    const centre = [0.5 * width, 0.5 * height];
    const radius = Math.min(RING, 0.42 * Math.min(width, height));
    context.fillStyle = cone;
    context.strokeStyle = soft;
    context.lineWidth = 1;
    context.beginPath();
    context.arc(...centre, radius, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.strokeStyle = line;
    context.beginPath();
    context.moveTo(centre[0] - 1.15 * radius, centre[1]);
    context.lineTo(centre[0] + 1.15 * radius, centre[1]);
    context.moveTo(centre[0], centre[1] - 1.15 * radius);
    context.lineTo(centre[0], centre[1] + 1.15 * radius);
    context.stroke();
    context.font = `11px ${sans}`;
    context.fillStyle = soft;
    context.textAlign = "left";
    context.fillText("1", centre[0] + radius + 4, centre[1] - 4);
    for (const pair of this.gait?.eigenvalues ?? []) {
      const size = sizeOf(pair);
      const shown = size > 1.3 ? pair.map((part) => (1.3 * part) / size) : pair;
      context.fillStyle = size < 1 ? accent : bad;
      context.beginPath();
      context.arc(centre[0] + shown[0] * radius, centre[1] - shown[1] * radius, 4, 0, 2 * Math.PI);
      context.fill();
    }
  }
}

function eigenvalueItem([re, im]) {
  const item = document.createElement("li");
  item.dataset.re = re;
  item.dataset.im = im;
  const sign = im < 0 ? "−" : "+";
  const imaginary = withoutNoise(im, 1) ? ` ${sign} ${digits(Math.abs(im), 5)} i` : "";
  item.textContent = `${digits(withoutNoise(re, 1), 6)}${imaginary}`;
  return item;
}
