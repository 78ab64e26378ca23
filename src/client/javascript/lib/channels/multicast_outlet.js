// The outlet of `otm/stream` over UDP to a multicast address: it sends on each interface, whether anybody listens or not.
import { isIPv6 } from 'node:net';

import { interfaceInterval } from '../protocol/limits.js';
import { DatagramPort } from './datagram_port.js';
import { groupInterfaces } from './interfaces.js';

export class MulticastOutlet {
  #io;
  #timers;
  #address;
  #outs = new Map();
  #leftOut = 0;
  port;

  constructor(io, { address, port }) {
    this.#io = io;
    this.#timers = io.timers();
    this.#address = address;
    this.port = port ?? 0;
  }

  /** Throws PortError. */
  async open() {
    // The first socket finds the port, and whether it is free.
    const first = DatagramPort.open(this.#io, { address: this.#any, port: this.port, isShared: true });
    this.port = first.port;
    this.#look();
    first.close();
  }

  get hasConsumer() {
    return this.#outs.size > 0;
  }

  get leftOut() {
    return [...this.#outs.values()].reduce((sum, out) => sum + out.leftOut, this.#leftOut);
  }

  get waiting() {
    return [...this.#outs.values()].reduce((most, out) => Math.max(most, out.waiting), 0);
  }

  get dropped() {
    return 0;
  }

  set() {}
  delete() {}

  send(octets) {
    let isPrompt = true;
    for (const out of this.#outs.values()) isPrompt = out.send(octets, this.#address, this.port) && isPrompt;
    return isPrompt;
  }

  async end(octets) {
    this.#io.forget(this.#timers);
    const outs = [...this.#outs.values()];
    this.#outs.clear();
    await Promise.all(outs.map((out) => out.end(octets, [{ address: this.#address, port: this.port }])));
  }

  get #any() {
    return isIPv6(this.#address) ? '::' : '0.0.0.0';
  }

  /** Opens the interfaces that there are now, and looks again later. */
  #look() {
    const names = groupInterfaces(isIPv6(this.#address));
    for (const [name, out] of this.#outs) {
      if (names.includes(name)) continue;
      this.#outs.delete(name);
      this.#leftOut += out.leftOut;
      out.close();
    }
    for (const name of names) if (!this.#outs.has(name)) this.#open(name);
    this.#timers.after(interfaceInterval, () => this.#look());
  }

  #open(name) {
    let out;
    try {
      out = DatagramPort.open(this.#io, { address: this.#any, port: this.port, isShared: true });
      const [socket] = out.sockets;
      socket.setMulticastInterface(name);
      socket.setMulticastTTL(1);
      socket.setMulticastLoopback(true);
      this.#outs.set(name, out);
    } catch {
      // An interface that is gone, or has no multicast: it is tried again later.
      out?.close();
    }
  }
}
