// Who is at the other ends of a request's channels, by the daemon's events: whose daemon came and went is known by its life.
import { lifeOf, lifeText } from './life.js';
import * as limits from './limits.js';

const closing = new Set(['outranked', 'changed']);

/** What is known of one provider or consumer. `life` is 0 where it is not made by a library that has channels. */
class Counterpart {
  constructor(key, life, event) {
    this.key = key;
    this.life = life;
    this.event = event;
    this.service = event.service;
    /** Whether a daemon says so; otherwise it is an orphan, or ends, for `reason`. */
    this.isMatched = true;
    /** Whether the present connection to the daemon has said so. */
    this.isConfirmed = true;
    this.isEnding = false;
    this.reason = undefined;
    this.timer = undefined;
  }
}

/** Whether the application would see a difference. */
function isSame(a, b) {
  const visible = ({ id, change, service, peer, ...rest }) => JSON.stringify(rest);
  return visible(a) === visible(b);
}

/**
 * `hooks`: `added(counterpart)`, `modified(counterpart, before, isTold)`, `removed(counterpart, reason)`; `orphanPatience(counterpart)` says for how many
 * milliseconds the channel of one whom no daemon sees goes on, Infinity: as long as its connection; `endPatience(counterpart)`
 * for how many it is waited for something of a withdrawn one, 0: not at all, unless `isHeld(counterpart)`: it is not read now.
 */
export class Counterparts {
  #counterparts = new Map();
  #services = new Map();
  #hooks;
  #timers;
  #confirmation;
  /** How many may be matched; 0: all. */
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

  /** The counterpart of a life that is not 0. */
  find(life) {
    return this.#counterparts.get(lifeText(life));
  }

  onEvent(event) {
    if (event.change === 'del') this.#onDel(event);
    else if (event.change === 'add' || this.#services.has(event.service)) this.#onState(event);
    this.#closeSurplus();
  }

  /** The connection to the daemon is lost: what was matched goes on. */
  onDaemonLost() {
    this.#timers.clear(this.#confirmation);
    this.#services.clear();
    for (const counterpart of this.#counterparts.values()) counterpart.isConfirmed = false;
  }

  /** The daemon is back; what it does not confirm in time is orphaned. */
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

  /** The channel of this counterpart is over, whatever the daemon says. */
  remove(counterpart, reason) {
    if (this.#counterparts.get(counterpart.key) !== counterpart) return;
    this.#timers.clear(counterpart.timer);
    this.#counterparts.delete(counterpart.key);
    if (this.#services.get(counterpart.service) === counterpart) this.#services.delete(counterpart.service);
    this.#hooks.removed(counterpart, reason);
  }

  /** Something of a withdrawn counterpart has come: its end is waited for anew. */
  touch(counterpart) {
    if (!counterpart.isEnding) return;
    this.#timers.clear(counterpart.timer);
    this.#awaitEnd(counterpart);
  }

  /** The daemon does not have the request any more. */
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

  /** The daemons have lost sight of it; the channel has not. */
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
