/**
 * The patch of ground with a friction of its own.
 * @module
 */
import { palette } from "./theme.js";
import { digits } from "./numbers.js";

const LABELLED = 60; // px, the least width that has room for a name

/** @returns {[number, number]} Where it begins and ends, m; the same where there is none. */
function ends(given) {
  return [given["ground.patch_begin"] ?? 0, given["ground.patch_end"] ?? 0];
}

/** Friction of the ground below a foot at x, m. */
export function frictionBelow(given, x) {
  const [begin, end] = ends(given);
  return given[begin <= x && x < end ? "ground.patch_friction" : "ground.friction"];
}

/**
 * Draws the patch as a band below the ground's line.
 * @param {function(number): number} groundAt Height of the ground, m.
 */
export function drawPatch(context, given, { x, y }, groundAt, width) {
  const [begin, end] = ends(given);
  const left = Math.max(0, x(begin));
  const right = Math.min(width, x(end));
  if (!(left < right)) {
    return;
  }
  const { second, soft, sans } = palette();
  const back = (pixel) => begin + ((pixel - x(begin)) * (end - begin)) / (x(end) - x(begin));
  context.strokeStyle = second;
  context.lineWidth = 4;
  context.beginPath();
  context.moveTo(left, y(groundAt(back(left))));
  context.lineTo(right, y(groundAt(back(right))));
  context.stroke();
  if (right - left < LABELLED) {
    return;
  }
  context.font = `11px ${sans}`;
  context.fillStyle = soft;
  context.textAlign = "center";
  context.textBaseline = "bottom";
  const middle = 0.5 * (left + right);
  context.fillText(`μ ${digits(given["ground.patch_friction"])}`, middle, y(groundAt(back(middle))) - 5);
}
