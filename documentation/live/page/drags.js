/**
 * Drags across a canvas: of a mouse at once; of a finger where it taps or moves across, as upward it scrolls the page.
 * @module
 */
const SWIPE = 6; // px after which a finger has shown where it goes

/**
 * @param {HTMLCanvasElement} canvas
 * @param {function(PointerEvent): void} drag Is told each place.
 */
export function listenToDrags(canvas, drag) {
  let down = null; // a finger that has not shown yet where it goes
  let dragging = null;
  const follow = (event) => {
    dragging = event.pointerId;
    canvas.setPointerCapture(dragging);
    drag(event);
  };
  const end = () => {
    down = dragging = null;
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") {
      down = event;
    } else {
      follow(event);
    }
  });
  canvas.addEventListener("pointermove", (event) => {
    if (dragging === event.pointerId) {
      drag(event);
    } else if (down?.pointerId === event.pointerId) {
      const [across, upward] = [event.clientX - down.clientX, event.clientY - down.clientY].map(Math.abs);
      if (Math.max(across, upward) > SWIPE) {
        down = null;
        if (across > upward) {
          follow(event);
        }
      }
    }
  });
  canvas.addEventListener("pointerup", (event) => {
    if (down?.pointerId === event.pointerId) {
      drag(event);
    }
    end();
  });
  canvas.addEventListener("pointercancel", end);
}
