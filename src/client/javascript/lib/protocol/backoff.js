// The wait before the next attempt to connect: .1, .2, .4, .8, 1, 1, ... s, each up to a quarter longer, by chance.
export class Backoff {
  #tries = 0;
  #random;

  constructor(random = Math.random) {
    this.#random = random;
  }

  /** Milliseconds until the next attempt. */
  next() {
    const base = Math.min(100 * 2 ** Math.min(this.#tries++, 10), 1000);
    return base * (1 + this.#random() / 4);
  }

  reset() {
    this.#tries = 0;
  }
}
