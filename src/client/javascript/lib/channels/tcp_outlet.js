// The outlet over TCP, in all modes: it listens, and a connection becomes a consumer by its hello.
import { createServer } from 'node:net';

import { FrameReader } from '../protocol/frame_reader.js';
import { PortError } from '../protocol/errors.js';
import { kinds } from '../protocol/frame.js';
import { lifeText } from '../protocol/life.js';
import * as limits from '../protocol/limits.js';

/** The connection of one consumer. */
class Connection {
  constructor(socket) {
    this.socket = socket;
  }

  /** Sends a frame. False if it was left out, because too much waits. */
  send(octets) {
    const { socket } = this;
    const waiting = socket.writableLength;
    if (waiting > 0 && waiting + octets.length > limits.maxWaiting) return false;
    socket.write(octets);
    return true;
  }
}

export class TcpOutlet {
  #io;
  #timers;
  #options;
  #isStream;
  #hooks;
  #server;
  /** Connections that have not become consumers, the oldest first: socket to `{decoder, life, timer}`. */
  #strangers = new Map();
  #awaited = new Set();
  #consumers = new Map();
  port;
  leftOut = 0;
  /** Connections that were closed because they were no consumer's or sent something that is no frame. */
  dropped = 0;

  /** Hooks: `onCome(key)` and `onGone(key)`, for connections of consumers. */
  constructor(io, { address, port, isStream, hooks }) {
    this.#io = io;
    this.#timers = io.timers();
    this.#options = { host: address, port: port ?? 0 };
    this.#isStream = isStream;
    this.#hooks = hooks;
  }

  async open() {
    const { host, port } = this.#options;
    try {
      await this.#listen(host, port);
    } catch (error) {
      // An address that is not this host's is accepted, because the user knows how the host is reached.
      if (host === undefined || error.code === 'EADDRINUSE' || error.code === 'EACCES') throw new PortError(port, error);
      await this.#listen(undefined, port).catch((cause) => {
        throw new PortError(port, cause);
      });
    }
    this.port = this.#server.address().port;
  }

  get hasConsumer() {
    return this.#consumers.size > 0;
  }

  get waiting() {
    let most = 0;
    for (const { socket } of this.#consumers.values()) most = Math.max(most, socket.writableLength);
    return most;
  }

  isConnected(key) {
    return this.#consumers.has(key);
  }

  /** The daemon has named a consumer, whose connection may have come already. */
  set(key) {
    this.#awaited.add(key);
    for (const [socket, stranger] of this.#strangers) {
      if (stranger.life === key) this.#accept(socket, stranger);
    }
  }

  /** A consumer is gone. */
  delete(key) {
    this.#awaited.delete(key);
    const connection = this.#consumers.get(key);
    if (!connection) return;
    this.#consumers.delete(key);
    this.#end(connection.socket);
  }

  send(octets) {
    let isPrompt = true;
    for (const connection of this.#consumers.values()) {
      if (!connection.send(octets)) ++this.leftOut;
      if (connection.socket.writableLength >= limits.enoughWaiting) isPrompt = false;
    }
    return isPrompt;
  }

  /** Fulfilled when the system has taken everything that waits now, or the consumers are gone. */
  async drained() {
    await Promise.all([...this.#consumers.values()].map(({ socket }) =>
      socket.writableLength === 0 ? undefined : new Promise((resolve) => socket.write('', resolve))));
  }

  /** Writes the frames that wait and a last frame to each consumer, and closes. */
  async end(octets) {
    const server = this.#server;
    this.#server = undefined;
    for (const [socket, { timer }] of this.#strangers) {
      this.#timers.clear(timer);
      socket.destroy();
    }
    this.#strangers.clear();
    const consumers = [...this.#consumers.values()];
    this.#consumers.clear();
    const gone = consumers.map(({ socket }) => {
      socket.write(octets);
      return this.#end(socket);
    });
    const closed = server && new Promise((resolve) => server.close(resolve));
    await Promise.all([...gone, closed]);
    this.#io.forget(this.#timers);
  }

  #listen(host, port) {
    return new Promise((resolve, reject) => {
      const server = createServer({ noDelay: true }, (socket) => this.#onConnection(socket));
      server.once('error', reject);
      server.listen({ host, port, exclusive: true }, () => {
        server.off('error', reject);
        server.on('error', () => ++this.dropped); // no descriptors are left: consumers connect again
        this.#server = this.#io.add(server);
        resolve();
      });
    });
  }

  /** Writes what waits and ends a connection. A consumer that takes nothing is not waited for. */
  #end(socket) {
    return new Promise((resolve) => {
      // The time-out of a socket counts from the last octet that the other side took.
      socket.setTimeout(limits.closePatience, () => socket.destroy());
      socket.once('close', resolve);
      if (socket.destroyed) resolve();
      socket.end();
      socket.resume();
    });
  }

  #onConnection(socket) {
    this.#io.add(socket);
    socket.on('error', () => {});
    if (this.#strangers.size >= limits.maxStrangers) this.#reject(this.#strangers.keys().next().value);
    const timer = this.#timers.after(limits.strangerPatience, () => this.#reject(socket));
    const stranger = { decoder: new FrameReader(0), life: undefined, timer };
    this.#strangers.set(socket, stranger);
    socket.on('data', (octets) => this.#onData(socket, stranger, octets));
    socket.once('close', () => this.#onClose(socket, stranger));
  }

  #onData(socket, stranger, octets) {
    stranger.decoder.push(octets);
    for (let frame = stranger.decoder.next(); frame; frame = stranger.decoder.next()) {
      if (frame.kind !== kinds.hello || stranger.life !== undefined) {
        this.#reject(socket);
        return;
      }
      stranger.life = lifeText(frame.life);
      if (this.#isStream || this.#awaited.has(stranger.life)) this.#accept(socket, stranger);
    }
    if (stranger.decoder.isBroken) this.#reject(socket);
  }

  #accept(socket, stranger) {
    this.#timers.clear(stranger.timer);
    this.#strangers.delete(socket);
    const former = this.#consumers.get(stranger.life);
    if (former) {
      this.#consumers.delete(stranger.life);
      former.socket.destroy();
    }
    if (this.#consumers.size >= limits.maxConsumers) {
      ++this.dropped;
      socket.destroy();
      return;
    }
    this.#consumers.set(stranger.life, new Connection(socket));
    this.#hooks.onCome(stranger.life);
  }

  #reject(socket) {
    ++this.dropped;
    socket.destroy();
  }

  #onClose(socket, stranger) {
    this.#timers.clear(stranger.timer);
    this.#strangers.delete(socket);
    if (this.#consumers.get(stranger.life)?.socket !== socket) return;
    this.#consumers.delete(stranger.life);
    this.#hooks.onGone(stranger.life);
  }
}
