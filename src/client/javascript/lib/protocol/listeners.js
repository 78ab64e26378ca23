// The listeners of a stream over UDP: those that said hello within the last seconds.
import { place } from './address.js';
import * as limits from './limits.js';
import { Places } from './places.js';

/**
 * By address and port: `{address, port, life, challenge, heard, counter}`. `counter` is that of its last sealed frame, 0n if
 * that was plain. Time is milliseconds that never go back.
 */
export class Listeners {
  #heard = new Map();
  #places = new Places(limits.maxListeners);

  get size() {
    return this.#heard.size;
  }

  get places() {
    return this.#places;
  }

  values() {
    return this.#heard.values();
  }

  get(address, port) {
    return this.#heard.get(place(address, port));
  }

  /** A new listener: `{isTaken, loser}`, whether there is a place for it, and the listener that loses its own. */
  add(listener) {
    const where = place(listener.address, listener.port);
    this.end(listener);
    const { isTaken, loser } = this.#places.take(where, listener.address);
    const lost = this.#heard.get(loser);
    this.#heard.delete(loser);
    if (isTaken) this.#heard.set(where, listener);
    return { isTaken, loser: lost };
  }

  end({ address, port }) {
    const where = place(address, port);
    this.#heard.delete(where);
    this.#places.leave(where);
  }

  /** Forgets those that have been silent for too long. */
  expire(now) {
    for (const listener of this.#heard.values()) if (now - listener.heard >= limits.listenerPatience) this.end(listener);
  }
}
