/**
 * Shapes of the scene, in pixels.
 * @module
 */
const COILS = 7;

/** A disc with a rim. */
export function disc(context, [x, y], radius, fill, rim) {
  context.fillStyle = fill;
  context.strokeStyle = rim;
  context.lineWidth = 1.6;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** A coil spring, straight at both ends. */
export function spring(context, from, to, width, colour) {
  const along = [to[0] - from[0], to[1] - from[1]];
  const size = Math.max(Math.hypot(...along), 1e-9);
  const across = [(-along[1] / size) * width, (along[0] / size) * width];
  const count = 24 * COILS;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.lineJoin = "round";
  context.beginPath();
  for (let i = 0; i <= count; ++i) {
    const share = i / count;
    const winding = Math.max(0, Math.min(1, (share - 0.2) / 0.55));
    const side = Math.sin(2 * Math.PI * COILS * winding);
    context.lineTo(from[0] + share * along[0] + side * across[0], from[1] + share * along[1] + side * across[1]);
  }
  context.stroke();
}
