// The counterparts of a channel: the providers of a subscriber, or the consumers of a publisher, by their lives.
import { lifeOf, lifeText } from './life.js';
import * as limits from './limits.js';

const closing = new Set(['outranked', 'changed']);

/** One counterpart. `life` is 0n if no library with channels made it. */
class Counterpart {
  constructor(key, life, event) {
    this.key = key;
    this.life = life;
    this.event = event;
    this.service = event.service;
    /** Whether a daemon matches it. If not, it is an orphan or ends, for `reason`. */
    this.isMatched = true;
    /** Whether the present daemon has confirmed it. */
    this.isConfirmed = true;
    this.isEnding = false;
    this.reason = undefined;
    this.timer = undefined;
  }
}

/** Whether two events are equal for the application. */
function isSame(a, b) {
  const visible = ({ id, change, service, peer, ...rest }) => JSON.stringify(rest);
  return visible(a) === visible(b);
}

/**
 * Decides how long a channel outlives its match (src/client/CHANNELS.md, "How a channel ends"). Hooks: `added(counterpart)`,
 * `modified(counterpart, before, isTold)` and `removed(counterpart, reason)`. `orphanPatience(counterpart)` gives the
 * milliseconds that an orphan goes on, Infinity for as long as its connection. `endPatience(counterpart)` gives the
 * milliseconds of waiting for more of a withdrawn one, which is not over while `isHeld(counterpart)`.
 */
export class Counterparts {
  #counterparts = new Map();
  #services = new Map();
  #hooks;
  #timers;
  #confirmation;
  /** The largest number of counterparts; 0: all. */
  limit = 0;

  constructor(timers, hooks) {
    this.#timers = timers;
    this.#hooks = hooks;
  }

  get size() {
    return this.#counterparts.size;
  }

  [Symbol.iterator]() {
    return this.#counterparts.values();
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

  /** The own daemon is gone. All channels go on. */
  onDaemonLost() {
    this.#timers.clear(this.#confirmation);
    this.#services.clear();
    for (const counterpart of this.#counterparts.values()) counterpart.isConfirmed = false;
  }

  /** The own daemon is back. Counterparts that it does not confirm in time become orphans. */
  onDaemonBack() {
    this.#timers.clear(this.#confirmation);
    if (this.#counterparts.size === 0) return;
    this.#confirmation = this.#timers.after(limits.confirmPatience, () => {
      for (const counterpart of [...this.#counterparts.values()]) {
        if (!counterpart.isConfirmed && counterpart.isMatched) this.#orphan(counterpart, 'disconnected');
      }
      this.#closeSurplus();
    });
  }

  /** Ends the channel of a counterpart, whatever the daemon says. */
  remove(counterpart, reason) {
    if (this.#counterparts.get(counterpart.key) !== counterpart) return;
    this.#timers.clear(counterpart.timer);
    this.#counterparts.delete(counterpart.key);
    if (this.#services.get(counterpart.service) === counterpart) this.#services.delete(counterpart.service);
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
    for (const counterpart of [...this.#counterparts.values()]) this.remove(counterpart, reason);
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
    if (former && former.key !== key) this.remove(former, 'changed');
    const counterpart = this.#counterparts.get(key);
    if (!counterpart) {
      const newcomer = new Counterpart(key, life, event);
      this.#counterparts.set(key, newcomer);
      this.#services.set(event.service, newcomer);
      this.#hooks.added(newcomer);
      return;
    }
    const before = counterpart.event;
    if (this.#services.get(counterpart.service) === counterpart) this.#services.delete(counterpart.service);
    this.#services.set(event.service, counterpart);
    this.#timers.clear(counterpart.timer);
    Object.assign(counterpart, { event, service: event.service, isMatched: true, isConfirmed: true, isEnding: false });
    this.#hooks.modified(counterpart, before, !isSame(before, event));
  }

  #onDel({ service, reason }) {
    const counterpart = this.#services.get(service);
    if (!counterpart) return;
    this.#services.delete(service);
    if (closing.has(reason)) {
      this.remove(counterpart, reason);
    } else if (reason === 'withdrawn') {
      const patience = this.#hooks.endPatience(counterpart);
      if (patience === 0) {
        this.remove(counterpart, reason);
        return;
      }
      Object.assign(counterpart, { isMatched: false, isEnding: true, reason });
      this.#awaitEnd(counterpart);
    } else {
      this.#orphan(counterpart, reason);
    }
  }

  #awaitEnd(counterpart) {
    counterpart.timer = this.#timers.after(this.#hooks.endPatience(counterpart), () => {
      if (this.#hooks.isHeld(counterpart)) this.#awaitEnd(counterpart);
      else this.remove(counterpart, counterpart.reason);
    });
  }

  /** The daemons have lost sight of a counterpart; its channel goes on. */
  #orphan(counterpart, reason) {
    Object.assign(counterpart, { isMatched: false, reason });
    const patience = this.#hooks.orphanPatience(counterpart);
    if (patience === 0) this.remove(counterpart, reason);
    else if (patience !== Infinity) counterpart.timer = this.#timers.after(patience, () => this.remove(counterpart, reason));
  }

  #closeSurplus() {
    if (this.limit === 0) return;
    const matched = [...this.#counterparts.values()].filter((counterpart) => counterpart.isMatched).length;
    if (matched < this.limit) return;
    for (const counterpart of [...this.#counterparts.values()]) {
      if (!counterpart.isMatched && !counterpart.isEnding) this.remove(counterpart, counterpart.reason);
    }
  }
}
