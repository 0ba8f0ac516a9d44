/**
 * Pictures that cost much wait until somebody can see them.
 * @module
 */

/** @returns {Promise<void>} Kept as soon as the page is visible. */
export async function seen() {
  while (document.hidden) {
    await new Promise((resolve) => {
      document.addEventListener("visibilitychange", resolve, { once: true });
    });
  }
}
