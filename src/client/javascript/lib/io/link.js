// The connection to the daemon: tries until there is one, and again when it is lost.
import { connect } from 'node:net';

import { Backoff } from '../core/backoff.js';
import { maxLine } from '../core/limits.js';

/** Hooks: `onUp()`, `onLine(octets)`, `onDown()`; the last only after the first. */
export class Link {
  #io;
  #timers;
  #endpoints;
  #hooks;
  #backoff;
  #socket;
  #isUp = false;
  #isClosed = false;
  #rest = [];
  #restLength = 0;

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

  /** The daemon has answered: the next loss is a new one. */
  settle() {
    this.#backoff.reset();
  }

  write(line) {
    if (this.#isUp) this.#socket.write(`${line}\r\n`);
  }

  /** Writes what waits and closes; the promise is fulfilled when the connection is gone. */
  close() {
    this.#isClosed = true;
    this.#io.forget(this.#timers);
    const socket = this.#socket;
    if (!socket || socket.destroyed) return Promise.resolve();
    if (!this.#isUp) socket.destroy();
    return new Promise((resolve) => {
      socket.once('close', resolve);
      socket.end();
      // The daemon closes after `sys bye`; one that hangs is not waited for.
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
      this.#rest = [];
      this.#restLength = 0;
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
    let begin = 0;
    for (let end = octets.indexOf(10); end >= 0 && !socket.destroyed; end = octets.indexOf(10, begin)) {
      let line = octets.subarray(begin, end);
      begin = end + 1;
      if (this.#restLength > 0) {
        line = Buffer.concat([...this.#rest, line]);
        this.#rest = [];
        this.#restLength = 0;
      }
      if (line.at(-1) === 13) line = line.subarray(0, -1);
      this.#hooks.onLine(line);
    }
    if (begin === octets.length) return;
    this.#rest.push(octets.subarray(begin));
    this.#restLength += octets.length - begin;
    // What says so long a line is no daemon.
    if (this.#restLength > maxLine + 1) socket.destroy();
  }
}
