// A node: the publishers and subscribers of one program, which go on while its daemon is restarted.
import { EventEmitter } from 'node:events';

import { takesPlainIn } from './protocol/channel_keys.js';
import { ClosedError, StatementError } from './protocol/errors.js';
import { maxName } from './protocol/limits.js';
import { sealingOf, Session } from './protocol/session.js';
import { abortable, throwIfAborted } from './channels/abort.js';
import { endpointsOf } from './channels/endpoint.js';
import { Io } from './channels/io.js';
import { DaemonLink } from './channels/daemon_link.js';
import { logHook } from './log.js';
import { Publisher } from './publisher.js';
import { Subscriber } from './subscriber.js';

function checkName(name) {
  if (name === undefined) return;
  if (typeof name !== 'string') throw new TypeError('name is a text');
  if (name === '') throw new StatementError('name is empty: leave it out, or say what the node is called');
  if (Buffer.byteLength(name) > maxName) throw new StatementError(`name is too long: at most ${maxName} octets`, 413);
}

/** Events: `connected` with the daemon's answer to the hello, `disconnected`, `problem` with an Error. */
export class Node extends EventEmitter {
  #io;
  #link;
  #session;
  #services = new Set();
  #hello;
  #log;
  /** Problems that were said since no daemon is there. */
  #saidAway = new Set();
  /** How this host seals. `hasKeys` is undefined until a daemon has said so. */
  #sealing = { hasKeys: undefined, takesPlain: false };
  #closing;
  #gone = new AbortController();

  /**
   * `name`: the name that the team sees; `daemon`: the endpoint of the daemon, else that of GEMINGA_CONNECT, else
   * 127.0.0.1:4717 and [::1]:4717; `log`: the function that takes a line for each cause that a person should know of, else lines
   * go to standard error. Throws StatementError and TypeError.
   */
  constructor({ name, daemon, log, clock, random, ...others } = {}) {
    super();
    for (const key of Object.keys(others)) throw new StatementError(`${key} is no option: there are name, daemon, log`);
    checkName(name);
    this.#log = logHook(log);
    this.#io = new Io({ clock, random });
    this.#session = new Session(name, {
      write: (line) => this.#link.write(line),
      onConnected: (hello) => this.#onConnected(hello),
      onSealing: (mode) => this.#onSealing(mode),
      onProblem: (error) => this.#onProblem(this, error),
      log: (line) => this.#log(line),
    });
    this.#link = new DaemonLink(this.#io, endpointsOf(daemon), {
      onUp: () => this.#session.start(),
      onLine: (octets) => this.#session.receive(octets),
      onDown: () => this.#onDown(),
      log: (line) => this.#log(line),
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
  async publish(options = {}) {
    return Publisher.open(this.#context(), options);
  }

  /** Asks for services and receives from them. `ready()` of the subscriber tells whether the daemon has accepted it. */
  subscribe(options = {}) {
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
      sealing: this.#sealing,
      onProblem: (service, error) => this.#onProblem(service, error),
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
    this.#saidAway.clear();
    this.#link.settle();
    const mode = sealingOf(hello);
    this.#sealing.hasKeys = mode !== 'plain';
    for (const service of this.#services) service.onDaemonBack();
    this.#onSealing(mode);
    this.emit('connected', hello);
  }

  /** The daemon has said how this host seals. That counts for channels that have no line of keys. */
  #onSealing(mode) {
    Object.assign(this.#sealing, { hasKeys: mode !== 'plain', takesPlain: takesPlainIn(mode) });
    for (const service of this.#services) service.onSealing();
  }

  /** Tells the application of a problem of the node, or of a publisher or subscriber. */
  #onProblem(owner, error) {
    // A request that the daemon refuses each time is one cause.
    if (this.#hello || !this.#saidAway.has(error.message)) this.#log(error.message);
    if (!this.#hello) this.#saidAway.add(error.message);
    owner.emit('problem', error);
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
