/**
 * Messages of the page: problems, shown above everything else, and announcements for screen readers.
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
 * Does some work, and reports an unexpected error instead of leaving the page without an answer.
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
