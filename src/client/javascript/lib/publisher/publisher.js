// A service that this program offers, with the channel on which it sends.
import { EventEmitter } from 'node:events';

import { canonicalAddress, isMulticast } from '../core/address.js';
import { changeOf, describe } from '../core/description.js';
import { ClosedError, MessageTooLargeError, StatementError } from '../core/errors.js';
import { encodeFrame, kinds, lifeText, MessageWriter, newLife } from '../core/frame.js';
import * as limits from '../core/limits.js';
import { PeerBook } from '../core/peer_book.js';
import { parametersOf } from '../core/request.js';
import { abortable, throwIfAborted } from '../io/abort.js';
import { Connections } from './connections.js';
import { Datagrams } from './datagrams.js';
import { Group } from './group.js';
import { Listeners } from './listeners.js';

const fixed = ['mode', 'port', 'address', 'protocol'];

/**
 * Events: `consumer` with `{change: 'added' | 'modified' | 'removed', reason, life, ...}`, not for `otm/stream`, whose
 * provider is not told; `problem` with an Error. Made by `node.publish`.
 */
export class Publisher extends EventEmitter {
  #session;
  #io;
  #timers;
  #book;
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
  /** What is told before the application can listen. */
  #early = [];

  /** Opens what must be found, states it, and waits until the daemon has taken it. Used by Node. */
  static async open({ session, io, onOpened, onClosed }, { signal, ...options }) {
    throwIfAborted(signal);
    const publisher = new Publisher(session, io, options, onClosed);
    onOpened(publisher);
    try {
      await abortable(publisher.#open(options), signal);
      // Who awaited this adds listeners first.
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
    // The system takes a datagram at once or says that it waits; what TCP still holds is not known.
    this.#writer = new MessageWriter(this.life, !isTcp);
    this.#maxSize = isTcp ? limits.maxStreamMessage : limits.maxDatagramMessage;
    this.#hint = isTcp ? 'over TCP' : 'over UDP: offer the service with protocol=tcp';
    this.#out = this.#channel(mode, isTcp, canonicalAddress(address), portOf(port));
    this.#book = new PeerBook(this.#timers, {
      added: (peer) => {
        this.#out.set(peer.key, peer.event, peer.life === 0n);
        if (!isTcp) this.#reach(peer);
      },
      modified: (peer, before, isTold) => {
        this.#out.set(peer.key, peer.event, peer.life === 0n);
        if (isTold && this.#reached.has(peer)) this.#tell(changeOf('modified', peer));
      },
      removed: (peer, reason) => {
        this.#out.delete(peer.key);
        this.#lose(peer, reason);
      },
      endPatience: () => 0,
      isHeld: () => false,
      orphanPatience: (peer) => (isTcp ? (this.#out.isConnected(peer.key) ? Infinity : 0) : limits.orphanPatience),
    });
  }

  /** The port at which it can be found. */
  get port() {
    return this.#out.port;
  }

  /** What is known of its consumers: those that a message reaches. */
  get consumers() {
    return [...this.#reached].map(describe);
  }

  /** Whether a message would be sent to anybody. */
  get hasConsumer() {
    return this.#out.hasConsumer;
  }

  /** `sent`: messages given while there was a consumer; `leftOut`: of each consumer, those for which there was no room. */
  get statistics() {
    return { sent: this.#sequence, leftOut: this.#out.leftOut, dropped: this.#out.dropped };
  }

  /**
   * Sends a message to all consumers; without one it does nothing. False: better wait for `drained` before the next, or
   * slow consumers lose some. Throws MessageTooLargeError and ClosedError. The payload may be used again at once.
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

  /** Changes what is stated: all options but mode, port, address and protocol. Fulfilled when the daemon has taken it. */
  async modify({ signal, ...options }) {
    if (this.#closing) throw new ClosedError('publisher');
    checkFixed(options, fixed);
    await abortable(this.#session.modify(this.#request, parametersOf(options, 'pub')), signal);
  }

  /** Withdraws it: what waits is sent first, and TCP consumers are told where it ends. */
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

  #channel(mode, isTcp, address, port) {
    const isStream = mode === 'otm/stream';
    const options = { address, port, life: this.life };
    if (isTcp) return new Connections(this.#io, { ...options, isStream, hooks: this.#connectionHooks() });
    if (isStream) return isMulticast(address) ? new Group(this.#io, options) : new Listeners(this.#io, options);
    return new Datagrams(this.#io, { ...options, isLazy: mode === 'otm/pubsub', hooks: this.#portHooks() });
  }

  async #open(options) {
    // Read before any socket is opened, so that a wrong word is told first.
    const parameters = parametersOf({ ...options, port: undefined }, 'pub');
    await this.#out.open();
    if (this.#closing) {
      await this.#out.end(encodeFrame(kinds.end, this.life, 0n));
      throw new ClosedError('publisher');
    }
    parameters.push(['port', String(this.#out.port)], ['channel', lifeText(this.life)]);
    const { request, taken } = this.#session.create('pub', parameters,
      (event) => this.#book.onEvent(event), (error) => this.#onProblem(error));
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
    this.#book.clear();
    await Promise.all([ended, this.#io.within(limits.closePatience, removed)]);
    this.#io.forget(this.#timers);
    this.#onClosed(this);
    this.emit('close');
  }

  /** Over TCP a consumer is one as long as it is matched and connected. */
  #connectionHooks() {
    const withKey = (key, action) => {
      for (const peer of [...this.#book]) if (peer.key === key) action(peer);
    };
    return {
      onCome: (key) => withKey(key, (peer) => this.#reach(peer)),
      onGone: (key) => withKey(key, (peer) => {
        if (peer.isMatched) this.#lose(peer, 'lost');
        else this.#book.remove(peer, peer.reason);
      }),
    };
  }

  /** Messages reach this consumer from now on. */
  #reach(peer) {
    if (this.#reached.has(peer)) return;
    this.#reached.add(peer);
    this.#tell(changeOf('added', peer));
  }

  #lose(peer, reason) {
    if (this.#reached.delete(peer)) this.#tell(changeOf('removed', peer, reason));
  }

  #onProblem(error) {
    this.emit('problem', error);
    if (this.#request.isRefused) this.#book.removeAll('refused');
  }

  #portHooks() {
    const onProblem = (error) => this.emit('problem', error);
    return {
      onProblem,
      onMoved: (port) => this.#session.modify(this.#request, [['port', String(port)]]).catch(onProblem),
    };
  }
}

/** A port as the user says it; 0 and undefined are any. */
export function portOf(port = 0) {
  if (Number.isInteger(port) && port >= 0 && port <= 65535) return port;
  throw new StatementError(`port=${port}: a port is a number from 0 to 65535, where 0 is any`);
}

/** Some things cannot change while a channel is there. */
export function checkFixed(options, keys) {
  for (const key of keys) {
    if (options[key] !== undefined) throw new StatementError(`${key} cannot be changed: close it and make another one`);
  }
  if (options.attributes?.channel !== undefined) throw new StatementError('channel is stated by the library');
}
