/**
 * A video of some strides of the scene, as a file.
 * @module
 */
import { announce, report } from "./messages.js";

const STRIDES = 3;
const FRAMES = 30; // in a second

export class Video {
  /**
   * @param {HTMLButtonElement} button
   * @param {HTMLCanvasElement} canvas
   * @param {Run} run
   * @param {Player} player
   */
  constructor(button, canvas, run, player) {
    Object.assign(this, { button, canvas, run, player, recorder: null });
    player.followers.push(() => this.follow());
  }

  /** Records from now on, as fast as the run is shown; the run goes on. */
  start() {
    if (!globalThis.MediaRecorder || !this.canvas.captureStream) {
      report("This browser cannot record a video of the scene.");
      return;
    }
    this.until = this.run.outputs["stride.count"] + STRIDES;
    this.recorder = new MediaRecorder(this.canvas.captureStream(FRAMES));
    const parts = [];
    this.recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    this.recorder.addEventListener("stop", () => this.save(new Blob(parts, { type: this.recorder.mimeType })));
    this.recorder.start();
    this.show(`Recording ${STRIDES} strides …`, true);
    this.player.play(true);
  }

  /** Ends the recording after so many strides, or with the run. */
  follow() {
    const done = this.run.over || this.run.outputs["stride.count"] >= this.until;
    if (this.recorder?.state === "recording" && done) {
      this.recorder.stop();
    }
  }

  save(video) {
    const type = video.type.includes("mp4") ? "mp4" : "webm";
    const link = Object.assign(document.createElement("a"), { download: `tdmf-slip.${type}` });
    link.href = URL.createObjectURL(video);
    link.click();
    this.saved = { type, size: video.size };
    this.recorder = null;
    this.show("Save a video", false);
    announce("The video was saved");
  }

  show(text, disabled) {
    Object.assign(this.button, { textContent: text, disabled });
  }
}
