// A publisher's side of `otm/stream` over UDP without a group: sends to everybody who says hello.
import { place } from '../core/address.js';
import { frameOfDatagram, kinds, lifeOctets } from '../core/frame.js';
import * as limits from '../core/limits.js';
import { DatagramPort } from '../io/datagram_port.js';

/** Who listens: a table of places with the time of the last hello. Knows no sockets. */
export class ListenerTable {
  #life;
  #listeners = new Map();
  /** Datagrams that were no hello to this publisher. */
  dropped = 0;

  constructor(life) {
    this.#life = lifeOctets(life);
  }

  get size() {
    return this.#listeners.size;
  }

  values() {
    return this.#listeners.values();
  }

  onDatagram(octets, address, port, now) {
    const frame = frameOfDatagram(octets);
    if (!frame || frame.kind === kinds.message || !this.#life.equals(frame.payload)) {
      ++this.dropped;
      return;
    }
    const where = place(address, port);
    if (frame.kind === kinds.end) {
      this.#listeners.delete(where);
      return;
    }
    if (!this.#listeners.has(where) && this.#listeners.size >= limits.maxListeners) this.forgetSilent(now);
    if (!this.#listeners.has(where) && this.#listeners.size >= limits.maxListeners) return;
    this.#listeners.set(where, { address, port, heard: now });
  }

  forgetSilent(now) {
    for (const [where, { heard }] of this.#listeners) {
      if (now - heard >= limits.listenerPatience) this.#listeners.delete(where);
    }
  }
}

export class Listeners {
  #io;
  #options;
  #table;
  #out;

  constructor(io, { address, port, life }) {
    this.#io = io;
    this.#options = { address, port: port ?? 0 };
    this.#table = new ListenerTable(life);
  }

  get port() {
    return this.#options.port;
  }

  async open() {
    this.#out = DatagramPort.open(this.#io, this.#options);
    this.#options.port = this.#out.port;
    this.#out.listen((octets, address, port) => this.#table.onDatagram(octets, address, port, this.#io.clock.now()));
  }

  get hasConsumer() {
    return this.#table.size > 0;
  }

  get leftOut() {
    return this.#out?.leftOut ?? 0;
  }

  get waiting() {
    return this.#out?.waiting ?? 0;
  }

  get dropped() {
    return this.#table.dropped;
  }

  set() {}
  delete() {}

  send(octets) {
    this.#table.forgetSilent(this.#io.clock.now());
    let isPrompt = true;
    for (const { address, port } of this.#table.values()) isPrompt = this.#out.send(octets, address, port) && isPrompt;
    return isPrompt;
  }

  async end(octets) {
    const out = this.#out;
    this.#out = undefined;
    await out?.end(octets, [...this.#table.values()]);
  }
}
