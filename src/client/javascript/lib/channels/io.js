// What all sockets of a node share: time, chance, and whether they keep the program alive.
import { systemClock, Timers } from './clock.js';

export class Io {
  #handles = new Set();
  #groups = new Set();
  #isKeptAlive = true;

  constructor({ clock = systemClock, random = Math.random } = {}) {
    this.clock = clock;
    this.random = random;
  }

  /** Timers that end together. */
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

  /** Fulfilled with the promise, or after so many milliseconds. */
  async within(milliseconds, promise) {
    let timer;
    const late = new Promise((resolve) => {
      timer = this.clock.after(milliseconds, resolve);
    });
    await Promise.race([promise, late]);
    this.clock.clear(timer);
  }

  /** A socket or server, until it closes. */
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
