/**
 * Keys of the page. Those that a field or a button has a use for stay theirs.
 * @module
 */

/** @param {Object<string, function(): void>} actions By the key. */
export function listenToKeys(actions) {
  addEventListener("keydown", (event) => {
    const inField = event.target.closest("input:not([type=range]), select, textarea");
    const onButton = event.target.closest("button, summary, a") && event.key === " ";
    if (event.ctrlKey || event.metaKey || event.altKey || inField || onButton || !actions[event.key]) {
      return;
    }
    event.preventDefault();
    actions[event.key]();
  });
}
