/**
 * Expensive pictures wait until the page is visible.
 * @module
 */

/** @returns {Promise<void>} Fulfilled as soon as the page is visible. */
export async function seen() {
  while (document.hidden) {
    await new Promise((resolve) => {
      document.addEventListener("visibilitychange", resolve, { once: true });
    });
  }
}
