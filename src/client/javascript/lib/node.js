// A node: the publishers and subscribers of one program, which go on while its daemon is restarted.
import { EventEmitter } from 'node:events';

import { ClosedError } from './protocol/errors.js';
import { Session } from './protocol/session.js';
import { abortable, throwIfAborted } from './channels/abort.js';
import { endpointsOf } from './channels/endpoint.js';
import { Io } from './channels/io.js';
import { DaemonLink } from './channels/daemon_link.js';
import { Publisher } from './publisher.js';
import { Subscriber } from './subscriber.js';

/** Events: `connected` with the daemon's answer to the hello, `disconnected`, `problem` with an Error. */
export class Node extends EventEmitter {
  #io;
  #link;
  #session;
  #services = new Set();
  #hello;
  #closing;
  #gone = new AbortController();

  /**
   * `name`: the name that the team sees; `daemon`: the endpoint of the daemon, else that of GEMINGA_CONNECT, else
   * 127.0.0.1:4717 and [::1]:4717.
   */
  constructor({ name, daemon, clock, random } = {}) {
    super();
    this.#io = new Io({ clock, random });
    this.#session = new Session(name, {
      write: (line) => this.#link.write(line),
      onConnected: (hello) => this.#onConnected(hello),
      onProblem: (error) => this.emit('problem', error),
    });
    this.#link = new DaemonLink(this.#io, endpointsOf(daemon), {
      onUp: () => this.#session.start(),
      onLine: (octets) => this.#session.receive(octets),
      onDown: () => this.#onDown(),
    });
    this.#link.open();
  }

  /** Whether the daemon is there now. */
  get isConnected() {
    return this.#hello !== undefined;
  }

  /** The daemon's answer to the hello: `participant`, `peer`, `participant_name`, ... */
  get hello() {
    return this.#hello;
  }

  /** Fulfilled when the daemon is there. */
  async connected({ signal } = {}) {
    throwIfAborted(signal);
    if (this.#closing) throw new ClosedError('node');
    if (this.#hello) return this;
    let settle;
    const come = new Promise((resolve, reject) => {
      settle = { resolve, reject };
      this.once('connected', resolve);
      this.#gone.signal.addEventListener('abort', () => reject(new ClosedError('node')), { once: true });
    });
    try {
      await abortable(come, signal);
    } finally {
      this.off('connected', settle.resolve);
    }
    return this;
  }

  /** Offers a service with a channel. Fulfilled when the daemon has accepted it. */
  async publish(options) {
    return Publisher.open(this.#context(), options);
  }

  /** Asks for services and receives from them. `ready()` of the subscriber tells whether the daemon has accepted it. */
  subscribe(options) {
    return new Subscriber(this.#context(), options);
  }

  /** Withdraws everything, cleanly, and ends the connection. */
  close() {
    this.#closing ??= this.#close();
    return this.#closing;
  }

  /** Lets the program end although the node is open; `ref` takes that back. */
  unref() {
    this.#io.keepAlive(false);
    return this;
  }

  ref() {
    this.#io.keepAlive(true);
    return this;
  }

  #context() {
    if (this.#closing) throw new ClosedError('node');
    return {
      session: this.#session,
      io: this.#io,
      onOpened: (service) => this.#services.add(service),
      onClosed: (service) => this.#services.delete(service),
    };
  }

  async #close() {
    this.#gone.abort();
    await Promise.all([...this.#services].map((service) => service.close()));
    this.#session.bye();
    await this.#link.close();
    this.emit('close');
  }

  #onConnected(hello) {
    if (this.#hello) return;
    this.#hello = hello;
    this.#link.settle();
    for (const service of this.#services) service.onDaemonBack();
    this.emit('connected', hello);
  }

  #onDown() {
    const wasThere = this.#hello !== undefined;
    this.#hello = undefined;
    this.#session.lose();
    for (const service of this.#services) service.onDaemonLost();
    if (wasThere && !this.#closing) this.emit('disconnected');
  }
}

if (Symbol.asyncDispose) {
  for (const one of [Node, Publisher, Subscriber]) {
    Object.defineProperty(one.prototype, Symbol.asyncDispose, { value: one.prototype.close });
  }
}

/**
 * A node that is connected to its daemon: waits for the daemon, or until the `signal` is aborted. `new Node()` does not wait.
 */
export async function connect({ signal, ...options } = {}) {
  throwIfAborted(signal);
  const node = new Node(options);
  try {
    return await node.connected({ signal });
  } catch (error) {
    await node.close();
    throw error;
  }
}
