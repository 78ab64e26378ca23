// The outlet of `otm/stream` over UDP to a multicast address: it sends on each interface, whether anybody listens or not.
import { isIPv6 } from 'node:net';

import { interfaceInterval } from '../protocol/limits.js';
import { DatagramPort } from './datagram_port.js';
import { groupInterfaces } from './interfaces.js';
import { Reception } from './reception.js';

/** Where frames are sealed, a socket of its own takes hellos. Hook: `onProblem(error)`, that one cannot be opened. */
export class MulticastOutlet {
  #io;
  #frames;
  #timers;
  #address;
  #hooks;
  #outs = new Map();
  #leftOut = 0;
  #reception;
  #hellos;
  #isOpen = false;
  port;

  constructor(io, frames, { address, port, hooks }) {
    this.#io = io;
    this.#frames = frames;
    this.#timers = io.timers();
    this.#address = address;
    this.#hooks = hooks;
    this.port = port ?? 0;
    this.#reception = new Reception(io, frames, {
      onHello: (from, frame, said) => this.#reception.accept(from, frame, said, false),
      onEnd: () => {}, // nothing is kept of the consumers of a group
    }, true);
  }

  /** Throws PortError. */
  async open() {
    // The first socket finds the port, and whether it is free.
    const first = DatagramPort.open(this.#io, { address: this.#any, port: this.port, isShared: true });
    this.port = first.port;
    this.#look();
    first.close();
    this.#isOpen = true;
    this.rekey();
  }

  get hasConsumer() {
    return this.#outs.size > 0 && this.#frames.keys !== undefined;
  }

  get leftOut() {
    return [...this.#outs.values()].reduce((sum, out) => sum + out.leftOut, this.#leftOut);
  }

  get waiting() {
    return [...this.#outs.values()].reduce((most, out) => Math.max(most, out.waiting), 0);
  }

  get dropped() {
    return this.#reception.dropped;
  }

  set() {}
  delete() {}

  /** Other keys are in force, or another mode: takes hellos while frames are sealed. */
  rekey() {
    if (!this.#frames.seals || !this.#isOpen) {
      this.#closeHellos();
    } else if (!this.#hellos) {
      try {
        this.#hellos = DatagramPort.open(this.#io, {});
        this.#frames.helloPort = this.#hellos.port;
        this.#reception.read(this.#hellos);
      } catch (error) {
        this.#hooks.onProblem(error);
      }
    }
  }

  send(octets) {
    let isPrompt = true;
    for (const out of this.#outs.values()) isPrompt = out.send(octets, this.#address, this.port) && isPrompt;
    return isPrompt;
  }

  async end() {
    this.#io.forget(this.#timers);
    const outs = [...this.#outs.values()];
    const octets = this.hasConsumer ? this.#frames.end() : undefined;
    const targets = octets ? [{ address: this.#address, port: this.port }] : [];
    this.#outs.clear();
    this.#isOpen = false;
    this.#closeHellos();
    await Promise.all(outs.map((out) => out.end(octets, targets)));
  }

  get #any() {
    return isIPv6(this.#address) ? '::' : '0.0.0.0';
  }

  #closeHellos() {
    this.#reception.rest();
    this.#hellos?.close();
    this.#hellos = undefined;
    this.#frames.helloPort = 0;
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
