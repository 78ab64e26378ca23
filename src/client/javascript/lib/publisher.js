// A publisher: a service with a channel, which sends to its consumers.
import { EventEmitter } from 'node:events';

import { canonicalAddress, isMulticast } from './protocol/address.js';
import { changeOf, describe } from './protocol/description.js';
import { ClosedError, MessageTooLargeError, StatementError } from './protocol/errors.js';
import { encodeFrame, kinds, MessageWriter } from './protocol/frame.js';
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
  #timers;
  #counterparts;
  #out;
  #request;
  #maxSize;
  #hint;
  #sequence = 0;
  #writer;
  #closing;
  #onClosed;
  /** Consumers that the application was told of. */
  #reached = new Set();
  /** Events that come before the application can add listeners. */
  #early = [];

  /** Opens the sockets, states the service, and waits until the daemon has accepted it. Used by Node. */
  static async open({ session, io, onOpened, onClosed }, { signal, ...options }) {
    throwIfAborted(signal);
    const publisher = new Publisher(session, io, options, onClosed);
    onOpened(publisher);
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

  constructor(session, io, { mode, protocol = 'udp', address, port }, onClosed) {
    super();
    this.#session = session;
    this.#io = io;
    this.#onClosed = onClosed;
    this.life = newLife();
    this.#timers = io.timers();
    if (protocol !== 'udp' && protocol !== 'tcp') throw new StatementError(`protocol=${protocol}: a channel is udp or tcp`);
    const isTcp = protocol === 'tcp';
    // The system says of a datagram whether it waits; of TCP that is not known.
    this.#writer = new MessageWriter(this.life, !isTcp);
    this.#maxSize = isTcp ? limits.maxStreamMessage : limits.maxDatagramMessage;
    this.#hint = isTcp ? 'over TCP' : 'over UDP: offer the service with protocol=tcp';
    this.#out = this.#channel(mode, isTcp, canonicalAddress(address), portOf(port));
    this.#counterparts = new Counterparts(this.#timers, {
      added: (counterpart) => {
        this.#out.set(counterpart.key, counterpart.event, counterpart.life === 0n);
        if (!isTcp) this.#reach(counterpart);
      },
      modified: (counterpart, before, isTold) => {
        this.#out.set(counterpart.key, counterpart.event, counterpart.life === 0n);
        if (isTold && this.#reached.has(counterpart)) this.#tell(changeOf('modified', counterpart));
      },
      removed: (counterpart, reason) => {
        this.#out.delete(counterpart.key);
        this.#lose(counterpart, reason);
      },
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
    return { sent: this.#sequence, leftOut: this.#out.leftOut, dropped: this.#out.dropped };
  }

  /**
   * Sends a message to all consumers; without one it does nothing. If it gives false, wait for `drained` before the next
   * message, or slow consumers lose some. Throws MessageTooLargeError and ClosedError. The payload may be used again at once.
   */
  send(payload) {
    if (!(payload instanceof Uint8Array)) throw new TypeError('a message is a Uint8Array');
    if (payload.length > this.#maxSize) throw new MessageTooLargeError(payload.length, this.#maxSize, this.#hint);
    if (this.#closing) throw new ClosedError('publisher');
    if (!this.#out.hasConsumer) return true;
    const isPrompt = this.#out.send(this.#writer.write(++this.#sequence, payload));
    if (this.#writer.isLent && this.#out.waiting > 0) this.#writer.keep();
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
    this.#counterparts.onDaemonBack();
  }

  #channel(mode, isTcp, address, port) {
    const isStream = mode === 'otm/stream';
    const options = { address, port, life: this.life };
    if (isTcp) return new TcpOutlet(this.#io, { ...options, isStream, hooks: this.#connectionHooks() });
    if (isStream) return isMulticast(address) ? new MulticastOutlet(this.#io, options) : new ListenersOutlet(this.#io, options);
    return new UdpOutlet(this.#io, { ...options, isLazy: mode === 'otm/pubsub', hooks: this.#portHooks() });
  }

  async #open(options) {
    // Read before a socket is opened, so that a wrong option is told first.
    const parameters = parametersOf({ ...options, port: undefined }, 'pub');
    await this.#out.open();
    if (this.#closing) {
      await this.#out.end(encodeFrame(kinds.end, this.life, 0n));
      throw new ClosedError('publisher');
    }
    parameters.push(['port', String(this.#out.port)], ['channel', lifeText(this.life)]);
    const { request, taken } = this.#session.create('pub', parameters,
      (event) => this.#counterparts.onEvent(event), (error) => this.#onProblem(error));
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
    const ended = this.#out.end(encodeFrame(kinds.end, this.life, BigInt(this.#sequence)));
    const removed = this.#request && this.#session.remove(this.#request);
    this.#counterparts.clear();
    await Promise.all([ended, this.#io.within(limits.closePatience, removed)]);
    this.#io.forget(this.#timers);
    this.#onClosed(this);
    this.emit('close');
  }

  /** Over TCP a consumer is told while it is matched and connected. */
  #connectionHooks() {
    const withKey = (key, action) => {
      for (const counterpart of [...this.#counterparts]) if (counterpart.key === key) action(counterpart);
    };
    return {
      onCome: (key) => withKey(key, (counterpart) => this.#reach(counterpart)),
      onGone: (key) => withKey(key, (counterpart) => {
        if (counterpart.isMatched) this.#lose(counterpart, 'lost');
        else this.#counterparts.remove(counterpart, counterpart.reason);
      }),
    };
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
    this.emit('problem', error);
    if (this.#request.isRefused) this.#counterparts.removeAll('refused');
  }

  #portHooks() {
    const onProblem = (error) => this.emit('problem', error);
    return {
      onProblem,
      onMoved: (port) => this.#session.modify(this.#request, [['port', String(port)]]).catch(onProblem),
    };
  }
}
