// The inlet over UDP: a subscriber's own socket, and one for each multicast group and port of a provider.
import { isIPv6 } from 'node:net';

import { isMulticast, isOfSomeLink, place } from '../protocol/address.js';
import { EarlyFrames } from '../protocol/early_frames.js';
import { encodeFrame, kinds } from '../protocol/frame.js';
import { lifeOctets } from '../protocol/life.js';
import { helloInterval, interfaceInterval } from '../protocol/limits.js';
import { frameOfProvider, Places } from '../protocol/places.js';
import { DatagramPort } from './datagram_port.js';
import { groupInterfaces } from './interfaces.js';

/** Hooks: `onFrame(channel, frame)`, `onDropped()`, and `onFound()`, which takes one `onDropped` back. A channel has a `life`. */
export class UdpInlet {
  #io;
  #timers;
  #ownLife;
  #hooks;
  #own;
  #places = new Places();
  #early = new EarlyFrames();
  #groups = new Map();
  #greeted = new Map();
  #greeting;

  /** Throws PortError. */
  constructor(io, { port, ownLife }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#ownLife = ownLife;
    this.#hooks = hooks;
    this.#own = DatagramPort.open(io, { port, isOne: true });
    this.#own.listen((octets, address, from) => this.#onOwnDatagram(octets, address, from));
  }

  get port() {
    return this.#own.port;
  }

  /** Believes datagrams of a channel from this address; says hello there for `otm/stream`. */
  add(channel, { address, port, isStream }) {
    channel.where = { address, port };
    this.#places.set(place(address, port), channel);
    if (isMulticast(address)) this.#join(address, port);
    else if (isStream && channel.life !== 0n) this.#greet(channel, address, port);
  }

  /** Delivers the frames of a channel that came before it was added. */
  deliverEarly(channel) {
    const { where } = channel;
    if (!where) return;
    for (const frame of this.#early.take(place(where.address, where.port), channel.life, this.#timers.now())) {
      if (channel.where !== where) return; // it has ended
      this.#hooks.onFound();
      this.#hooks.onFrame(channel, frame);
    }
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
    this.#own.send(encodeFrame(kinds.end, this.#ownLife, 0n, lifeOctets(channel.life)), address, port);
    if (this.#greeted.size === 0) this.#timers.clear(this.#greeting);
  }

  close() {
    for (const channel of [...this.#greeted.keys()]) this.delete(channel);
    this.#io.forget(this.#timers);
    for (const { group } of this.#groups.values()) group?.close();
    this.#groups.clear();
    this.#own.close();
  }

  /** Gives a datagram to its channel. Whether there is one. */
  #onDatagram(octets, address, port) {
    const taken = this.#places.take(place(address, port), octets);
    if (taken) this.#hooks.onFrame(taken.channel, taken.frame);
    else this.#hooks.onDropped();
    return taken !== undefined;
  }

  #onOwnDatagram(octets, address, port) {
    if (this.#onDatagram(octets, address, port)) return;
    const frame = frameOfProvider(octets);
    if (frame) this.#early.put(place(address, port), frame, this.#timers.now());
  }

  #greet(channel, address, port) {
    const greeted = { hello: encodeFrame(kinds.hello, this.#ownLife, 0n, lifeOctets(channel.life)), address, port };
    this.#greeted.set(channel, greeted);
    this.#own.send(greeted.hello, address, port);
    if (this.#greeted.size === 1) this.#greeting = this.#timers.after(helloInterval, () => this.#greetAll());
  }

  #greetAll() {
    for (const { hello, address, port } of this.#greeted.values()) this.#own.send(hello, address, port);
    this.#greeting = this.#timers.after(helloInterval, () => this.#greetAll());
  }

  /** Joins a group for one provider; several may share it. */
  #join(address, port) {
    const where = place(address, port);
    const joined = this.#groups.get(where);
    if (joined) {
      ++joined.users;
      return;
    }
    const made = { users: 1, group: undefined, names: new Set(), timer: undefined };
    this.#groups.set(where, made);
    try {
      // A link-local group on every link has no single address to bind to. The sender is checked later anyway.
      made.group = DatagramPort.open(this.#io, { address: isOfSomeLink(address) ? '::' : address, port, isShared: true });
      this.#listen(made, address);
      // The event names the group's address, not the sender's, so only the port can be compared.
      made.group.listen((octets, _, from) => this.#onDatagram(octets, address, from));
    } catch (error) {
      this.#hooks.onProblem(error);
    }
  }

  /** Joins the group on the interfaces that there are now, and looks again later. */
  #listen(joined, address) {
    const [group] = address.split('%');
    const names = groupInterfaces(isIPv6(group));
    for (const name of joined.names) if (!names.includes(name)) joined.names.delete(name);
    for (const name of names) {
      if (joined.names.has(name)) continue;
      try {
        joined.group.sockets[0].addMembership(group, name);
        joined.names.add(name);
      } catch {
        // an interface that is gone, or has no multicast: it is tried again later
      }
    }
    joined.timer = this.#timers.after(interfaceInterval, () => this.#listen(joined, address));
  }

  #leave(address, port) {
    const where = place(address, port);
    const joined = this.#groups.get(where);
    if (!joined || --joined.users > 0) return;
    this.#groups.delete(where);
    this.#timers.clear(joined.timer);
    joined.group?.close();
  }
}
