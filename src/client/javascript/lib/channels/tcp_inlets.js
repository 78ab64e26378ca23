// The connections of a subscriber to its providers over TCP, which have a limited number of places.
import { maxTcpProviders, unconnectedPatience } from '../protocol/limits.js';
import { Places } from '../protocol/places.js';
import { TcpInlet } from './tcp_inlet.js';

/**
 * Hooks, each with the channel first: those of TcpInlet but for `hasRoom()` and `onUp`; `onNoPlace(what, count)`, a newcomer found
 * all places taken; `onPlaces()`, enough are free again, which may be told again. A channel has its connection as `stream`.
 */
export class TcpInlets {
  #io;
  #timers;
  #frames;
  #hooks;
  #places = new Places(maxTcpProviders);
  /** By channel: `{address, port}`, of those that wait for a place. */
  #waiting = new Map();
  /** By channel: `{address, port, since}`, of those that have a place; `since` is undefined while they are connected. */
  #placed = new Map();
  #timer;

  constructor(io, frames, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#frames = frames;
    this.#hooks = hooks;
  }

  /** Connects a channel to its provider when there is a place, or moves it. */
  add(channel, where) {
    const placed = this.#placed.get(channel);
    // A connection that is open is kept, and counts where it was made to.
    if (placed && (placed.address === where.address || channel.stream.isConnected)) {
      Object.assign(placed, where);
      channel.stream.move(where.address, where.port);
      return;
    }
    this.#stop(channel);
    const { isTaken, loser } = this.#places.take(channel, where.address);
    if (loser) this.#wait(loser, this.#placed.get(loser));
    if (isTaken) this.#start(channel, where);
    else this.#wait(channel, where);
    if (this.#waiting.size > 0) this.#hooks.onNoPlace('providers over TCP', maxTcpProviders);
  }

  delete(channel) {
    if (!this.#placed.has(channel) && !this.#waiting.has(channel)) return;
    this.#stop(channel);
    this.#next();
  }

  /** A provider has delivered a message. */
  serve(channel) {
    this.#places.serve(channel);
  }

  /** There is room for messages again. */
  resume() {
    for (const channel of [...this.#placed.keys()]) channel.stream?.resume();
  }

  close() {
    this.#io.forget(this.#timers);
    for (const channel of [...this.#placed.keys()]) this.#stop(channel);
    this.#waiting.clear();
  }

  #start(channel, { address, port }) {
    const placed = { address, port, since: this.#timers.now() };
    this.#placed.set(channel, placed);
    const hooks = this.#hooks;
    channel.stream = new TcpInlet(this.#io, this.#frames, channel, { address, port }, {
      hasRoom: hooks.hasRoom,
      onMessage: (frame) => {
        this.#places.serve(channel);
        hooks.onMessage(channel, frame);
      },
      onEnd: (frame) => hooks.onEnd(channel, frame),
      onUp: () => {
        placed.since = undefined;
      },
      onLost: () => {
        if (!hooks.onLost(channel)) return false;
        placed.since ??= this.#timers.now();
        this.#setTimer();
        return true;
      },
      onDropped: hooks.onDropped,
      onOctets: () => hooks.onOctets(channel),
      onFull: () => hooks.onFull(channel),
      onFailed: hooks.onFailed,
    });
  }

  #stop(channel) {
    channel.stream?.close();
    channel.stream = undefined;
    this.#placed.delete(channel);
    this.#waiting.delete(channel);
    this.#places.leave(channel);
  }

  /** A channel waits for a place behind the others. */
  #wait(channel, { address, port }) {
    this.#stop(channel);
    this.#waiting.set(channel, { address, port });
    this.#setTimer();
  }

  /** Gives free places to those that wait, in turn. */
  #next() {
    for (const [channel, where] of this.#waiting) {
      if (this.#places.isFull) break;
      this.#waiting.delete(channel);
      this.#places.take(channel, where.address);
      this.#start(channel, where);
    }
    if (this.#places.hasRoomAgain) this.#hooks.onPlaces();
  }

  get #unconnected() {
    return [...this.#placed].filter(([, { since }]) => since !== undefined);
  }

  #setTimer() {
    if (this.#timer !== undefined || this.#waiting.size === 0) return;
    const first = Math.min(...this.#unconnected.map(([, { since }]) => since));
    if (first === Infinity) return;
    this.#timer = this.#timers.after(first + unconnectedPatience - this.#timers.now(), () => {
      this.#timer = undefined;
      this.#giveWay();
    });
  }

  /** Takes the places of providers that are not connected, for others that wait. */
  #giveWay() {
    const now = this.#timers.now();
    const late = this.#unconnected.filter(([, { since }]) => now - since >= unconnectedPatience);
    for (const [channel, where] of late.slice(0, this.#waiting.size)) this.#wait(channel, where);
    this.#next();
    this.#setTimer();
  }
}
