// The inlet over UDP: a subscriber's own socket, and one for each multicast group and port of a provider.
import { isMulticast, place } from '../protocol/address.js';
import { outcomes } from '../protocol/belief.js';
import { EarlyFrames } from '../protocol/early_frames.js';
import { kinds } from '../protocol/frame.js';
import { frameOfProvider, Senders } from '../protocol/senders.js';
import { DatagramPort } from './datagram_port.js';
import { MulticastInlet } from './multicast_inlet.js';

/** The place among the early frames of those that wait for a floor. They are known by their life. */
const beforeFloor = '';

/**
 * Hooks: `onFrame(channel, frame)`, a message or an end that is believed; `onDropped()`, and `onFound()`, which takes one
 * `onDropped` back; `onFull(channel)`, the provider has no place; `onFailed(error)`, no frame can be sent any more;
 * `onProblem(error)`. A channel has a `life` and, unless that is 0n, a `belief`.
 */
export class UdpInlet {
  #io;
  #timers;
  #frames;
  #hooks;
  #own;
  #senders = new Senders();
  #early = new EarlyFrames();
  #groups;
  /** By channel: `{address, port, form, timer}`, where hello is said and in which form. */
  #greeted = new Map();
  /** Channels from groups that are asked for a floor, by their lives. */
  #asked = new Map();

