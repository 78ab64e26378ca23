// A subscriber's sockets for UDP: one of its own, and one for each group and port that a provider speaks to.
import { isIPv6 } from 'node:net';

import { isMulticast, place, sendable } from '../core/address.js';
import { encodeFrame, kinds, lifeOctets } from '../core/frame.js';
import { helloInterval, interfaceInterval } from '../core/limits.js';
import { Places } from '../core/places.js';
import { familyOf, openDatagramSocket, Spelling } from '../io/datagram_socket.js';
import { groupInterfaces } from '../io/interfaces.js';

/** Hooks: `onFrame(channel, frame)`, `onDropped()`. A channel has a `life`. */
export class DatagramsIn {
  #io;
  #timers;
  #ownLife;
  #hooks;
  #socket;
  #places = new Places();
  #spelling = new Spelling();
  #groups = new Map();
  #greeted = new Map();
  #greeting;

  /** Throws PortError. */
  constructor(io, { port, ownLife }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#ownLife = ownLife;
    this.#hooks = hooks;
    this.#socket = openDatagramSocket(io, { port });
    this.#socket.on('error', () => {}); // a hello that could not be sent is said again
    this.#socket.on('message', (octets, from) => this.#onDatagram(octets, this.#spelling.of(from.address), from.port));
  }

  get port() {
    return this.#socket.address().port;
  }

  /** Believes what comes from there; for `otm/stream` says that somebody listens. */
  add(channel, { address, port, isStream }) {
    channel.where = { address, port };
    this.#places.set(place(address, port), channel);
    if (isMulticast(address)) this.#join(address, port);
    else if (isStream && channel.life !== 0n) this.#greet(channel, address, port);
  }

  delete(channel) {
    if (!channel.where) return;
    const { address, port } = channel.where;
    channel.where = undefined;
    this.#places.delete(place(address, port), channel);
    if (isMulticast(address)) this.#leave(address, port);
    const greeted = this.#greeted.get(channel);
    if (!greeted) return;
    this.#greeted.delete(channel);
    this.#send(encodeFrame(kinds.end, this.#ownLife, 0n, lifeOctets(channel.life)), greeted);
    if (this.#greeted.size === 0) this.#timers.clear(this.#greeting);
  }

  close() {
    for (const channel of [...this.#greeted.keys()]) this.delete(channel);
    this.#io.forget(this.#timers);
    for (const { sockets } of this.#groups.values()) for (const socket of sockets) socket.close();
    this.#groups.clear();
    this.#socket.close();
  }

  #onDatagram(octets, address, port) {
    const taken = this.#places.take(place(address, port), octets);
    if (taken) this.#hooks.onFrame(taken.channel, taken.frame);
    else this.#hooks.onDropped();
  }

  #greet(channel, address, port) {
    const greeted = { hello: encodeFrame(kinds.hello, this.#ownLife, 0n, lifeOctets(channel.life)), address, port };
    this.#greeted.set(channel, greeted);
    this.#send(greeted.hello, greeted);
    if (this.#greeted.size === 1) this.#greeting = this.#timers.after(helloInterval, () => this.#greetAll());
  }

  #greetAll() {
    for (const greeted of this.#greeted.values()) this.#send(greeted.hello, greeted);
    this.#greeting = this.#timers.after(helloInterval, () => this.#greetAll());
  }

  #send(octets, { address, port }) {
    const target = sendable(address, familyOf(this.#socket));
    if (target !== undefined) this.#socket.send(octets, port, target);
  }

  /** Several providers may speak to one group and port. */
  #join(address, port) {
    const where = place(address, port);
    const joined = this.#groups.get(where);
    if (joined) {
      ++joined.users;
      return;
    }
    const [group, zone] = address.split('%');
    const isSix = isIPv6(group);
    const sockets = [];
    this.#groups.set(where, { users: 1, sockets, names: new Set() });
    try {
      const socket = openDatagramSocket(this.#io, { address: zone ? address : group, port, isShared: true });
      sockets.push(socket);
      socket.on('error', () => {});
      this.#listen(this.#groups.get(where), group, isSix);
      // The event has the group's address, not the sender's, so its port is all that can be compared.
      socket.on('message', (octets, from) => this.#onDatagram(octets, address, from.port));
    } catch (error) {
      this.#hooks.onProblem(error);
    }
  }

  /** Hears the group on the interfaces that there are now, and looks again. */
  #listen(joined, group, isSix) {
    const names = groupInterfaces(isSix);
    for (const name of joined.names) if (!names.includes(name)) joined.names.delete(name);
    for (const name of names) {
      if (joined.names.has(name)) continue;
      try {
        joined.sockets[0].addMembership(group, name);
        joined.names.add(name);
      } catch {
        // an interface that went, or has no multicast: it is looked at again
      }
    }
    joined.timer = this.#timers.after(interfaceInterval, () => this.#listen(joined, group, isSix));
  }

  #leave(address, port) {
    const where = place(address, port);
    const joined = this.#groups.get(where);
    if (!joined || --joined.users > 0) return;
    this.#groups.delete(where);
    this.#timers.clear(joined.timer);
    for (const socket of joined.sockets) socket.close();
  }
}
