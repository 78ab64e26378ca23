// The keys that the daemon has given for the providers of one subscriber.
import { maxKeptKeys } from './limits.js';

/** By life. The value is undefined for keys that cannot be used. */
export class ProviderKeys {
  #byLife = new Map();

  /** The keys of a life, or the default where the daemon has given none. */
  get(life, otherwise) {
    return this.#byLife.has(life) ? this.#byLife.get(life) : otherwise;
  }

  /** The daemon has given keys. Beyond the limit the first ones are forgotten of lives that `isKept` does not keep. */
  put(life, keys, isKept) {
    this.#byLife.delete(life);
    this.#byLife.set(life, keys);
    if (this.#byLife.size <= maxKeptKeys) return;
    const others = [...this.#byLife.keys()].filter((one) => one !== life && !isKept(one));
    if (others.length >= maxKeptKeys) this.#byLife.delete(others[0]);
  }

  clear() {
    this.#byLife.clear();
  }
}
