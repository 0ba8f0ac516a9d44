/**
 * Canvases in CSS pixels, sharp on every screen.
 * @module
 */

/** A canvas that keeps the size of its box. */
export class Surface {
  constructor(element, resized = () => {}) {
    this.element = element;
    this.context = element.getContext("2d");
    this.width = 0;
    this.height = 0;
    new ResizeObserver(() => {
      this.fit();
      resized();
    }).observe(element);
    this.fit();
  }

  fit() {
    const box = this.element.getBoundingClientRect();
    const ratio = Math.min(devicePixelRatio || 1, 2);
    this.width = box.width;
    this.height = box.height;
    this.element.width = Math.round(box.width * ratio);
    this.element.height = Math.round(box.height * ratio);
    this.ratio = ratio;
  }

  /** An empty context to draw on. */
  clear() {
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.context.clearRect(0, 0, this.width, this.height);
    return this.context;
  }

  /** Where an event of a pointer is, in CSS pixels of the canvas. */
  at(event) {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}
