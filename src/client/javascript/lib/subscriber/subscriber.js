// What this program asks for, with the channels on which it receives.
import { EventEmitter } from 'node:events';

import { canonicalAddress, isMulticast } from '../core/address.js';
import { Conversions } from '../core/conversion.js';
import { Memory, Track } from '../core/delivery.js';
import { changeOf, describe } from '../core/description.js';
import { AbortError, ClosedError, GemingaError, StatementError } from '../core/errors.js';
import { kinds, lifeText, newLife } from '../core/frame.js';
import * as limits from '../core/limits.js';
import { PeerBook } from '../core/peer_book.js';
import { MessageQueue } from '../core/queue.js';
import { parametersOf } from '../core/request.js';
import { abortable, onAbort, throwIfAborted } from '../io/abort.js';
import { checkFixed, portOf } from '../publisher/publisher.js';
import { DatagramsIn } from './datagrams_in.js';
import { StreamIn } from './stream_in.js';

const fixed = ['mode', 'port', 'address', 'protocol'];

/** One provider's channel. */
class Channel {
  constructor(peer, last) {
    this.peer = peer;
    this.life = peer.life;
    this.track = new Track(last);
    this.provider = describe(peer);
    this.where = undefined;
    this.stream = undefined;
    this.convert = undefined;
    this.hasToldFailure = false;
  }
}

/**
 * An async iterable of messages `{payload, life, sequence, missed, provider}`. Events: `provider` with
 * `{change: 'added' | 'modified' | 'removed', reason, life, ...}`; `problem` with an Error. Made by `node.subscribe`.
 */
