// A publisher's side over TCP, in all modes: listens; a connection becomes a consumer when its hello says whose it is.
import { createServer } from 'node:net';

import { FrameReader } from '../protocol/frame_reader.js';
import { PortError } from '../protocol/errors.js';
import { kinds } from '../protocol/frame.js';
import { lifeText } from '../protocol/life.js';
import * as limits from '../protocol/limits.js';

/** Writes frames to one consumer, as long as not too much waits for it. */
class Connection {
  constructor(socket) {
    this.socket = socket;
  }

  /** False where the frame was left out. */
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
  /** Of those that have not become consumers: socket to `{decoder, life, timer}`, the oldest first. */
  #strangers = new Map();
  #awaited = new Set();
  #consumers = new Map();
  port;
  leftOut = 0;
  /** TcpOutlet that were closed since they were no consumers or said what is no frame. */
  dropped = 0;

  /** `hooks`: `onCome(key)` and `onGone(key)` tell of the connections of consumers. */
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
      // An address that is not this host's is taken as said by somebody who knows how it is reached.
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

  /** The daemon told of a consumer: a connection that has said hello for it already is its. */
  set(key) {
    this.#awaited.add(key);
    for (const [socket, stranger] of this.#strangers) {
      if (stranger.life === key) this.#accept(socket, stranger);
    }
  }

  /** It is no consumer any more. */
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

  /** Fulfilled when the system has taken all that waits now, or its consumers are gone. */
  async drained() {
    await Promise.all([...this.#consumers.values()].map(({ socket }) =>
      socket.writableLength === 0 ? undefined : new Promise((resolve) => socket.write('', resolve))));
  }

  /** Writes what waits and a last frame to each consumer, and closes. */
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
        server.on('error', () => ++this.dropped); // no descriptors: whoever connects tries again
        this.#server = this.#io.add(server);
        resolve();
      });
    });
  }

  /** Sends what waits and ends a connection; who takes nothing of it is not waited for. */
  #end(socket) {
    return new Promise((resolve) => {
      // Node's own time-out of a socket: it counts from the last octet that the other side took.
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
