// Who is at the other ends of a request's channels, by the daemon's events: whose daemon came and went is known by its life.
import { lifeOf, lifeText } from './frame.js';
import * as limits from './limits.js';

const closing = new Set(['outranked', 'changed']);

/** What is known of one provider or consumer. `life` is 0 where it is not made by a library that has channels. */
class Peer {
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
 * `hooks`: `added(peer)`, `modified(peer, before, isTold)`, `removed(peer, reason)`; `orphanPatience(peer)` says for how many
 * milliseconds the channel of one whom no daemon sees goes on, Infinity: as long as its connection; `endPatience(peer)`
 * for how many it is waited for something of a withdrawn one, 0: not at all, unless `isHeld(peer)`: it is not read now.
 */
export class PeerBook {
  #peers = new Map();
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
    return this.#peers.size;
  }

  [Symbol.iterator]() {
    return this.#peers.values();
  }

  /** The peer of a life that is not 0. */
  find(life) {
    return this.#peers.get(lifeText(life));
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
    for (const peer of this.#peers.values()) peer.isConfirmed = false;
  }

  /** The daemon is back; what it does not confirm in time is orphaned. */
  onDaemonBack() {
    this.#timers.clear(this.#confirmation);
    if (this.#peers.size === 0) return;
    this.#confirmation = this.#timers.after(limits.confirmPatience, () => {
      for (const peer of [...this.#peers.values()]) {
        if (!peer.isConfirmed && peer.isMatched) this.#orphan(peer, 'disconnected');
      }
      this.#closeSurplus();
    });
  }

  /** The channel of this peer is over, whatever the daemon says. */
  remove(peer, reason) {
    if (this.#peers.get(peer.key) !== peer) return;
    this.#timers.clear(peer.timer);
    this.#peers.delete(peer.key);
    if (this.#services.get(peer.service) === peer) this.#services.delete(peer.service);
    this.#hooks.removed(peer, reason);
  }

  /** Something of a withdrawn peer has come: its end is waited for anew. */
  touch(peer) {
    if (!peer.isEnding) return;
    this.#timers.clear(peer.timer);
    this.#awaitEnd(peer);
  }

  /** The daemon does not have the request any more. */
  removeAll(reason) {
    for (const peer of [...this.#peers.values()]) this.remove(peer, reason);
  }

  clear() {
    this.#timers.clear(this.#confirmation);
    for (const peer of this.#peers.values()) this.#timers.clear(peer.timer);
    this.#peers.clear();
    this.#services.clear();
  }

  #onState(event) {
    const life = lifeOf(event.attributes.channel);
    const key = life === 0n ? `service ${event.service}` : lifeText(life);
    const former = this.#services.get(event.service);
    if (former && former.key !== key) this.remove(former, 'changed');
    const peer = this.#peers.get(key);
    if (!peer) {
      const newcomer = new Peer(key, life, event);
      this.#peers.set(key, newcomer);
      this.#services.set(event.service, newcomer);
      this.#hooks.added(newcomer);
      return;
    }
    const before = peer.event;
    if (this.#services.get(peer.service) === peer) this.#services.delete(peer.service);
    this.#services.set(event.service, peer);
    this.#timers.clear(peer.timer);
    Object.assign(peer, { event, service: event.service, isMatched: true, isConfirmed: true, isEnding: false });
    this.#hooks.modified(peer, before, !isSame(before, event));
  }

  #onDel({ service, reason }) {
    const peer = this.#services.get(service);
    if (!peer) return;
    this.#services.delete(service);
    if (closing.has(reason)) {
      this.remove(peer, reason);
    } else if (reason === 'withdrawn') {
      const patience = this.#hooks.endPatience(peer);
      if (patience === 0) {
        this.remove(peer, reason);
        return;
      }
      Object.assign(peer, { isMatched: false, isEnding: true, reason });
      this.#awaitEnd(peer);
    } else {
      this.#orphan(peer, reason);
    }
  }

  #awaitEnd(peer) {
    peer.timer = this.#timers.after(this.#hooks.endPatience(peer), () => {
      if (this.#hooks.isHeld(peer)) this.#awaitEnd(peer);
      else this.remove(peer, peer.reason);
    });
  }

  /** The daemons have lost sight of it; the channel has not. */
  #orphan(peer, reason) {
    Object.assign(peer, { isMatched: false, reason });
    const patience = this.#hooks.orphanPatience(peer);
    if (patience === 0) this.remove(peer, reason);
    else if (patience !== Infinity) peer.timer = this.#timers.after(patience, () => this.remove(peer, reason));
  }

  #closeSurplus() {
    if (this.limit === 0) return;
    const matched = [...this.#peers.values()].filter((peer) => peer.isMatched).length;
    if (matched < this.limit) return;
    for (const peer of [...this.#peers.values()]) {
      if (!peer.isMatched && !peer.isEnding) this.remove(peer, peer.reason);
    }
  }
}