export class Subscriber extends EventEmitter {
  #session;
  #io;
  #timers;
  #onClosed;
  #book;
  #channels = new Map();
  #datagrams;
  #conversions;
  #queue;
  #memory = new Memory();
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
    this.#queue = new MessageQueue(queue, limits.maxQueuedOctets);
    this.#conversions = new Conversions(conversions);
    this.#mode = options.mode;
    this.#book = new PeerBook(this.#timers, {
      added: (peer) => this.#onAdded(peer),
      modified: (peer, before, isTold) => this.#onModified(peer, isTold),
      removed: (peer, reason) => this.#onRemoved(peer, reason),
      endPatience: (peer) => (this.#channels.get(peer)?.stream ? limits.endPatience : limits.datagramEndPatience),
      isHeld: (peer) => this.#channels.get(peer)?.stream?.isHeld ?? false,
      orphanPatience: (peer) => this.#orphanPatience(peer),
    });
    this.#setLimit(options);
    this.#open(options);
    onOpened(this);
    this.#offAbort = onAbort(signal, () => this.#fail(new AbortError(signal)));
  }

  /** Fulfilled when the daemon has taken it. */
  async ready({ signal } = {}) {
    await abortable(this.#taken, signal);
    return this;
  }

  /** The UDP port where it listens, if it does. */
  get port() {
    return this.#datagrams?.port;
  }

  get providers() {
    return [...this.#book].map(describe);
  }

  /** `missed` by the sequences; `overflowed`: came and were lost since nobody took them; `dropped`: not believed or converted. */
  get statistics() {
    return { ...this.#statistics };
  }

  /** Gives it a function for the conversion `A>B`. */
  convert(name, convert) {
    this.#conversions.set(name, convert);
  }

  /** The next message; undefined when it has been closed. Rejects when it was refused or its signal was aborted. */
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

  /** All messages from now on. Leaving the loop closes the subscription, as it does with streams. */
  async *[Symbol.asyncIterator]() {
    try {
      for (let message = await this.receive(); message; message = await this.receive()) yield message;
    } finally {
      await this.close();
    }
  }

  /** Changes what is asked for: all options but mode, port, address and protocol. Fulfilled when the daemon took it. */
  async modify({ signal, ...options }) {
    if (this.#closing) throw new ClosedError('subscriber');
    checkFixed(options, fixed);
    await abortable(this.#session.modify(this.#request, parametersOf(options, 'sub')), signal);
    if (options.limit !== undefined) this.#setLimit(options);
  }

  /** Takes it back. Messages that have been received already can still be taken. */
  close() {
    this.#closing ??= this.#close();
    return this.#closing;
  }

  onDaemonLost() {
    this.#book.onDaemonLost();
  }

  onDaemonBack() {
    this.#book.onDaemonBack();
  }

  #setLimit({ limit }) {
    this.#book.limit = limit === undefined ? (this.#mode === 'oto' ? 1 : 0) : Number(limit);
  }

  #open({ port, ...options }) {
    const words = options.protocol ?? 'udp,tcp';
    const protocols = Array.isArray(words) ? words : String(words).split(',');
    if (!protocols.every((word) => word === 'udp' || word === 'tcp')) {
      throw new StatementError(`protocol=${words}: channels are udp and tcp`);
    }
    const parameters = parametersOf({ ...options, protocol: protocols }, 'sub');
    if (protocols.includes('udp')) {
      this.#datagrams = new DatagramsIn(this.#io, { port: portOf(port), ownLife: this.life }, {
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
        (event) => this.#book.onEvent(event), (error) => this.#onProblem(error));
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
    this.#book.clear();
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

  #onAdded(peer) {
    const channel = new Channel(peer, this.#memory.lastOf(peer.life));
    this.#channels.set(peer, channel);
    this.#connect(channel);
    this.emit('provider', changeOf('added', peer));
    this.#datagrams?.deliverEarly(channel);
  }

  #onModified(peer, isTold) {
    const channel = this.#channels.get(peer);
    channel.provider = describe(peer);
    this.#connect(channel);
    if (isTold) this.emit('provider', changeOf('modified', peer));
    this.#datagrams?.deliverEarly(channel);
  }

  #onRemoved(peer, reason) {
    const channel = this.#channels.get(peer);
    this.#channels.delete(peer);
    this.#disconnect(channel);
    this.#memory.remember(channel.life, channel.track.last);
    this.emit('provider', changeOf('removed', peer, reason));
  }

  /** Opens what a channel needs, or moves it to where its provider is now. */
  #connect(channel) {
    const { peer } = channel;
    const { protocol, port, mode, convert, via } = peer.event;
    const address = canonicalAddress(peer.event.address);
    channel.convert = convert && this.#conversions.along(convert, via);
    if (address === undefined) {
      this.#problem(channel, `${peer.service} has no address`);
    } else if (protocol === 'udp' && this.#datagrams) {
      if (channel.where?.address === address && channel.where.port === port) return;
      this.#disconnect(channel);
      this.#datagrams.add(channel, { address, port, isStream: mode === 'otm/stream' });
    } else if (protocol === 'tcp' && channel.life !== 0n) {
      this.#datagrams?.delete(channel);
      if (channel.stream) channel.stream.move(address, port);
      else channel.stream = this.#streamOf(channel, address, port);
    } else {
      this.#problem(channel, `${peer.service} has no channel that can be opened: protocol ${protocol}`);
    }
  }

  #streamOf(channel, address, port) {
    return new StreamIn(this.#io, { ownLife: this.life, life: channel.life, address, port }, {
      hasRoom: () => this.#queue.hasRoom,
      onMessage: (frame) => this.#onFrame(channel, frame, false),
      onEnd: (frame) => this.#onEnd(channel, frame),
      onLost: () => {
        const { peer } = channel;
        if (peer.isMatched) return true;
        this.#book.remove(peer, peer.reason);
        return false;
      },
      onDropped: () => ++this.#statistics.dropped,
      onOctets: () => this.#book.touch(channel.peer),
    });
  }

  #disconnect(channel) {
    this.#datagrams?.delete(channel);
    channel.stream?.close();
    channel.stream = undefined;
  }

  #orphanPatience(peer) {
    const stream = this.#channels.get(peer)?.stream;
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
    const missed = channel.life === 0n ? 0n : channel.track.take(frame.sequence);
    if (missed === undefined) {
      // A group is heard on several interfaces.
      if (!isMulticast(channel.where?.address)) ++this.#statistics.dropped;
      return;
    }
    this.#statistics.missed += Number(missed);
    const payload = this.#converted(channel, frame.payload);
    if (payload === undefined) {
      ++this.#statistics.dropped;
      return;
    }
    const item = { channel, sequence: frame.sequence, missed, payload, provider: channel.provider };
    for (const lost of this.#queue.push(item, isDatagram)) {
      ++this.#statistics.overflowed;
      lost.channel.track.lose(lost.missed);
    }
    if (this.#waiting.length > 0) this.#waiting.shift().resolve(this.#take());
  }

  #onEnd(channel, { sequence }) {
    this.#statistics.missed += Number(channel.track.finish(sequence));
    this.#book.remove(channel.peer, 'withdrawn');
  }

  #onProblem(error) {
    this.emit('problem', error);
    if (this.#request.isRefused) this.#book.removeAll('refused');
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
    const item = this.#queue.shift();
    if (!item) return undefined;
    const { channel, sequence, payload, provider } = item;
    const missed = Number(channel.track.missedBefore(item.missed));
    ++this.#statistics.received;
    if (this.#queue.isHalfEmpty) this.#resume();
    return { payload, life: channel.life, sequence, missed, provider };
  }

  #resume() {
    for (const { stream } of this.#channels.values()) stream?.resume();
  }
}
