// Which messages of a life are new: each is delivered once and in order, and what is missing between two is counted.
import { maxRemembered } from './limits.js';

/** The last sequence that a subscriber delivered of each life, for the `maxRemembered` lives that were heard last. */
export class Sequence {
  #lives = new Map();

  /** How many messages are missing before this one; undefined where it is not newer than the last one of its life. */
  take(life, sequence) {
    const heard = this.#lives.get(life);
    if (sequence === 0n || (heard && sequence <= heard.last)) return undefined;
    if (heard) this.#lives.delete(life);
    else if (this.#lives.size >= maxRemembered) this.#lives.delete(this.#lives.keys().next().value);
    this.#lives.set(life, { last: sequence, isInterrupted: false });
    return !heard || heard.isInterrupted ? 0n : sequence - heard.last - 1n;
  }

  /** How many messages are missing up to the last one of a life that has ended. */
  missedAtEnd(life, last) {
    const heard = this.#lives.get(life);
    return !heard || heard.isInterrupted || last <= heard.last ? 0n : last - heard.last;
  }

  /** The channel was closed: what is sent until it is made again is not missed. */
  interrupt(life) {
    const heard = this.#lives.get(life);
    if (heard) heard.isInterrupted = true;
  }
}
