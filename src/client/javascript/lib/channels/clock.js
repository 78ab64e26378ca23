// The clock of the library, and timers by it. Tests use a clock of their own.
export const systemClock = Object.freeze({
  /** Milliseconds that never go back. */
  now: () => performance.now(),
  /** Calls once. The result is for clear(), and has ref() and unref(). */
  after: (milliseconds, callback) => setTimeout(callback, milliseconds),
  clear: (timer) => clearTimeout(timer),
});

/** The timers of one owner, which are ended together and keep the program alive together, or not. */
export class Timers {
  #clock;
  #running = new Set();
  #isUnref = false;

  constructor(clock) {
    this.#clock = clock;
  }

  now() {
    return this.#clock.now();
  }

  after(milliseconds, callback) {
    const timer = this.#clock.after(milliseconds, () => {
      this.#running.delete(timer);
      callback();
    });
    this.#running.add(timer);
    if (this.#isUnref) timer.unref();
    return timer;
  }

  clear(timer) {
    if (timer === undefined) return;
    this.#clock.clear(timer);
    this.#running.delete(timer);
  }

  clearAll() {
    for (const timer of this.#running) this.#clock.clear(timer);
    this.#running.clear();
  }

  /** Sets whether a running timer keeps the program alive. */
  keepAlive(isWanted) {
    this.#isUnref = !isWanted;
    for (const timer of this.#running) isWanted ? timer.ref() : timer.unref();
  }
}
