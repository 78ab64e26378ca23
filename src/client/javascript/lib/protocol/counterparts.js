// The counterparts of a channel: the providers of a subscriber, or the consumers of a publisher, by their lives.
import { lifeOf, lifeText } from './life.js';
import * as limits from './limits.js';

const closing = new Set(['outranked', 'changed']);

/** The states of a counterpart. */
const states = Object.freeze({
  /** A daemon matches it. */
  matched: 'matched',
  /** The own daemon is away, or has not confirmed it since it is back. */
  doubted: 'doubted',
  /** The daemons have lost sight of it. */
  orphan: 'orphan',
  /** It was withdrawn, and only messages on their way still come. */
  ending: 'ending',
});

/** One counterpart. `life` is 0n if no library with channels made it. */
class Counterpart {
  /** The daemon's words under which it is matched, each with the last event. */
  words = new Map();
  state = states.matched;
  /** The reason of the daemon why it is gone. */
  reason;
  timer;

  constructor(key, life, event) {
    this.key = key;
    this.life = life;
    this.event = event;
  }

  get service() {
    return this.event.service;
  }

  /** Whether a daemon matches it, as far as is known. */
  get isMatched() {
    return this.state === states.matched || this.state === states.doubted;
  }

  get isEnding() {
    return this.state === states.ending;
  }
}

/** Whether two events are equal for the application. */
function isSame(a, b) {
  const visible = ({ id, change, service, peer, ...rest }) => JSON.stringify(rest);
  return visible(a) === visible(b);
}

/**
 * Decides how long a channel outlives its match (src/client/CHANNELS.md, "How a channel ends"). Hooks: `added(counterpart)`,
 * `modified(counterpart, before, isTold)` and `removed(counterpart, reason)`. `reasonOf(counterpart, reason)` gives the reason
 * of a `del` as it counts. `orphanPatience(counterpart)` gives the milliseconds that an orphan goes on, Infinity for as long as
 * its connection. `endPatience(counterpart)` gives the milliseconds of waiting for more of a withdrawn one, which is not over
 * while `isHeld(counterpart)`. `isOfPublisher` tells whether they are consumers.
 */
export class Counterparts {
  #counterparts = new Map();
  /** By the daemon's word. */
  #services = new Map();
  #hooks;
  #timers;
  #confirmation;
  /** The largest number of counterparts; 0: all. */
  limit = 0;
  #backAt = -Infinity;

  constructor(timers, hooks) {
    this.#timers = timers;
    this.#hooks = hooks;
  }

