// The providers of a subscriber: which channels are open, and what is believed of them.
import { canonicalAddress, isMulticast } from './protocol/address.js';
import { Belief } from './protocol/belief.js';
import { plainKeys } from './protocol/channel_keys.js';
import { Counterparts } from './protocol/counterparts.js';
import { changeOf, describe } from './protocol/description.js';
import { Endings } from './protocol/endings.js';
import { kinds } from './protocol/frame.js';
import { ConsumerFrames } from './protocol/frame_writer.js';
import * as limits from './protocol/limits.js';
import { ProviderKeys } from './protocol/provider_keys.js';
import { Sequence } from './protocol/sequence.js';
import { TcpInlets } from './channels/tcp_inlets.js';
import { UdpInlet } from './channels/udp_inlet.js';

/** The channel from one provider. */
class Channel {
  /** Where its datagrams come from, while they are believed. */
  where;
  /** Its connection over TCP. */
  stream;
  /** The belief in its provider; undefined without a life, and until its keys are known. */
  belief;
  convert;
  hasToldFailure = false;
  /** Texts that the application was told. */
  told = new Set();

  constructor(counterpart) {
    this.counterpart = counterpart;
    this.life = counterpart.life;
    this.provider = describe(counterpart);
  }
}

/**
 * Hooks: `hasRoom()`; `onMessage(channel, frame, missed, isDatagram)`, a new message; `onProvider(change)`; `onProblem(text)`;
 * `onFailed(error)`, no frame can be sent any more. Counts `missed` and `dropped` of `statistics`.
 */
export class Providers {
  #timers;
  #sealing;
  #conversions;
  #statistics;
  #hooks;
  #counterparts;
  #channels = new Map();
  #keys = new ProviderKeys();
  #endings;
  #sequence = new Sequence();
  #frames;
  #datagrams;
  #streams;
  #hasNoPlaces = false;
  #toldProblems = new Set();
  #io;

