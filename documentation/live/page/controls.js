/**
 * A slider and a field for every parameter, input and start value of the model description.
 * @module
 */
import { dimensions, presets, starts, values } from "./data.js";
import { numberIn, shownUnit, shownValue, unitElement } from "./numbers.js";

const SLIDER_STEPS = 1000;
const SPAN = 10; // of a slider about a positive value, each way
const groupOf = ({ name }) => (name.includes(".") ? name.split(".")[0] : "world");

/** How large a value of a unit is, in a runner: k l0 for a force and so on. */
function scaleOf(unit, state) {
  const mass = state["body.mass"];
  const scales = [state["leg.free_length"], Math.sqrt(mass / state["leg.stiffness"]), mass];
  return scales.reduce((product, scale, i) => product * scale ** (dimensions[unit]?.[i] ?? 0), 1);
}

/** Variables in ascending order: the core refuses one that is beyond its neighbour. */
const ASCENDING = ["ground.patch_begin", "ground.patch_end"];

/** A variable's range, and within it that to the neighbours it is ordered with. */
function rangeOf({ name, min = -Infinity, max = Infinity }, state) {
  const index = ASCENDING.indexOf(name);
  if (index < 0) {
    return { min, max };
  }
  return {
    min: Math.max(min, state[ASCENDING[index - 1]] ?? min),
    max: Math.min(max, state[ASCENDING[index + 1]] ?? max),
  };
}

/** Ends of a slider: the variable's range, narrowed about the value that a preset gives it. */
function sliderRange(variable, value, state) {
  const { unit } = variable;
  const { min, max } = rangeOf(variable, state);
  if (value > 0 && min >= 0) {
    return { low: Math.max(min, value / SPAN), high: Math.min(max, value * SPAN), log: true };
  }
  const reach = value === 0 ? 0.3 * scaleOf(unit, state) : 3 * Math.abs(value);
  return { low: Math.max(min, -reach), high: Math.min(max, reach), log: false };
}

/** A control's row: the name, what sets it, and a note that describes it. */
function rowOf({ name, description }, inputs, range, unit = "") {
  const field = inputs.find(({ id }) => id);
  const label = element("label", { htmlFor: field.id });
  label.append(element("code", { textContent: name }));
  const head = element("div", { className: "name" });
  head.append(label);
  const set = element("div", { className: "set" });
  set.append(...inputs);
  const note = element("p", { id: `${field.id}-note`, textContent: `${description}; ${range}` });
  if (unit) {
    note.append(" ", unitElement("span", unit));
  }
  field.setAttribute("aria-describedby", note.id);
  const row = element("div", { className: "control" });
  row.append(head, set, note);
  return row;
}

const idOf = ({ name }) => `value-${name}`;

/** A checkbox for a Boolean, whose value is 1 or 0. */
class Flag {
  constructor(variable, changed) {
    this.box = element("input", { type: "checkbox", id: idOf(variable), name: variable.name });
    this.element = rowOf(variable, [this.box], `default ${shownValue(variable, variable.start)}`);
    this.box.addEventListener("change", () => changed(variable.name, Number(this.box.checked)));
  }

  centre() {} // it has no slider

  show(value) {
    this.box.checked = value !== 0;
  }

  refuse() {} // both of its values are allowed
}

/** A slider and a field for a number. */
class Control {
  constructor(variable, changed) {
    this.variable = variable;
    this.shown = shownUnit(variable.unit);
    this.slider = element("input", { type: "range", min: 0, max: SLIDER_STEPS, step: 1 });
    this.slider.setAttribute("aria-label", `${variable.name}, slider`);
    this.field = element("input", { type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false });
    Object.assign(this.field, { id: idOf(variable), name: variable.name });
    const unit = unitElement("span", this.shown.name);
    this.element = rowOf(variable, [this.slider, this.field, unit], this.range, this.shown.name);
    this.slider.addEventListener("input", () => changed(variable.name, this.sliderValue()));
    this.field.addEventListener("change", () => changed(variable.name, this.fieldValue()));
  }

