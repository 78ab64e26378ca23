// Parts that several tests share: a clock that stands still, a scripted daemon, and waits for conditions.
import { once } from 'node:events';
import { createServer } from 'node:net';
import { createInterface } from 'node:readline';

export const lib = new URL('../../../src/client/javascript/lib/', import.meta.url);
export const root = new URL('../../../', import.meta.url);

/** Time that goes on only when it is told to. */
export class ManualClock {
  #now = 0;
  #timers = [];

  now = () => this.#now;

  after = (milliseconds, callback) => {
    const timer = { due: this.#now + milliseconds, callback, ref() {}, unref() {} };
    this.#timers.push(timer);
    return timer;
  };

  clear = (timer) => {
    this.#timers = this.#timers.filter((one) => one !== timer);
  };

  /** Milliseconds until the next timer, or undefined. */
  get next() {
    return this.#timers.length === 0 ? undefined : Math.min(...this.#timers.map(({ due }) => due)) - this.#now;
  }

  /** Milliseconds until each timer. */
  get waits() {
    return this.#timers.map(({ due }) => due - this.#now);
  }

  get running() {
    return this.#timers.length;
  }

  advance(milliseconds) {
    const end = this.#now + milliseconds;
    for (;;) {
      const [timer] = this.#timers.filter(({ due }) => due <= end).sort((a, b) => a.due - b.due);
      if (!timer) break;
      this.clear(timer);
      this.#now = Math.max(this.#now, timer.due);
      timer.callback();
    }
    this.#now = end;
  }
}

/**
 * A scripted daemon: it listens on a free port, answers hello and ping, keeps the other lines in `lines`, and says what the
 * test tells it to. `answers` maps the beginning of a line to its answer, a function of the words of the line.
 */
export class ScriptedDaemon {
  lines = [];
  answers = new Map();
  #server;
  #sockets = new Set();
  #waiting = [];

  /** With `sealing` it says that it has keys and is in this mode. */
  constructor(sealing) {
    this.sealing = sealing;
  }

  async listen(port = 0) {
    this.#server = createServer((socket) => this.#serve(socket)).listen(port, '127.0.0.1');
    await once(this.#server, 'listening');
    this.port = this.#server.address().port;
    return this;
  }

  get endpoint() {
    return `127.0.0.1:${this.port}`;
  }

  say(line) {
    for (const socket of this.#sockets) socket.write(`${line}\r\n`);
  }

  write(octets) {
    for (const socket of this.#sockets) socket.write(octets);
  }

  /** The first line that matches, of those that have come or will come; it is taken out. */
  async line(pattern) {
    const at = this.lines.findIndex((line) => pattern.test(line));
    if (at >= 0) return this.lines.splice(at, 1)[0];
    return new Promise((resolve) => this.#waiting.push({ pattern, resolve }));
  }

  /** As `kill -9` of the daemon does. */
  async kill() {
    const closed = new Promise((resolve) => this.#server.close(resolve));
    for (const socket of this.#sockets) socket.resetAndDestroy();
    await closed;
  }

  #serve(socket) {
    this.#sockets.add(socket);
    socket.on('error', () => {});
    socket.once('close', () => this.#sockets.delete(socket));
    createInterface({ input: socket }).on('line', (line) => this.#hear(socket, line));
  }

  #hear(socket, line) {
    const [, answer] = [...this.answers].find(([beginning]) => line.startsWith(beginning)) ?? [];
    const words = line.split(' ');
    if (answer) socket.write(answer(words).map((one) => `${one}\r\n`).join(''));
    if (line.startsWith('0 sys ping')) socket.write('0 msg pong\r\n');
    else if (line.startsWith('0 sys hello')) socket.write(`0 msg hello version=1 participant=0000000a peer=1 name=x participant_name=here${this.sealing ? ` keys=yes sealing=${this.sealing}` : ''}\r\n`);
    else if (line.startsWith('0 sys bye')) socket.end();
    const at = this.#waiting.findIndex(({ pattern }) => pattern.test(line));
    if (at >= 0) this.#waiting.splice(at, 1)[0].resolve(line);
    else this.lines.push(line);
  }
}

/** The value of `key=` in a line. */
export const valueOf = (line, key) => new RegExp(` ${key}=([^ ]*)`).exec(line)?.[1];

/** The next event of an emitter that the condition holds for. */
export function event(emitter, name, condition = () => true) {
  return new Promise((resolve) => {
    const listen = (value) => {
      if (!condition(value)) return;
      emitter.off(name, listen);
      resolve(value);
    };
    emitter.on(name, listen);
  });
}

/** Waits, turn by turn of the event loop, until the condition holds. */
export async function until(condition) {
  while (!condition()) await new Promise((resolve) => setImmediate(resolve));
}
