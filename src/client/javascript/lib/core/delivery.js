// Which messages of a life are delivered: each once, in order, with how many are missing between.
import { maxRemembered } from './limits.js';

/** What a subscriber remembers of one provider's messages. */
export class Track {
  /** The last sequence that was taken; undefined before the first. */
  #last;
  #isFresh = true;
  /** Missed by messages that the queue has pushed out since. */
  #lost = 0n;

  constructor(last) {
    this.#last = last;
  }

  get last() {
    return this.#last;
  }

  /** How many are missing before this one; undefined where it is not newer than the last. */
  take(sequence) {
    if (this.#last !== undefined && sequence <= this.#last) return undefined;
    if (sequence === 0n) return undefined;
    const missed = this.#isFresh ? 0n : sequence - this.#last - 1n;
    this.#last = sequence;
    this.#isFresh = false;
    return missed;
  }

  /** How many are missing up to the last one that there was. */
  finish(last) {
    return this.#isFresh || last <= this.#last ? 0n : last - this.#last;
  }

  /** One that was taken never reached the application. */
  lose(missed) {
    this.#lost += missed + 1n;
  }

  /** How many the application has missed before this one, all told. */
  missedBefore(missed) {
    const all = missed + this.#lost;
    this.#lost = 0n;
    return all;
  }
}

/** The last sequences of lives that are gone, so that none of their messages comes twice when they are back. */
export class Memory {
  #lasts = new Map();

  remember(life, last) {
    if (life === 0n || last === undefined) return;
    this.#lasts.delete(life);
    if (this.#lasts.size >= maxRemembered) this.#lasts.delete(this.#lasts.keys().next().value);
    this.#lasts.set(life, last);
  }

  lastOf(life) {
    return this.#lasts.get(life);
  }
}
