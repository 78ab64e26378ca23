// Which messages of a life are new, and how many are missing between two (src/client/CHANNELS.md, "Which message is new").
import * as limits from './limits.js';

const { maxRanges, maxRemembered, stragglerPatience } = limits;
const maxStep = BigInt(limits.maxStep);

/** One life: its last message, when that was, and what was delivered, as runs without a gap. */
class Heard {
  /** The dropped frame before, if none was delivered since. */
  straggler;
  /** The channel was closed, and has been made again. */
  isInterrupted = false;
  /** The last message came over TCP, or sealed. */
  isSure = false;

  constructor(sequence, now) {
    this.last = sequence;
    this.at = now;
    this.firsts = [sequence];
    this.ends = [sequence];
  }

  wasDelivered(sequence) {
    if (sequence > this.ends.at(-1)) return false;
    const at = this.#behind(sequence) - 1;
    return at >= 0 && sequence <= this.ends[at];
  }

  deliver(sequence, now) {
    Object.assign(this, { last: sequence, at: now, straggler: undefined, isInterrupted: false, isSure: false });
    const { firsts, ends } = this;
    if (ends.at(-1) + 1n === sequence) {
      ends[ends.length - 1] = sequence; // as nearly always
      return;
    }
    const at = this.#behind(sequence);
    const joinsLeft = at > 0 && ends[at - 1] + 1n === sequence;
    const joinsRight = at < firsts.length && firsts[at] === sequence + 1n;
    if (joinsLeft && joinsRight) {
      ends[at - 1] = ends[at];
      this.#forget(at);
    } else if (joinsLeft) {
      ends[at - 1] = sequence;
    } else if (joinsRight) {
      firsts[at] = sequence;
    } else {
      firsts.splice(at, 0, sequence);
      ends.splice(at, 0, sequence);
      if (firsts.length > maxRanges) this.#forgetShortest();
    }
  }

  /** How many runs begin at the sequence or below it. */
  #behind(sequence) {
    let low = 0;
    let high = this.firsts.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.firsts[middle] <= sequence) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #forgetShortest() {
    let shortest = 0;
    const length = (at) => this.ends[at] - this.firsts[at];
    for (let at = 1; at < this.firsts.length; ++at) if (length(at) < length(shortest)) shortest = at;
    this.#forget(shortest);
  }

  #forget(at) {
    this.firsts.splice(at, 1);
    this.ends.splice(at, 1);
  }
}

/** The messages that a subscriber delivered of each life, for the `maxRemembered` lives that were heard last. Time is milliseconds. */
export class Sequence {
  #lives = new Map();

  /** How many are missing before a message that came over UDP without a key; undefined where it is to be dropped. */
  take(life, sequence, now) {
    if (sequence === 0n) return undefined;
    const heard = this.#lives.get(life);
    if (!heard) {
      this.#remember(life, sequence, now);
      return 0n;
    }
    if (heard.wasDelivered(sequence)) return undefined;
    let missed = 0n;
    if (heard.last < sequence && sequence <= heard.last + maxStep && !heard.isInterrupted) {
      missed = sequence - heard.last - 1n;
    } else if (!heard.isInterrupted || sequence <= heard.last) {
      const before = heard.straggler;
      heard.straggler = sequence;
      if (now - heard.at < stragglerPatience || before === undefined) return undefined;
      if (before >= sequence || sequence > before + maxStep) return undefined;
    }
    heard.deliver(sequence, now);
    this.#touch(life, heard);
    return missed;
  }

  /** How many are missing before a message that came over TCP or sealed; undefined where it is not new. */
  takeSurely(life, sequence) {
    if (sequence === 0n) return undefined;
    const heard = this.#lives.get(life);
    if (!heard) {
      this.#remember(life, sequence, 0).isSure = true;
      return 0n;
    }
    let missed = sequence - heard.last - 1n;
    if (heard.isSure) {
      if (missed < 0n) return undefined;
    } else if (heard.wasDelivered(sequence)) {
      return undefined;
    } else if (missed < 0n || missed >= maxStep) {
      missed = 0n; // nobody can say whether the last message was forged
    }
    if (heard.isInterrupted) missed = 0n;
    Object.assign(heard, { last: sequence, isInterrupted: false, isSure: true, straggler: undefined });
    this.#touch(life, heard);
    return missed;
  }

  /** How many are missing up to the last message of a life that has ended. One that anybody may have forged counts up to a step. */
  missedAtEnd(life, last, isSure = true) {
    const heard = this.#lives.get(life);
    if (!heard || heard.isInterrupted || last <= heard.last) return 0n;
    const missed = last - heard.last;
    return isSure || missed <= maxStep ? missed : 0n;
  }

  /** The channel was closed: what is sent until it is made again is not missed. */
  interrupt(life) {
    const heard = this.#lives.get(life);
    if (heard) heard.isInterrupted = true;
  }

  #touch(life, heard) {
    this.#lives.delete(life);
    this.#lives.set(life, heard);
  }

  #remember(life, sequence, now) {
    if (this.#lives.size >= maxRemembered) this.#lives.delete(this.#lives.keys().next().value);
    const heard = new Heard(sequence, now);
    this.#lives.set(life, heard);
    return heard;
  }
}
