// A publisher: a service with a channel, which sends to its consumers.
import { EventEmitter } from 'node:events';

import { canonicalAddress, isMulticast } from './protocol/address.js';
import { changeOf, describe } from './protocol/description.js';
import { ClosedError, GemingaError, MessageTooLargeError, StatementError } from './protocol/errors.js';
import { plainKeys } from './protocol/channel_keys.js';
import { PublisherFrames } from './protocol/frame_writer.js';
import { lifeText, newLife } from './protocol/life.js';
import * as limits from './protocol/limits.js';
import { Counterparts } from './protocol/counterparts.js';
import { checkFixed, parametersOf, portOf } from './protocol/request.js';
import { abortable, throwIfAborted } from './channels/abort.js';
import { TcpOutlet } from './channels/tcp_outlet.js';
import { UdpOutlet } from './channels/udp_outlet.js';
import { MulticastOutlet } from './channels/multicast_outlet.js';
import { ListenersOutlet } from './channels/listeners_outlet.js';

const fixed = ['mode', 'port', 'address', 'protocol'];

/**
 * Made by `node.publish`. Events: `consumer` with `{change: 'added' | 'modified' | 'removed', reason, life, ...}`, not for
 * `otm/stream`, where the daemon names no consumers; `problem` with an Error.
 */
export class Publisher extends EventEmitter {
  #session;
  #io;
  #sealing;
  #problem;
  #timers;
  #counterparts;
  #out;
  #request;
  #maxSize;
  #hint;
  #frames;
  #hasNoPlaces = false;
  #toldProblems = new Set();
  #closing;
  #onClosed;
  /** Consumers that the application was told of. */
  #reached = new Set();
  /** Events that come before the application can add listeners. */
  #early = [];