  /**
   * Whether a consumer that is outranked may still be there. When daemons have come back, its own one may still name the provider
   * by its former word, so that the word of today seems to be outranked by it.
   */
  get #doubtsOutranked() {
    return this.#hooks.isOfPublisher && this.#timers.now() - this.#backAt < limits.confirmPatience;
  }

  get size() {
    return this.#counterparts.size;
  }

  [Symbol.iterator]() {
    return [...this.#counterparts.values()][Symbol.iterator]();
  }

  /** The counterpart with a life that is not 0n. */
  find(life) {
    return this.#counterparts.get(lifeText(life));
  }

  onEvent(event) {
    if (event.change === 'del') this.#onDel(event);
    else if (event.change === 'add' || this.#services.has(event.service)) this.#onState(event);
    this.#closeSurplus();
  }

  /** The own daemon is gone. All channels go on, also those that the daemons had lost sight of, since nobody can confirm them. */
  onDaemonLost() {
    this.#timers.clear(this.#confirmation);
    this.#services.clear();
    for (const counterpart of this.#counterparts.values()) {
      counterpart.words.clear();
      if (counterpart.isEnding) continue;
      this.#timers.clear(counterpart.timer);
      counterpart.state = states.doubted;
    }
  }

  /** The own daemon is back. Counterparts that it does not confirm in time become orphans. */
  onDaemonBack() {
    this.#timers.clear(this.#confirmation);
    this.#backAt = this.#timers.now();
    if (this.#counterparts.size === 0) return;
    this.#confirmation = this.#timers.after(limits.confirmPatience, () => {
      for (const counterpart of this) {
        if (counterpart.state === states.doubted) this.#orphan(counterpart, 'disconnected');
      }
      this.#closeSurplus();
    });
  }

  /** Ends the channel of a counterpart, whatever the daemon says. */
  remove(counterpart, reason) {
    if (this.#counterparts.get(counterpart.key) !== counterpart) return;
    this.#timers.clear(counterpart.timer);
    this.#counterparts.delete(counterpart.key);
    for (const word of counterpart.words.keys()) this.#services.delete(word);
    this.#hooks.removed(counterpart, reason);
  }

  /** A withdrawn counterpart sent something: its time begins anew. */
  touch(counterpart) {
    if (!counterpart.isEnding) return;
    this.#timers.clear(counterpart.timer);
    this.#awaitEnd(counterpart);
  }

  /** Ends all channels, because the daemon no longer has the request. */
  removeAll(reason) {
    for (const counterpart of this) this.remove(counterpart, reason);
  }

  clear() {
    this.#timers.clear(this.#confirmation);
    for (const counterpart of this.#counterparts.values()) this.#timers.clear(counterpart.timer);
    this.#counterparts.clear();
    this.#services.clear();
  }

  #onState(event) {
    const life = lifeOf(event.attributes.channel);
    const key = life === 0n ? `service ${event.service}` : lifeText(life);
    const former = this.#services.get(event.service);
    // Daemons that come back give their words anew: that another life has the word is no end of the former one.
    if (former && former.key !== key) this.#loseWord(former, event.service, 'changed', false);
    const known = this.#counterparts.get(key);
    const counterpart = known ?? new Counterpart(key, life, event);
    const before = counterpart.event;
    this.#timers.clear(counterpart.timer);
    Object.assign(counterpart, { event, state: states.matched, reason: undefined });
    counterpart.words.delete(event.service);
    counterpart.words.set(event.service, event);
    this.#services.set(event.service, counterpart);
    if (known) {
      this.#hooks.modified(counterpart, before, !isSame(before, event));
    } else {
      this.#counterparts.set(key, counterpart);
      this.#hooks.added(counterpart);
    }
  }

  #onDel({ service, reason }) {
    const counterpart = this.#services.get(service);
    if (counterpart) this.#loseWord(counterpart, service, reason, true);
  }

  /** A word no longer stands for a counterpart, which may have another one. With `isDel` the reason may be final. */
  #loseWord(counterpart, service, reason, isDel) {
    this.#services.delete(service);
    counterpart.words.delete(service);
    if (counterpart.words.size > 0) {
      const before = counterpart.event;
      counterpart.event = [...counterpart.words.values()].at(-1);
      this.#hooks.modified(counterpart, before, !isSame(before, counterpart.event));
      return;
    }
    const why = isDel ? this.#hooks.reasonOf?.(counterpart, reason) ?? reason : reason;
    const isFinal = isDel && closing.has(why) && !(why === 'outranked' && this.#doubtsOutranked);
    if (isFinal) this.remove(counterpart, why);
    else if (isDel && why === 'withdrawn') this.#withdraw(counterpart, why);
    else if (!counterpart.isEnding) this.#orphan(counterpart, why);
  }

  #withdraw(counterpart, reason) {
    const patience = this.#hooks.endPatience(counterpart);
    if (patience === 0) {
      this.remove(counterpart, reason);
      return;
    }
    this.#timers.clear(counterpart.timer);
    Object.assign(counterpart, { state: states.ending, reason });
    this.#awaitEnd(counterpart);
  }

  #awaitEnd(counterpart) {
    counterpart.timer = this.#timers.after(this.#hooks.endPatience(counterpart), () => {
      if (this.#hooks.isHeld(counterpart)) this.#awaitEnd(counterpart);
      else this.remove(counterpart, counterpart.reason);
    });
  }

  /** The daemons have lost sight of a counterpart; its channel goes on. */
  #orphan(counterpart, reason) {
    Object.assign(counterpart, { state: states.orphan, reason });
    const patience = this.#hooks.orphanPatience(counterpart);
    if (patience === 0) this.remove(counterpart, reason);
    else if (patience !== Infinity) counterpart.timer = this.#timers.after(patience, () => this.remove(counterpart, reason));
  }

  #closeSurplus() {
    if (this.limit === 0) return;
    const matched = [...this.#counterparts.values()].filter(({ state }) => state === states.matched).length;
    if (matched < this.limit) return;
    for (const counterpart of this) {
      if (counterpart.state === states.orphan) this.remove(counterpart, counterpart.reason);
    }
  }
}
