/**
 * What the page says in sentences: what is wrong, above everything, and what has happened, to a screen reader.
 * @module
 */

/** An element of the page by its id. */
export const $ = (id) => document.getElementById(id);

/** @param {string} problem Why something was refused, or went wrong; empty if nothing did. */
export function report(problem) {
  $("problem").textContent = problem;
  $("problem").hidden = !problem;
}

/** @param {string} text What a screen reader reads out. */
export function announce(text) {
  $("announcement").textContent = text;
}

/**
 * What goes wrong where nobody expects it is told, too, and the page goes on to answer.
 * @param {function(): (void|Promise<void>)} work
 * @returns {Promise<boolean>} Whether it was done.
 */
export async function guarded(work) {
  try {
    await work();
    return true;
  } catch (problem) {
    report(`Something went wrong: ${problem.message ?? problem}`);
    console.error(problem);
    return false;
  }
}
