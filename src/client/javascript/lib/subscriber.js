// A subscriber: a request for services with channels, which receives from its providers.
import { EventEmitter } from 'node:events';

import { Converter } from './protocol/converter.js';
import { AbortError, ClosedError, GemingaError, StatementError } from './protocol/errors.js';
import { lifeText, newLife } from './protocol/life.js';
import * as limits from './protocol/limits.js';
import { Inbox } from './protocol/inbox.js';
import { checkFixed, parametersOf, portOf } from './protocol/request.js';
import { abortable, onAbort, throwIfAborted } from './channels/abort.js';
import { Providers } from './providers.js';

const fixed = ['mode', 'port', 'address', 'protocol'];

/**
 * Made by `node.subscribe`. An async iterable of messages `{payload, life, sequence, missed, provider}`. Events: `provider` with
 * `{change: 'added' | 'modified' | 'removed', reason, life, ...}`; `problem` with an Error.
 */
export class Subscriber extends EventEmitter {
  #session;
  #io;
  #problem;
  #onClosed;
  #providers;
  #conversions;
  #inbox;
  #request;
  #taken;
  #mode;
  #waiting = [];
  #failure;
  #closing;
  #offAbort;
  #statistics = { received: 0, missed: 0, dropped: 0, overflowed: 0 };

  /** Throws StatementError and PortError. */
  constructor(context, { signal, queue = limits.queueLength, conversions, ...options }) {
    const { session, io, onProblem, onOpened, onClosed } = context;
    super();
    throwIfAborted(signal);
    if (!Number.isInteger(queue) || queue < 1) throw new TypeError('queue is a number of messages, at least 1');
    this.#session = session;
    this.#io = io;
    this.#onClosed = onClosed;
    this.life = newLife();
    this.#problem = (error) => onProblem(this, error);
    this.#inbox = new Inbox(queue, limits.maxQueuedOctets);
    this.#conversions = new Converter(conversions);
    this.#mode = options.mode;
    this.#providers = new Providers(context, { life: this.life, conversions: this.#conversions, statistics: this.#statistics }, {
      hasRoom: () => this.#inbox.hasRoom,
      onMessage: (channel, frame, missed, isDatagram) => this.#onMessage(channel, frame, missed, isDatagram),
      onProvider: (change) => this.emit('provider', change),
      onProblem: (text) => this.#problem(new GemingaError(text, 'GEMINGA_CHANNEL')),
      onFailed: (error) => this.#fail(error),
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
    return this.#providers.port;
  }

  get providers() {
    return this.#providers.described;
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
    this.#providers.onDaemonLost();
  }

  onDaemonBack() {
    this.#providers.onDaemonBack();
  }

  onSealing() {
    this.#providers.onSealing();
  }

  #setLimit({ limit }) {
    this.#providers.limit = limit === undefined ? (this.#mode === 'oto' ? 1 : 0) : Number(limit);
  }

  #open({ port, ...options }) {
    const words = options.protocol ?? 'udp,tcp';
    const protocols = Array.isArray(words) ? words : String(words).split(',');
    if (!protocols.every((word) => word === 'udp' || word === 'tcp')) {
      throw new StatementError(`protocol=${words}: channels are udp and tcp`);
    }
    const parameters = parametersOf({ ...options, protocol: protocols }, 'sub');
    if (protocols.includes('udp')) {
      this.#providers.listen(portOf(port));
      parameters.push(['port', String(this.#providers.port)]);
    } else if (port) {
      parameters.push(['port', String(port)]);
    }
    parameters.push(['channel', lifeText(this.life)]);
    try {
      const { request, taken } = this.#session.create('sub', parameters, {
        onEvent: (event) => this.#providers.onEvent(event),
        onProblem: (error) => this.#onProblem(error),
        onKeys: (life, keys, error) => this.#providers.onKeys(life, keys, error),
      });
      this.#request = request;
      this.#taken = taken;
      taken.catch((error) => this.#fail(error));
    } catch (error) {
      this.#providers.close();
      throw error;
    }
  }

  async #close() {
    this.#offAbort?.();
    this.#providers.close();
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

  #onMessage({ life, provider }, { payload, sequence }, missed, isDatagram) {
    const message = { payload, life, sequence, missed, provider };
    if (isDatagram) {
      const lost = this.#inbox.putDatagram(message);
      this.#statistics.overflowed += lost;
      this.#statistics.missed += lost;
    } else {
      this.#inbox.putStreamed(message);
    }
    if (this.#waiting.length > 0) this.#waiting.shift().resolve(this.#take());
  }

  #onProblem(error) {
    this.#problem(error);
    if (this.#request.isRefused) this.#providers.removeAll('refused');
  }

  #take() {
    const message = this.#inbox.take();
    if (!message) return undefined;
    ++this.#statistics.received;
    if (this.#inbox.isHalfEmpty) this.#providers.resume();
    return { ...message, missed: Number(message.missed) };
  }
}
