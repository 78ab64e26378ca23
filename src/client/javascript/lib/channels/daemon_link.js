// The link to the daemon, which connects again whenever the connection is lost.
import { connect } from 'node:net';

import { Backoff } from '../protocol/backoff.js';
import { LineReader } from '../protocol/line_reader.js';

/** Hooks: `onUp()`, `onLine(octets)`, and `onDown()` after `onUp()`. */
export class DaemonLink {
  #io;
  #timers;
  #endpoints;
  #hooks;
  #backoff;
  #socket;
  #isUp = false;
  #isClosed = false;
  #lines;

  constructor(io, endpoints, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#endpoints = endpoints;
    this.#hooks = hooks;
    this.#backoff = new Backoff(io.random);
  }

  open() {
    this.#try(0);
  }

  /** The daemon has answered the hello: the next loss begins with the shortest wait. */
  settle() {
    this.#backoff.reset();
  }

  write(line) {
    if (this.#isUp) this.#socket.write(`${line}\r\n`);
  }

  /** Writes what waits and closes. The promise is fulfilled when the connection is gone. */
  close() {
    this.#isClosed = true;
    this.#io.forget(this.#timers);
    const socket = this.#socket;
    if (!socket || socket.destroyed) return Promise.resolve();
    if (!this.#isUp) socket.destroy();
    return new Promise((resolve) => {
      socket.once('close', resolve);
      socket.end();
      // The daemon closes after `sys bye`. One that hangs is not waited for.
      const patience = this.#io.clock.after(1000, () => socket.destroy());
      socket.once('close', () => this.#io.clock.clear(patience));
    });
  }

  #try(at) {
    if (this.#isClosed) return;
    if (at === this.#endpoints.length) {
      this.#timers.after(this.#backoff.next(), () => this.#try(0));
      return;
    }
    const socket = this.#io.add(connect({ ...this.#endpoints[at], noDelay: true }));
    this.#socket = socket;
    socket.on('error', () => {});
    socket.once('connect', () => {
      this.#isUp = true;
      this.#lines = new LineReader();
      this.#hooks.onUp();
    });
    socket.on('data', (octets) => this.#read(socket, octets));
    socket.once('close', () => {
      if (!this.#isUp) {
        this.#try(at + 1);
        return;
      }
      this.#isUp = false;
      this.#hooks.onDown();
      if (!this.#isClosed) this.#timers.after(this.#backoff.next(), () => this.#try(0));
    });
  }

  #read(socket, octets) {
    for (const line of this.#lines.feed(octets)) {
      if (socket.destroyed) return;
      this.#hooks.onLine(line);
    }
    if (this.#lines.isBroken) socket.destroy();
  }
}