  /** Opens the sockets, states the service, and waits until the daemon has accepted it. Used by Node. */
  static async open(context, { signal, ...options }) {
    throwIfAborted(signal);
    const publisher = new Publisher(context, options);
    context.onOpened(publisher);
    try {
      await abortable(publisher.#open(options), signal);
      // The caller that awaits this adds listeners first.
      setImmediate(() => publisher.#tellEarly());
    } catch (error) {
      await publisher.close();
      throw error;
    }
    return publisher;
  }

  constructor({ session, io, sealing, onProblem, onClosed }, { mode, protocol = 'udp', address, port }) {
    super();
    this.#session = session;
    this.#io = io;
    this.#sealing = sealing;
    this.#problem = (error) => onProblem(this, error);
    this.#onClosed = onClosed;
    this.life = newLife();
    this.#timers = io.timers();
    if (protocol !== 'udp' && protocol !== 'tcp') throw new StatementError(`protocol=${protocol}: a channel is udp or tcp`);
    const isTcp = protocol === 'tcp';
    // The system says of a datagram whether it waits; of TCP that is not known.
    this.#frames = new PublisherFrames(this.life, !isTcp);
    if (sealing.hasKeys === false) this.#frames.keys = plainKeys;
    this.#maxSize = isTcp ? limits.maxStreamMessage : limits.maxDatagramMessage;
    this.#hint = isTcp ? 'over TCP' : 'over UDP: offer the service with protocol=tcp';
    this.#out = this.#channel(mode, isTcp, canonicalAddress(address), portOf(port));
    this.#counterparts = new Counterparts(this.#timers, {
      added: (counterpart) => this.#set(counterpart),
      modified: (counterpart, before, isTold) => {
        const wasReached = this.#reached.has(counterpart);
        this.#set(counterpart);
        if (isTold && wasReached) this.#tell(changeOf('modified', counterpart));
      },
      removed: (counterpart, reason) => {
        this.#out.delete(counterpart.key);
        this.#lose(counterpart, reason);
      },
      isOfPublisher: true,
      endPatience: () => 0,
      isHeld: () => false,
      orphanPatience: (counterpart) => (isTcp ? (this.#out.isConnected(counterpart.key) ? Infinity : 0) : limits.orphanPatience),
    });
  }

  /** The port where it can be reached. */
  get port() {
    return this.#out.port;
  }

  /** The consumers that messages reach. */
  get consumers() {
    return [...this.#reached].map(describe);
  }

  /** Whether there is a consumer. */
  get hasConsumer() {
    return this.#out.hasConsumer;
  }

  /** `sent`: messages while there was a consumer; `leftOut`: messages without room, counted for each consumer. */
  get statistics() {
    return { sent: this.#frames.sequence, leftOut: this.#out.leftOut, dropped: this.#out.dropped };
  }

  /**
   * Sends a message to all consumers; without one it does nothing. If it gives false, wait for `drained` before the next
   * message, or slow consumers lose some. Throws MessageTooLargeError and ClosedError. The payload may be used again at once.
   */
  send(payload) {
    if (!(payload instanceof Uint8Array)) throw new TypeError('payload is a Uint8Array, for example Buffer.from(text)');
    if (payload.length > this.#maxSize) throw new MessageTooLargeError(payload.length, this.#maxSize, this.#hint);
    if (this.#closing) throw new ClosedError('publisher');
    if (!this.#out.hasConsumer) return true;
    const isPrompt = this.#out.send(this.#message(payload), payload);
    if (this.#frames.isLent && this.#out.waiting > 0) this.#frames.keep();
    return isPrompt;
  }

  /** Fulfilled when nothing waits for any consumer. */
  async drained({ signal } = {}) {
    throwIfAborted(signal);
    while (this.#out.waiting > 0) {
      await abortable(this.#out.drained?.() ?? new Promise((resolve) => setImmediate(resolve)), signal);
    }
  }

  /** Changes options, but not mode, port, address and protocol. Fulfilled when the daemon has accepted the change. */
  async modify({ signal, ...options }) {
    if (this.#closing) throw new ClosedError('publisher');
    checkFixed(options, fixed);
    await abortable(this.#session.modify(this.#request, parametersOf(options, 'pub')), signal);
  }

  /** Withdraws the service. Messages that wait are sent first, and consumers are told the end. */
  close() {
    this.#closing ??= this.#close();
    return this.#closing;
  }

  onDaemonLost() {
    this.#counterparts.onDaemonLost();
  }

  onDaemonBack() {
    if (!this.#sealing.hasKeys) this.#rekey(plainKeys);
    this.#counterparts.onDaemonBack();
  }

  /** The daemon has said how this host seals, which counts for channels that have no line of keys. */
  onSealing() {
    if (!this.#sealing.hasKeys && !this.#frames.keys) this.#rekey(plainKeys);
  }

  #channel(mode, isTcp, address, port) {
    const isStream = mode === 'otm/stream';
    const options = { address, port, isStream, isLazy: mode === 'otm/pubsub', hooks: this.#outHooks() };
    if (isTcp) return new TcpOutlet(this.#io, this.#frames, options);
    if (!isStream) return new UdpOutlet(this.#io, this.#frames, options);
    return new (isMulticast(address) ? MulticastOutlet : ListenersOutlet)(this.#io, this.#frames, options);
  }

  async #open(options) {
    // Read before a socket is opened, so that a wrong option is told first.
    const parameters = parametersOf({ ...options, port: undefined }, 'pub');
    await this.#out.open();
    if (this.#closing) {
      await this.#out.end();
      throw new ClosedError('publisher');
    }
    parameters.push(['port', String(this.#out.port)], ['channel', lifeText(this.life)]);
    const { request, taken } = this.#session.create('pub', parameters, {
      onEvent: (event) => this.#counterparts.onEvent(event),
      onProblem: (error) => this.#onProblem(error),
      onKeys: (life, keys, error) => this.#onKeys(life, keys, error),
    });
    this.#request = request;
    await taken;
  }

  #tell(change) {
    if (this.#early) this.#early.push(change);
    else this.emit('consumer', change);
  }

  #tellEarly() {
    const early = this.#early;
    this.#early = undefined;
    for (const change of early) this.emit('consumer', change);
  }

  async #close() {
    // In one turn, so that no event comes between.
    const ended = this.#out.end();
    const removed = this.#request && this.#session.remove(this.#request);
    this.#counterparts.clear();
    await Promise.all([ended, this.#io.within(limits.closePatience, removed)]);
    this.#io.forget(this.#timers);
    this.#onClosed(this);
    this.emit('close');
  }

  /** A consumer is told while it is matched and messages reach it: over TCP while it is connected. */
  #outHooks() {
    const withKey = (key, action) => {
      for (const counterpart of this.#counterparts) if (counterpart.key === key) action(counterpart);
    };
    return {
      onCome: (key) => withKey(key, (counterpart) => this.#reach(counterpart)),
      onGone: (key, reason) => withKey(key, (counterpart) => {
        if (counterpart.isMatched) this.#lose(counterpart, reason);
        else this.#counterparts.remove(counterpart, counterpart.reason);
      }),
      onMoved: (port) => this.#state('port', port),
      onNoPlace: (what, count) => this.#onNoPlace(what, count),
      onPlaces: () => {
        if (this.#hasNoPlaces) this.#state('channel.full', 0);
        this.#hasNoPlaces = false;
      },
      onProblem: (error) => this.#problem(error),
    };
  }

  #set(counterpart) {
    this.#out.set(counterpart.key, counterpart.event, counterpart.life);
    if (counterpart.life !== 0n || this.#frames.takesPlain || !this.#frames.keys) return;
    this.#problemOnce(`${counterpart.service} states no life, so its channel cannot be sealed`);
  }

  #message(payload) {
    try {
      return this.#frames.message(payload, this.#out.isBusy);
    } catch (error) {
      if (error instanceof ClosedError) this.close();
      throw error;
    }
  }

  #onKeys(life, keys, error) {
    if (life !== this.life) return;
    if (error) this.#problemOnce(error.message);
    this.#rekey(keys);
    for (const counterpart of this.#counterparts) this.#set(counterpart);
  }

  #rekey(keys) {
    if (this.#frames.keys === keys || this.#closing) return;
    const didSeal = this.#frames.seals;
    this.#frames.keys = keys;
    this.#out.rekey(this.#frames.seals && !didSeal);
  }

  /** A newcomer found all places taken: tells it once, until there are places again, and states it for `query why`. */
  #onNoPlace(what, count) {
    if (this.#hasNoPlaces) return;
    this.#hasNoPlaces = true;
    this.#problem(new GemingaError(`all ${count} places for ${what} are taken`, 'GEMINGA_CHANNEL'));
    this.#state('channel.full', count);
  }

  #problemOnce(text) {
    if (this.#toldProblems.has(text)) return;
    this.#toldProblems.add(text);
    this.#problem(new GemingaError(text, 'GEMINGA_CHANNEL'));
  }

  /** Changes the request. An error of the daemon is told, because there is no call that it answers. */
  #state(key, value) {
    if (!this.#request || this.#closing) return;
    this.#session.modify(this.#request, [[key, String(value)]]).catch((error) => {
      if (!(error instanceof ClosedError)) this.#problem(error);
    });
  }

  /** Messages reach a consumer from now on. */
  #reach(counterpart) {
    if (this.#reached.has(counterpart)) return;
    this.#reached.add(counterpart);
    this.#tell(changeOf('added', counterpart));
  }

  #lose(counterpart, reason) {
    if (this.#reached.delete(counterpart)) this.#tell(changeOf('removed', counterpart, reason));
  }

  #onProblem(error) {
    this.#problem(error);
    if (this.#request.isRefused) this.#counterparts.removeAll('refused');
  }
}