  constructor({ io, sealing }, { life, conversions, statistics }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#sealing = sealing;
    this.#conversions = conversions;
    this.#statistics = statistics;
    this.#hooks = hooks;
    this.#frames = new ConsumerFrames(life);
    this.#endings = new Endings(this.#timers, (event) => this.#counterparts.onEvent(event));
    this.#streams = new TcpInlets(io, this.#frames, this.#streamHooks());
    this.#counterparts = new Counterparts(this.#timers, {
      added: (counterpart) => this.#onAdded(counterpart),
      modified: (counterpart, before, isTold) => this.#onModified(counterpart, isTold),
      removed: (counterpart, reason) => this.#onRemoved(counterpart, reason),
      // An end that was said before is the reason of a `del`.
      reasonOf: ({ life: provider }, reason) => (this.#endings.lastOf(provider) === undefined ? reason : 'withdrawn'),
      endPatience: (counterpart) => this.#endPatience(counterpart),
      isHeld: (counterpart) => this.#channels.get(counterpart)?.stream?.isHeld ?? false,
      orphanPatience: (counterpart) => this.#orphanPatience(counterpart),
    });
  }

  /** Opens the UDP socket. Throws PortError. */
  listen(port) {
    this.#datagrams = new UdpInlet(this.#io, this.#frames, { port }, {
      onFrame: (channel, frame) => this.#onFrame(channel, frame, true),
      onDropped: () => ++this.#statistics.dropped,
      onFound: () => --this.#statistics.dropped,
      onFull: (channel) => this.#onFull(channel),
      onFailed: this.#hooks.onFailed,
      onProblem: (error) => this.#hooks.onProblem(error.message),
    });
  }

  /** The UDP port, if there is one. */
  get port() {
    return this.#datagrams?.port;
  }

  get described() {
    return [...this.#counterparts].map(describe);
  }

  /** The largest number of providers; 0: all. */
  set limit(limit) {
    this.#counterparts.limit = limit;
  }

  onEvent(event) {
    if (!this.#endings.onEvent(event)) this.#counterparts.onEvent(event);
  }

  /** The daemon has said which keys a provider has, or an error because they cannot be used. */
  onKeys(life, keys, error) {
    this.#keys.put(life, keys, (one) => this.#counterparts.find(one) !== undefined);
    if (error) this.#problemOnce(error.message);
    const counterpart = this.#counterparts.find(life);
    const channel = counterpart && this.#channels.get(counterpart);
    if (channel) this.#connect(channel);
    if (channel) this.#datagrams?.deliverEarly(channel);
  }

  /** The daemon has said how this host seals, which counts for channels that have no line of keys. */
  onSealing() {
    for (const channel of this.#channels.values()) if (!this.#keys.get(channel.life)) this.#connect(channel);
  }

  onDaemonLost() {
    this.#endings.forgetMatches();
    this.#counterparts.onDaemonLost();
  }

  /** The daemon is back. Without keys all channels are plain. */
  onDaemonBack() {
    if (!this.#sealing.hasKeys) {
      this.#keys.clear();
      for (const channel of this.#channels.values()) this.#connect(channel);
    }
    this.#counterparts.onDaemonBack();
  }

  removeAll(reason) {
    this.#counterparts.removeAll(reason);
  }

  /** There is room for messages again. */
  resume() {
    this.#streams.resume();
  }

  close() {
    for (const channel of this.#channels.values()) this.#disconnect(channel);
    this.#channels.clear();
    this.#counterparts.clear();
    this.#streams.close();
    this.#datagrams?.close();
    this.#io.forget(this.#timers);
  }

  #onAdded(counterpart) {
    const channel = new Channel(counterpart);
    this.#channels.set(counterpart, channel);
    this.#connect(channel);
    this.#hooks.onProvider(changeOf('added', counterpart));
    this.#datagrams?.deliverEarly(channel);
  }

  #onModified(counterpart, isTold) {
    const channel = this.#channels.get(counterpart);
    channel.provider = describe(counterpart);
    this.#connect(channel);
    if (isTold) this.#hooks.onProvider(changeOf('modified', counterpart));
    this.#datagrams?.deliverEarly(channel);
  }

  #onRemoved(counterpart, reason) {
    const channel = this.#channels.get(counterpart);
    const last = this.#endings.lastOf(channel.life);
    this.#channels.delete(counterpart);
    this.#disconnect(channel);
    if (reason === 'withdrawn' && last !== undefined) {
      this.#statistics.missed += Number(this.#sequence.missedAtEnd(channel.life, last, false));
    }
    this.#endings.forget(channel.life);
    this.#sequence.interrupt(channel.life);
    this.#hooks.onProvider(changeOf('removed', counterpart, reason));
  }

  /** Opens the inlet of a channel, or moves it to the new address of its provider, as far as its keys are known. */
  #connect(channel) {
    const { counterpart } = channel;
    const { protocol, port, mode, convert, via } = counterpart.event;
    const address = canonicalAddress(counterpart.event.address);
    channel.convert = convert && this.#conversions.along(convert, via);
    const isDatagrams = protocol === 'udp' && this.#datagrams;
    if (address === undefined) {
      this.#problem(channel, `${counterpart.service} has no address`);
    } else if (!isDatagrams && (protocol !== 'tcp' || channel.life === 0n)) {
      this.#problem(channel, `${counterpart.service} has no channel that can be opened: protocol ${protocol}`);
    } else if (!this.#hasKeys(channel)) {
      this.#disconnect(channel);
    } else if (isDatagrams) {
      this.#streams.delete(channel);
      this.#datagrams.add(channel, { address, port, isStream: mode === 'otm/stream' });
    } else {
      this.#datagrams?.delete(channel);
      this.#streams.add(channel, { address, port });
    }
  }

  /** Whether it is known how a channel is sealed, and it can be. */
  #hasKeys(channel) {
    if (channel.life === 0n) {
      if (this.#sealing.takesPlain) return true;
      this.#problem(channel, `${channel.counterpart.service} states no life, so its channel cannot be sealed`);
      return false;
    }
    const keys = this.#keys.get(channel.life, this.#sealing.hasKeys ? undefined : plainKeys);
    if (!keys) {
      // A channel keeps the keys that it has until its daemon, which came back, has told them again.
      return this.#keys.get(channel.life, channel.belief) !== undefined;
    }
    if (!channel.belief) {
      channel.belief = new Belief(this.#frames.life, channel.life, keys);
    } else if (channel.belief.keys !== keys) {
      channel.belief.rekey(keys);
      channel.stream?.rekey();
    }
    return true;
  }

  #streamHooks() {
    return {
      hasRoom: () => this.#hooks.hasRoom(),
      onMessage: (channel, frame) => this.#onFrame(channel, frame, false),
      onEnd: (channel, frame) => this.#onEnd(channel, frame),
      onLost: ({ counterpart }) => {
        if (counterpart.isMatched) return true;
        this.#counterparts.remove(counterpart, counterpart.reason);
        return false;
      },
      onDropped: () => ++this.#statistics.dropped,
      onOctets: ({ counterpart }) => this.#counterparts.touch(counterpart),
      onFull: (channel) => this.#onFull(channel),
      onFailed: this.#hooks.onFailed,
      onNoPlace: (what, count) => {
        if (!this.#hasNoPlaces) this.#hooks.onProblem(`all ${count} places for ${what} are taken`);
        this.#hasNoPlaces = true;
      },
      onPlaces: () => {
        this.#hasNoPlaces = false;
      },
    };
  }

  #disconnect(channel) {
    this.#datagrams?.delete(channel);
    this.#streams.delete(channel);
  }

  #endPatience(counterpart) {
    const channel = this.#channels.get(counterpart);
    if (channel?.stream) return limits.endPatience;
    return channel?.where && this.#endings.lastOf(channel.life) === undefined ? limits.datagramEndPatience : 0;
  }

  #orphanPatience(counterpart) {
    if (counterpart.event.protocol !== 'tcp') return limits.orphanPatience;
    return this.#channels.get(counterpart)?.stream?.isConnected ? Infinity : 0;
  }

  /** Tells the application of a problem of a channel, once. */
  #problem(channel, text) {
    if (channel.told.has(text)) return;
    channel.told.add(text);
    this.#hooks.onProblem(text);
  }

  #problemOnce(text) {
    if (this.#toldProblems.has(text)) return;
    this.#toldProblems.add(text);
    this.#hooks.onProblem(text);
  }

  #onFull({ belief, counterpart }) {
    if (belief.hasToldFull) return;
    belief.hasToldFull = true;
    const { address, port } = counterpart.event;
    this.#hooks.onProblem(`the provider ${address.includes(':') ? `[${address}]` : address}:${port} has no place for another consumer`);
  }

  #onFrame(channel, frame, isDatagram) {
    const isSure = frame.isSealed || !isDatagram;
    if (frame.kind === kinds.end) {
      if (isSure) this.#onEnd(channel, frame);
      else this.#onEndHint(channel, frame);
      return;
    }
    const missed = this.#missed(channel, frame, isSure);
    if (missed === undefined) {
      // A group is received on several interfaces.
      if (!isMulticast(channel.where?.address)) ++this.#statistics.dropped;
      return;
    }
    this.#statistics.missed += Number(missed);
    const payload = this.#converted(channel, frame.payload);
    if (payload === undefined) ++this.#statistics.dropped;
    else this.#hooks.onMessage(channel, { ...frame, payload }, missed, isDatagram);
  }

  #missed({ life }, { sequence }, isSure) {
    if (life === 0n) return 0n;
    return isSure ? this.#sequence.takeSurely(life, sequence) : this.#sequence.take(life, sequence, this.#timers.now());
  }

  /** An end that nobody can have forged. */
  #onEnd({ life, counterpart }, { sequence }) {
    this.#statistics.missed += Number(this.#sequence.missedAtEnd(life, sequence));
    this.#endings.forget(life);
    if (counterpart.event.protocol === 'tcp') this.#endings.keepMatches(counterpart.words.values());
    this.#counterparts.remove(counterpart, 'withdrawn');
  }

  /** An end that anybody can have forged counts where the daemon says the same, before or afterwards. */
  #onEndHint({ life, counterpart }, { sequence }) {
    this.#endings.say(life, sequence);
    if (counterpart.isEnding) this.#counterparts.remove(counterpart, 'withdrawn');
  }

  #converted(channel, payload) {
    if (!channel.convert) return payload;
    try {
      return channel.convert(payload);
    } catch (error) {
      if (!channel.hasToldFailure) this.#problem(channel, error.message);
      channel.hasToldFailure = true;
      return undefined;
    }
  }
}
