// The listeners of a stream over UDP: those that said hello within the last seconds.
import { place } from './address.js';
import * as limits from './limits.js';

/** By address and port, with the time of the last hello. Time is milliseconds that never go back. */
export class Listeners {
  #heard = new Map();

  get size() {
    return this.#heard.size;
  }

  values() {
    return this.#heard.values();
  }

  /** A hello. False where there is no room for one more listener. */
  hello(address, port, now) {
    const where = place(address, port);
    if (!this.#heard.has(where) && this.size >= limits.maxListeners) this.expire(now);
    if (!this.#heard.has(where) && this.size >= limits.maxListeners) return false;
    this.#heard.set(where, { address, port, heard: now });
    return true;
  }

  end(address, port) {
    this.#heard.delete(place(address, port));
  }

  /** Forgets those that have been silent for too long. */
  expire(now) {
    for (const [where, { heard }] of this.#heard) {
      if (now - heard >= limits.listenerPatience) this.#heard.delete(where);
    }
  }
}
