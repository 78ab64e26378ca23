// The ends that providers have said, until the daemon confirms them (src/client/CHANNELS.md, "How a channel ends").
import { endHintPatience } from './limits.js';

/** The ends of one subscriber's channels. Hook: `onLasting(event)`, a match has lasted for 10 s after the end of its provider. */
export class Endings {
  #timers;
  #onLasting;
  /** By life: the last sequence that an end without a key named, and when that came. */
  #hints = new Map();
  /** By the daemon's word: the event of a match whose provider has ended, and its timer. */
  #matches = new Map();

  constructor(timers, onLasting) {
    this.#timers = timers;
    this.#onLasting = onLasting;
  }

  /** An end came that anybody may have forged. */
  say(life, last) {
    this.#hints.set(life, { last, at: this.#timers.now() });
  }

  /** The last sequence that such an end named in the last 10 s; undefined if there was none. */
  lastOf(life) {
    const hint = this.#hints.get(life);
    return hint && this.#timers.now() - hint.at < endHintPatience ? hint.last : undefined;
  }

  /** The channel has ended. */
  forget(life) {
    this.#hints.delete(life);
  }

  /** A provider has ended whose matches last. */
  keepMatches(events) {
    for (const event of events) {
      this.#take(event.service);
      const timer = this.#timers.after(endHintPatience, () => this.#onLasting({ ...this.#take(event.service), change: 'add' }));
      this.#matches.set(event.service, { event, timer });
    }
  }

  /** The daemon says something of a match: whether it is of one whose provider has ended, and goes on so. */
  onEvent(event) {
    const kept = this.#matches.get(event.service);
    if (kept && event.change === 'modify') {
      kept.event = event;
      return true;
    }
    this.#take(event.service);
    return false;
  }

  /** The daemon is gone, or the subscriber is closed. */
  forgetMatches() {
    for (const service of [...this.#matches.keys()]) this.#take(service);
  }

  #take(service) {
    const kept = this.#matches.get(service);
    this.#timers.clear(kept?.timer);
    this.#matches.delete(service);
    return kept?.event;
  }
}
