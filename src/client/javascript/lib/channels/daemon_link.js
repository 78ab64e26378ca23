// The link to the daemon, which connects again whenever the connection is lost.
import { connect } from 'node:net';

import { Backoff } from '../protocol/backoff.js';
import { LineReader } from '../protocol/line_reader.js';
import { answerPatience, awayPatience } from '../protocol/limits.js';
import { endpointText } from './endpoint.js';

const noAnswer = 'no answer';

/** Hooks: `onUp()`, `onLine(octets)`, `onDown()` after `onUp()`, and `log(line)`. */
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
  /** Why the daemon was not reached last. */
  #failure = noAnswer;
  #away;
  #isAwayTold = false;
  #answer;

  constructor(io, endpoints, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#endpoints = endpoints;
    this.#hooks = hooks;
    this.#backoff = new Backoff(io.random);
  }

  open() {
    this.#awaitDaemon();
    this.#try(0);
  }

  /** The daemon has answered the hello: the next loss begins with the shortest wait. */
  settle() {
    this.#backoff.reset();
    this.#timers.clear(this.#answer);
    this.#timers.clear(this.#away);
    if (this.#isAwayTold) this.#hooks.log(`the daemon at ${endpointText(this.#endpoints[0])} answers`);
    this.#isAwayTold = false;
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

  /** Says after a second that no daemon is there. */
  #awaitDaemon() {
    this.#timers.clear(this.#away);
    if (this.#isAwayTold) return;
    this.#away = this.#timers.after(awayPatience, () => {
      this.#isAwayTold = true;
      this.#hooks.log(`no daemon at ${endpointText(this.#endpoints[0])} for ${awayPatience / 1000} s (${this.#failure}): ` +
          'start gemingad, or say where it is with GEMINGA_CONNECT');
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
    socket.on('error', (error) => {
      this.#failure = error.code ?? error.message;
    });
    // Neither a host that takes no connection nor a daemon that does not answer is waited for any longer.
    this.#timers.clear(this.#answer);
    this.#answer = this.#timers.after(answerPatience, () => socket.destroy());
    socket.once('connect', () => {
      this.#isUp = true;
      this.#failure = noAnswer;
      this.#lines = new LineReader();
      this.#hooks.onUp();
    });
    socket.on('data', (octets) => this.#read(socket, octets));
    socket.once('close', () => {
      this.#timers.clear(this.#answer);
      if (!this.#isUp) {
        this.#try(at + 1);
        return;
      }
      this.#isUp = false;
      this.#hooks.onDown();
      if (this.#isClosed) return;
      this.#awaitDaemon();
      this.#timers.after(this.#backoff.next(), () => this.#try(0));
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
