// A subscriber: a request for services with channels, which receives from its providers.
import { EventEmitter } from 'node:events';

import { canonicalAddress, isMulticast } from './protocol/address.js';
import { Converter } from './protocol/converter.js';
import { Sequence } from './protocol/sequence.js';
import { changeOf, describe } from './protocol/description.js';
import { AbortError, ClosedError, GemingaError, StatementError } from './protocol/errors.js';
import { kinds } from './protocol/frame.js';
import { lifeText, newLife } from './protocol/life.js';
import * as limits from './protocol/limits.js';
import { Counterparts } from './protocol/counterparts.js';
import { Inbox } from './protocol/inbox.js';
import { checkFixed, parametersOf, portOf } from './protocol/request.js';
import { abortable, onAbort, throwIfAborted } from './channels/abort.js';
import { UdpInlet } from './channels/udp_inlet.js';
import { TcpInlet } from './channels/tcp_inlet.js';

const fixed = ['mode', 'port', 'address', 'protocol'];

/** The channel from one provider. */
class Channel {
  constructor(counterpart) {
    this.counterpart = counterpart;
    this.life = counterpart.life;
    this.provider = describe(counterpart);
    this.where = undefined;
    this.stream = undefined;
    this.convert = undefined;
    this.hasToldFailure = false;
  }
}

/**
 * Made by `node.subscribe`. An async iterable of messages `{payload, life, sequence, missed, provider}`. Events: `provider` with
 * `{change: 'added' | 'modified' | 'removed', reason, life, ...}`; `problem` with an Error.
 */
export class Subscriber extends EventEmitter {
  #session;
  #io;
  #timers;
  #onClosed;
  #counterparts;
  #channels = new Map();
  #datagrams;
  #conversions;
  #inbox;
  #sequence = new Sequence();
  #request;
  #taken;
  #mode;
  #waiting = [];
  #failure;
  #closing;
  #offAbort;
  #statistics = { received: 0, missed: 0, dropped: 0, overflowed: 0 };

