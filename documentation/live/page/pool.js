/**
 * Workers that share out jobs among them.
 * @module
 */

/** One worker, and the jobs that it was given. */
class Hand {
  constructor(module) {
    this.jobs = new Map();
    this.count = 0;
    this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker.addEventListener("message", ({ data }) => this.answer(data));
    this.worker.addEventListener("error", (event) => this.fail(event.message || "a worker stopped"));
    this.ready = this.run("start", { module });
  }

  run(name, job, onPart = () => {}) {
    const number = ++this.count;
    return new Promise((resolve, reject) => {
      this.jobs.set(number, { resolve, reject, onPart });
      this.worker.postMessage({ number, name, job });
    });
  }

  answer({ number, part, result, problem }) {
    const job = this.jobs.get(number);
    if (part !== undefined) {
      job.onPart(part);
      return;
    }
    this.jobs.delete(number);
    if (problem === undefined) {
      job.resolve(result);
    } else {
      job.reject(new Error(problem));
    }
  }

  fail(message) {
    this.jobs.forEach(({ reject }) => reject(new Error(message)));
    this.jobs.clear();
  }
}

/** How many workers this machine has a use for. */
export function processors() {
  return Math.max(1, Math.min(4, navigator.hardwareConcurrency || 2));
}

/** Workers that are alike. */
export class Pool {
  /**
   * @param {WebAssembly.Module} module The core's.
   * @param {number} count Of workers.
   */
  constructor(module, count) {
    this.module = module;
    this.hands = Array.from({ length: count }, () => new Hand(module));
    this.ready = Promise.all(this.hands.map((hand) => hand.ready));
  }

  /** Whoever has least to do. */
  get idlest() {
    return this.hands.reduce((best, hand) => (hand.jobs.size < best.jobs.size ? hand : best));
  }

  /**
   * @param {string} name One of the worker's jobs.
   * @param {object} job What it is given.
   * @param {function(object): void} [onPart] Is handed what comes before the end.
   * @returns {Promise<object>} Its result.
   */
  run(name, job, onPart) {
    return this.idlest.run(name, job, onPart);
  }

  /** Nobody waits for what is under way: it is given up, and will never be answered. */
  abandon() {
    this.hands = this.hands.map((hand) => {
      if (hand.jobs.size === 0) {
        return hand;
      }
      hand.worker.terminate();
      return new Hand(this.module);
    });
  }
}
