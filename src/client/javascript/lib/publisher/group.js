// A publisher's side of `otm/stream` over UDP multicast: sends to the group on each interface, whether anybody listens or not.
import { isIPv6 } from 'node:net';

import { openDatagramSocket } from '../io/datagram_socket.js';
import { interfacesOf } from '../io/interfaces.js';
import { PortError } from '../core/errors.js';
import { DatagramOut } from './datagrams.js';

export class Group {
  #io;
  #address;
  #outs = [];
  port;

  constructor(io, { address, port }) {
    this.#io = io;
    this.#address = address;
    this.port = port ?? 0;
  }

  async open() {
    const isSix = isIPv6(this.#address);
    const interfaces = interfacesOf(isSix);
    // The loopback interface is for a host that has no other; the system gives what it sends to its own listeners as well.
    const used = interfaces.filter(({ isLoopback }) => !isLoopback);
    for (const { name } of used.length > 0 ? used : interfaces) {
      const socket = openDatagramSocket(this.#io, { address: isSix ? '::' : '0.0.0.0', port: this.port, isShared: true });
      this.port = socket.address().port;
      try {
        socket.setMulticastInterface(name);
        socket.setMulticastTTL(1);
        socket.setMulticastLoopback(true);
        this.#outs.push(new DatagramOut(socket));
      } catch {
        socket.close(); // an interface that went, or that has no multicast
      }
    }
    if (this.#outs.length === 0) throw new PortError(this.port, new Error('no interface speaks multicast'));
  }

  get hasConsumer() {
    return this.#outs.length > 0;
  }

  get leftOut() {
    return this.#outs.reduce((sum, out) => sum + out.leftOut, 0);
  }

  get waiting() {
    return this.#outs.reduce((most, out) => Math.max(most, out.waiting), 0);
  }

  get dropped() {
    return 0;
  }

  set() {}
  delete() {}

  send(octets) {
    let isPrompt = true;
    for (const out of this.#outs) isPrompt = out.send(octets, this.#address, this.port) && isPrompt;
    return isPrompt;
  }

  async end(octets) {
    const outs = this.#outs;
    this.#outs = [];
    await Promise.all(outs.map((out) => out.end(octets, [{ address: this.#address, port: this.port }])));
  }
}