  /** Default and range in words. */
  get range() {
    const { min, max, start } = this.variable;
    const text = (value) => shortest(value * this.shown.factor);
    return `default ${text(start)}, from ${text(min)} to ${text(max)}`.replaceAll("-", "−");
  }

  /** What the field says, in the variable's unit; not a number where it says none. */
  fieldValue() {
    return numberIn(this.field.value) / this.shown.factor;
  }

  sliderValue() {
    const { low, high, log } = this.reach;
    const share = Number(this.slider.value) / SLIDER_STEPS;
    const value = log ? low * (high / low) ** share : low + share * (high - low);
    const { factor } = this.shown; // few digits where people read them, and never beyond an end by rounding
    return Math.max(low, Math.min(high, Number((value * factor).toPrecision(4)) / factor));
  }

  /** About which value the slider reaches. */
  centre(value, state) {
    this.reach = sliderRange(this.variable, value, state);
  }

  /** A value beyond what the slider reaches becomes its middle. */
  show(value, state) {
    if (value < this.reach.low || value > this.reach.high) {
      this.centre(value, state);
    }
    const { low, high, log } = this.reach;
    const share = log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    this.slider.value = SLIDER_STEPS * Math.max(0, Math.min(1, share));
    this.slider.setAttribute("aria-valuetext", shownValue(this.variable, value));
    this.field.value = String(Number((value * this.shown.factor).toPrecision(7)));
    this.field.removeAttribute("aria-invalid");
  }

  refuse() {
    this.field.setAttribute("aria-invalid", "true");
  }
}

/** A number in few characters. */
function shortest(value) {
  const number = Number(value.toPrecision(6));
  return (Math.abs(number) >= 1e5 ? number.toExponential() : String(number)).replace("e+", "e");
}

function element(tag, properties) {
  return Object.assign(document.createElement(tag), properties);
}

/** All controls, in groups by the first part of their names. */
export class Controls {
  /**
   * @param {HTMLElement} parent
   * @param {function(string, number): void} changed Is told a name and a value, which may be refused.
   */
  constructor(parent, changed) {
    this.all = new Map();
    this.groups = [];
    for (const [title, variables] of [...grouped(values), ["start of the run", starts]]) {
      const group = element("details", {});
      group.append(element("summary", { textContent: title }));
      for (const variable of variables) {
        const control = variable.isFlag ? new Flag(variable, changed) : new Control(variable, changed);
        this.all.set(variable.name, control);
        group.append(control.element);
      }
      parent.append(group);
      this.groups.push(group);
    }
  }

  /** Shows only what has a text in its name or description, unfolded; all of it, folded, for an empty text. */
  filter(text) {
    const wanted = text.trim().toLowerCase();
    for (const group of this.groups) {
      const found = [...group.querySelectorAll(".control")].filter((row) => {
        row.hidden = !row.textContent.toLowerCase().includes(wanted);
        return !row.hidden;
      });
      group.hidden = found.length === 0;
      group.open = wanted !== "" && found.length > 0;
    }
  }

  /** Sliders reach about these values from now on. */
  centre(state) {
    this.all.forEach((control, name) => control.centre(state[name], state));
  }

  show(state) {
    this.all.forEach((control, name) => control.show(state[name], state));
  }

  refuse(name) {
    this.all.get(name)?.refuse();
  }
}

/** Variables by group; what can change in a run comes first. */
function grouped(variables) {
  const groups = new Map();
  const inputsFirst = variables.toSorted((a, b) => (b.causality === "input") - (a.causality === "input"));
  for (const variable of inputsFirst) {
    const name = groupOf(variable);
    groups.set(name, [...(groups.get(name) ?? []), variable]);
  }
  return groups;
}

/** Fills the list of presets; `chosen` is handed one of them. */
export function fillPresets(select, chosen) {
  select.append(new Option("– choose –", ""));
  presets.forEach(({ name, word }, i) => {
    select.append(new Option(word ? `${name}: ${word.replaceAll("-", "−")}` : name, i));
  });
  select.addEventListener("change", () => select.value !== "" && chosen(presets[Number(select.value)]));
}