  /** `frames` are those of a consumer. Throws PortError. */
  constructor(io, frames, { port }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#frames = frames;
    this.#hooks = hooks;
    this.#groups = new MulticastInlet(io, {
      onDatagram: (where, octets, address, from) => this.#onGroupDatagram(where, octets, address, from),
      onProblem: hooks.onProblem,
    });
    this.#own = DatagramPort.open(io, { port, isOne: true });
    this.#own.listen((octets, address, from) => this.#onOwnDatagram(octets, address, from));
  }

  get port() {
    return this.#own.port;
  }

  /** Believes datagrams of a channel from this address; says hello there for `otm/stream`, and where there are keys. */
  add(channel, { address, port, isStream }) {
    const isGroup = isMulticast(address);
    if (channel.where?.address !== address || channel.where.port !== port) {
      this.delete(channel);
      channel.where = { address, port };
      this.#senders.set(place(address, port), channel);
      if (isGroup) this.#groups.join(address, port);
    }
    if (isGroup) return;
    if (channel.belief && (isStream || channel.belief.hasRing)) this.#greet(channel, address, port);
    else this.#ungreet(channel);
  }

  /** Delivers the frames of a channel that came before it was added. */
  deliverEarly(channel) {
    if (channel.where) this.#deliverEarly(place(channel.where.address, channel.where.port), channel);
  }

  /** Forgets a channel. A publisher that was said hello to is told the end. */
  delete(channel) {
    if (!channel.where) return;
    const { address, port } = channel.where;
    channel.where = undefined;
    this.#senders.delete(place(address, port), channel);
    const isGroup = isMulticast(address);
    if (isGroup) this.#groups.leave(address, port);
    const greeted = this.#greeted.get(channel);
    if (greeted && !isGroup) this.#say(kinds.end, channel, greeted);
    this.#ungreet(channel);
    if (this.#asked.get(channel.life) === channel) this.#asked.delete(channel.life);
  }

  close() {
    for (const channel of [...this.#greeted.keys()]) this.delete(channel);
    this.#io.forget(this.#timers);
    this.#groups.close();
    this.#own.close();
  }

  #onOwnDatagram(octets, address, port) {
    const where = place(address, port);
    const read = frameOfProvider(octets);
    const taken = this.#senders.take(where, octets, read);
    if (taken) {
      this.#take(taken.channel, taken.frame);
      return;
    }
    const isAnswer = read && (read.kind === kinds.floor || read.kind === kinds.full);
    const asked = isAnswer && this.#asked.get(read.life);
    if (asked) {
      this.#take(asked, read);
      return;
    }
    this.#hooks.onDropped();
    if (read && !isAnswer) this.#early.put(where, read, this.#timers.now());
  }

  #onGroupDatagram(where, octets, address, port) {
    const taken = this.#senders.take(where, octets);
    const isPlain = taken?.channel.life === 0n;
    const frame = isPlain ? taken.frame : taken?.channel.belief?.take(taken.frame);
    if (!frame || frame.kind === kinds.floor || frame.kind === kinds.full) {
      this.#hooks.onDropped();
      if (taken && !frame) this.#keepAhead(taken.channel, taken.frame);
      return;
    }
    if (this.#hear(taken.channel, frame)) return;
    this.#early.put(beforeFloor, frame, this.#timers.now());
    if (address !== undefined && frame.port !== 0) this.#ask(taken.channel, address, frame.port);
  }

  /** Takes a frame of any form from the place of a channel. */
  #take(channel, read) {
    const frame = channel.life === 0n ? read : channel.belief?.take(read);
    if (!frame) {
      this.#hooks.onDropped();
      this.#keepAhead(channel, read);
    } else if (frame.kind === kinds.floor || frame.kind === kinds.full) {
      this.#onAnswer(channel, frame);
    } else if (!this.#hear(channel, frame)) {
      this.#early.put(beforeFloor, frame, this.#timers.now());
    }
  }

  /** Keeps a frame of a key that the daemon may tell within a second, since the two daemons tell their programs at their own pace. */
  #keepAhead({ belief, where }, read) {
    if (!where || !belief?.isAhead(read) || (read.kind !== kinds.message && read.kind !== kinds.end)) return;
    this.#early.put(place(where.address, where.port), read, this.#timers.now());
  }

  /** Delivers a message or an end. False for a sealed one that has no floor yet, which counts as dropped. */
  #hear(channel, frame) {
    const isHeard = channel.life === 0n || channel.belief.isBehindFloor(frame);
    if (isHeard) this.#hooks.onFrame(channel, frame);
    else this.#hooks.onDropped();
    return isHeard !== undefined;
  }

  #onAnswer(channel, frame) {
    const { belief } = channel;
    const greeted = this.#greeted.get(channel);
    const hadFloor = belief?.floor !== undefined;
    const outcome = greeted ? belief.answered(frame) : outcomes.forged;
    if (outcome === outcomes.forged) {
      this.#hooks.onDropped();
      return;
    }
    if (outcome === outcomes.full) this.#hooks.onFull(channel);
    else if (!hadFloor && belief.floor !== undefined) this.#deliverEarly(beforeFloor, channel);
    if (this.#greeted.get(channel) !== greeted) return; // it has ended
    if (this.#asked.has(channel.life) && belief.floor !== undefined) this.#ungreet(channel); // a group has no listeners
    else if (outcome === outcomes.again) this.#hello(channel, greeted);
  }

  #deliverEarly(where, channel) {
    const { where: before } = channel;
    for (const read of this.#early.take(where, channel.life, this.#timers.now())) {
      if (channel.where !== before || !before) return; // it has ended
      const frame = channel.life === 0n || read.isSealed ? read : channel.belief?.take(read);
      if (!frame) continue;
      this.#hooks.onFound();
      if (!this.#hear(channel, frame)) this.#early.put(beforeFloor, frame, this.#timers.now());
    }
  }

  /** Asks a provider over multicast for a floor, unless it is being asked. */
  #ask(channel, address, port) {
    this.#asked.set(channel.life, channel);
    // Where a host has no route for the group, its own datagrams come from no address.
    this.#greet(channel, { '0.0.0.0': '127.0.0.1', '::': '::1' }[address] ?? address, port);
  }

  #greet(channel, address, port) {
    const known = this.#greeted.get(channel);
    const { form } = channel.belief.keys;
    if (known?.address === address && known.port === port) {
      // Another form is said at once, so that nothing is lost where the former one is not taken any more.
      if (known.form === form) return;
      known.form = form;
      this.#hello(channel, known);
      return;
    }
    this.#ungreet(channel);
    const greeted = { address, port, form, timer: undefined };
    this.#greeted.set(channel, greeted);
    this.#hello(channel, greeted);
  }

  #ungreet(channel) {
    this.#timers.clear(this.#greeted.get(channel)?.timer);
    this.#greeted.delete(channel);
  }

  #hello(channel, greeted) {
    this.#timers.clear(greeted.timer);
    greeted.timer = this.#timers.after(channel.belief.wait(), () => this.#hello(channel, greeted));
    this.#say(kinds.hello, channel, greeted);
  }

  #say(kind, { belief }, { address, port, timer }) {
    try {
      if (belief.keys) this.#own.send(this.#frames.write(belief.keys, kind, belief.hello()), address, port);
    } catch (error) {
      this.#timers.clear(timer);
      this.#hooks.onFailed(error);
    }
  }
}