  /** Throws StatementError and PortError. */
  constructor({ session, io, onOpened, onClosed }, { signal, queue = limits.queueLength, conversions, ...options }) {
    super();
    throwIfAborted(signal);
    if (!Number.isInteger(queue) || queue < 1) throw new TypeError('queue is a number of messages, at least 1');
    this.#session = session;
    this.#io = io;
    this.#onClosed = onClosed;
    this.life = newLife();
    this.#timers = io.timers();
    this.#inbox = new Inbox(queue, limits.maxQueuedOctets);
    this.#conversions = new Converter(conversions);
    this.#mode = options.mode;
    this.#counterparts = new Counterparts(this.#timers, {
      added: (counterpart) => this.#onAdded(counterpart),
      modified: (counterpart, before, isTold) => this.#onModified(counterpart, isTold),
      removed: (counterpart, reason) => this.#onRemoved(counterpart, reason),
      endPatience: (counterpart) => (this.#channels.get(counterpart)?.stream ? limits.endPatience : limits.datagramEndPatience),
      isHeld: (counterpart) => this.#channels.get(counterpart)?.stream?.isHeld ?? false,
      orphanPatience: (counterpart) => this.#orphanPatience(counterpart),
    });
    this.#setLimit(options);
    this.#open(options);
    onOpened(this);
    this.#offAbort = onAbort(signal, () => this.#fail(new AbortError(signal)));
  }

  /** Fulfilled when the daemon has accepted the request. */
  async ready({ signal } = {}) {
    await abortable(this.#taken, signal);
    return this;
  }

  /** The UDP port where it listens, if it has one. */
  get port() {
    return this.#datagrams?.port;
  }

  get providers() {
    return [...this.#counterparts].map(describe);
  }

  /**
   * `missed`: known to be missing; `overflowed`: those of them that came and were lost, since the inbox was full; `dropped`: not
   * believed or not converted.
   */
  get statistics() {
    return { ...this.#statistics };
  }

  /** Adds a function for the conversion `A>B`. */
  convert(name, convert) {
    this.#conversions.set(name, convert);
  }

  /** The next message; undefined when the subscriber is closed. Rejects when it was refused or its signal was aborted. */
  async receive({ signal } = {}) {
    throwIfAborted(signal);
    if (this.#failure) throw this.#failure;
    const message = this.#take();
    if (message) return message;
    if (this.#closing) return undefined;
    return new Promise((resolve, reject) => {
      const waiter = {
        resolve: (value) => {
          off();
          resolve(value);
        },
        reject: (error) => {
          off();
          reject(error);
        },
      };
      const off = onAbort(signal, () => {
        this.#waiting.splice(this.#waiting.indexOf(waiter), 1);
        reject(new AbortError(signal));
      });
      this.#waiting.push(waiter);
    });
  }

  /** All messages from now on. Leaving the loop closes the subscriber, as with streams. */
  async *[Symbol.asyncIterator]() {
    try {
      for (let message = await this.receive(); message; message = await this.receive()) yield message;
    } finally {
      await this.close();
    }
  }

  /** Changes options, but not mode, port, address and protocol. Fulfilled when the daemon has accepted the change. */
  async modify({ signal, ...options }) {
    if (this.#closing) throw new ClosedError('subscriber');
    checkFixed(options, fixed);
    await abortable(this.#session.modify(this.#request, parametersOf(options, 'sub')), signal);
    if (options.limit !== undefined) this.#setLimit(options);
  }

  /** Withdraws the request. Messages that have come can still be received. */
  close() {
    this.#closing ??= this.#close();
    return this.#closing;
  }

  onDaemonLost() {
    this.#counterparts.onDaemonLost();
  }

  onDaemonBack() {
    this.#counterparts.onDaemonBack();
  }

  #setLimit({ limit }) {
    this.#counterparts.limit = limit === undefined ? (this.#mode === 'oto' ? 1 : 0) : Number(limit);
  }

  #open({ port, ...options }) {
    const words = options.protocol ?? 'udp,tcp';
    const protocols = Array.isArray(words) ? words : String(words).split(',');
    if (!protocols.every((word) => word === 'udp' || word === 'tcp')) {
      throw new StatementError(`protocol=${words}: channels are udp and tcp`);
    }
    const parameters = parametersOf({ ...options, protocol: protocols }, 'sub');
    if (protocols.includes('udp')) {
      this.#datagrams = new UdpInlet(this.#io, { port: portOf(port), ownLife: this.life }, {
        onFrame: (channel, frame) => this.#onFrame(channel, frame, true),
        onDropped: () => ++this.#statistics.dropped,
        onFound: () => --this.#statistics.dropped,
        onProblem: (error) => this.emit('problem', error),
      });
      parameters.push(['port', String(this.#datagrams.port)]);
    } else if (port) {
      parameters.push(['port', String(port)]);
    }
    parameters.push(['channel', lifeText(this.life)]);
    try {
      const { request, taken } = this.#session.create('sub', parameters,
        (event) => this.#counterparts.onEvent(event), (error) => this.#onProblem(error));
      this.#request = request;
      this.#taken = taken;
      taken.catch((error) => this.#fail(error));
    } catch (error) {
      this.#datagrams?.close();
      throw error;
    }
  }

  async #close() {
    this.#offAbort?.();
    for (const channel of this.#channels.values()) this.#disconnect(channel);
    this.#channels.clear();
    this.#counterparts.clear();
    this.#datagrams?.close();
    this.#io.forget(this.#timers);
    for (const { resolve } of this.#waiting.splice(0)) resolve(undefined);
    await this.#io.within(limits.closePatience, this.#session.remove(this.#request));
    this.#onClosed(this);
    this.emit('close');
  }

  #fail(error) {
    if (this.#closing) return;
    this.#failure = error;
    for (const { reject } of this.#waiting.splice(0)) reject(error);
    this.close();
  }

  #onAdded(counterpart) {
    const channel = new Channel(counterpart);
    this.#channels.set(counterpart, channel);
    this.#connect(channel);
    this.emit('provider', changeOf('added', counterpart));
    this.#datagrams?.deliverEarly(channel);
  }

  #onModified(counterpart, isTold) {
    const channel = this.#channels.get(counterpart);
    channel.provider = describe(counterpart);
    this.#connect(channel);
    if (isTold) this.emit('provider', changeOf('modified', counterpart));
    this.#datagrams?.deliverEarly(channel);
  }

  #onRemoved(counterpart, reason) {
    const channel = this.#channels.get(counterpart);
    this.#channels.delete(counterpart);
    this.#disconnect(channel);
    this.#sequence.interrupt(channel.life);
    this.emit('provider', changeOf('removed', counterpart, reason));
  }

  /** Opens the inlet of a channel, or moves it to the new address of its provider. */
  #connect(channel) {
    const { counterpart } = channel;
    const { protocol, port, mode, convert, via } = counterpart.event;
    const address = canonicalAddress(counterpart.event.address);
    channel.convert = convert && this.#conversions.along(convert, via);
    if (address === undefined) {
      this.#problem(channel, `${counterpart.service} has no address`);
    } else if (protocol === 'udp' && this.#datagrams) {
      if (channel.where?.address === address && channel.where.port === port) return;
      this.#disconnect(channel);
      this.#datagrams.add(channel, { address, port, isStream: mode === 'otm/stream' });
    } else if (protocol === 'tcp' && channel.life !== 0n) {
      this.#datagrams?.delete(channel);
      if (channel.stream) channel.stream.move(address, port);
      else channel.stream = this.#streamOf(channel, address, port);
    } else {
      this.#problem(channel, `${counterpart.service} has no channel that can be opened: protocol ${protocol}`);
    }
  }

  #streamOf(channel, address, port) {
    return new TcpInlet(this.#io, { ownLife: this.life, life: channel.life, address, port }, {
      hasRoom: () => this.#inbox.hasRoom,
      onMessage: (frame) => this.#onFrame(channel, frame, false),
      onEnd: (frame) => this.#onEnd(channel, frame),
      onLost: () => {
        const { counterpart } = channel;
        if (counterpart.isMatched) return true;
        this.#counterparts.remove(counterpart, counterpart.reason);
        return false;
      },
      onDropped: () => ++this.#statistics.dropped,
      onOctets: () => this.#counterparts.touch(channel.counterpart),
    });
  }

  #disconnect(channel) {
    this.#datagrams?.delete(channel);
    channel.stream?.close();
    channel.stream = undefined;
  }

  #orphanPatience(counterpart) {
    const stream = this.#channels.get(counterpart)?.stream;
    if (!stream) return limits.orphanPatience;
    return stream.isConnected ? Infinity : 0;
  }

  #problem(channel, text) {
    this.emit('problem', new GemingaError(`provider ${lifeText(channel.life)}: ${text}`, 'GEMINGA_CHANNEL'));
  }

  #onFrame(channel, frame, isDatagram) {
    if (frame.kind === kinds.end) {
      this.#onEnd(channel, frame);
      return;
    }
    const missed = channel.life === 0n ? 0n : this.#sequence.take(channel.life, frame.sequence);
    if (missed === undefined) {
      // A group is received on several interfaces.
      if (!isMulticast(channel.where?.address)) ++this.#statistics.dropped;
      return;
    }
    this.#statistics.missed += Number(missed);
    const payload = this.#converted(channel, frame.payload);
    if (payload === undefined) {
      ++this.#statistics.dropped;
      return;
    }
    const message = { payload, life: channel.life, sequence: frame.sequence, missed, provider: channel.provider };
    if (isDatagram) {
      const lost = this.#inbox.putDatagram(message);
      this.#statistics.overflowed += lost;
      this.#statistics.missed += lost;
    } else {
      this.#inbox.putStreamed(message);
    }
    if (this.#waiting.length > 0) this.#waiting.shift().resolve(this.#take());
  }

  #onEnd(channel, { sequence }) {
    this.#statistics.missed += Number(this.#sequence.missedAtEnd(channel.life, sequence));
    this.#counterparts.remove(channel.counterpart, 'withdrawn');
  }

  #onProblem(error) {
    this.emit('problem', error);
    if (this.#request.isRefused) this.#counterparts.removeAll('refused');
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

  #take() {
    const message = this.#inbox.take();
    if (!message) return undefined;
    ++this.#statistics.received;
    if (this.#inbox.isHalfEmpty) this.#resume();
    return { ...message, missed: Number(message.missed) };
  }

  #resume() {
    for (const { stream } of this.#channels.values()) stream?.resume();
  }
}
