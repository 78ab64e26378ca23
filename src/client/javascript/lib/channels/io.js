// The clock and the random numbers of a node, and whether its sockets keep the program alive.
import { systemClock, Timers } from './clock.js';

export class Io {
  #handles = new Set();
  #groups = new Set();
  #isKeptAlive = true;

  constructor({ clock = systemClock, random = Math.random } = {}) {
    this.clock = clock;
    this.random = random;
  }

  /** New timers, which end together. */
  timers() {
    const timers = new Timers(this.clock);
    timers.keepAlive(this.#isKeptAlive);
    this.#groups.add(timers);
    return timers;
  }

  forget(timers) {
    timers.clearAll();
    this.#groups.delete(timers);
  }

  /** Fulfilled when the promise is, or after so many milliseconds. */
  async within(milliseconds, promise) {
    let timer;
    const late = new Promise((resolve) => {
      timer = this.clock.after(milliseconds, resolve);
    });
    await Promise.race([promise, late]);
    this.clock.clear(timer);
  }

  /** Adds a socket or server, until it closes. */
  add(handle) {
    this.#handles.add(handle);
    handle.once('close', () => this.#handles.delete(handle));
    if (!this.#isKeptAlive) handle.unref();
    return handle;
  }

  keepAlive(isWanted) {
    this.#isKeptAlive = isWanted;
    for (const handle of this.#handles) isWanted ? handle.ref() : handle.unref();
    for (const timers of this.#groups) timers.keepAlive(isWanted);
  }
}
