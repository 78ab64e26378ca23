// The inlet from multicast groups: a socket for each group and port of a provider.
import { isIPv6 } from 'node:net';

import { isOfSomeLink, place } from '../protocol/address.js';
import { interfaceInterval } from '../protocol/limits.js';
import { DatagramPort } from './datagram_port.js';
import { groupInterfaces } from './interfaces.js';

/** Hooks: `onDatagram(where, octets, address, port)`, where `where` is the place of the group with the sender's port; `onProblem(error)`. */
export class MulticastInlet {
  #io;
  #timers;
  #hooks;
  /** By place: `{users, group, names, timer}`. */
  #groups = new Map();

  constructor(io, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#hooks = hooks;
  }

  /** Joins a group for one provider; several may share it. */
  join(address, port) {
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
      this.#look(made, address);
      // The event names the group's address, not the sender's, so only the port can be compared.
      made.group.listen((octets, from, fromPort) => this.#hooks.onDatagram(place(address, fromPort), octets, from, fromPort));
    } catch (error) {
      this.#hooks.onProblem(error);
    }
  }

  leave(address, port) {
    const where = place(address, port);
    const joined = this.#groups.get(where);
    if (!joined || --joined.users > 0) return;
    this.#groups.delete(where);
    this.#timers.clear(joined.timer);
    joined.group?.close();
  }

  close() {
    this.#io.forget(this.#timers);
    for (const { group } of this.#groups.values()) group?.close();
    this.#groups.clear();
  }

  /** Joins the group on the interfaces that there are now, and looks again later. */
  #look(joined, address) {
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
    joined.timer = this.#timers.after(interfaceInterval, () => this.#look(joined, address));
  }
}
