// The outlet over TCP, in all modes: it listens, and a connection becomes a consumer by its hello.
import { createServer } from 'node:net';

import { canonicalAddress } from '../protocol/address.js';
import { GemingaError, PortError } from '../protocol/errors.js';
import { FrameReader } from '../protocol/frame_reader.js';
import { kinds } from '../protocol/frame.js';
import { handshakeSize, readHandshake, writeHandshake } from '../protocol/handshake.js';
import { lifeText, newLife } from '../protocol/life.js';
import * as limits from '../protocol/limits.js';
import { Places } from '../protocol/places.js';
import { Pool } from '../protocol/send_queue.js';
import { counterOf } from './reception.js';
import { TcpConnection } from './tcp_connection.js';

/** One connection. It is a stranger until it has said hello and the daemon has named its consumer. */
class Client {
  reader = new FrameReader(handshakeSize);
  timer;
  /** A hello that came before the keys. */
  first;
  /** The consumer's, when its handshake is done; also as text. */
  life;
  key;
  challenge;
  /** The cookie of the connection, where the handshake has two hellos. */
  cookie = 0n;
  /** That of its last sealed frame, 0n if it says hello plainly. */
  counter = 0n;
  isLeftOut = false;
  /** The timer until it is asked for a sealed hello again, while it is. */
  asking;

  constructor(connection, address) {
    this.connection = connection;
    this.address = address;
  }
}

/**
 * Hooks: `onCome(key)` and `onGone(key, reason)` for connections of consumers; `onNoPlace(what, count)`, a newcomer found all
 * places taken; `onPlaces()`, enough are free again, which may be told again; `onProblem(error)`.
 */
export class TcpOutlet {
  #io;
  #frames;
  #timers;
  #options;
  #isStream;
  #hooks;
  #server;
  #pool = new Pool();
  #strangers = new Places(limits.maxStrangers);
  #places = new Places(limits.maxConsumers);
  #awaited = new Set();
  /** Strangers whose handshake is done, by their lives as text. */
  #ready = new Map();
  /** Consumers, by their lives as text. */
  #consumers = new Map();
  #leaving = new Set();
  port;
  leftOut = 0;
  /** Connections that were closed because they were no consumer's or sent something that is no frame. */
  dropped = 0;

  constructor(io, frames, { address, port, isStream, hooks }) {
    this.#io = io;
    this.#frames = frames;
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

  /** Octets that wait for the consumer for which most wait. */
  get waiting() {
    let most = 0;
    for (const { connection } of this.#consumers.values()) most = Math.max(most, connection.waiting);
    return most;
  }

  /** Whether anything waits. */
  get isBusy() {
    return this.#pool.octets > 0;
  }

  isConnected(key) {
    return this.#consumers.has(key);
  }

  /** The daemon has named a consumer, whose connection may have come already. */
  set(key) {
    this.#awaited.add(key);
    const client = this.#ready.get(key);
    if (client) this.#admit(client);
  }

  /** A consumer is gone. */
  delete(key) {
    this.#awaited.delete(key);
    const client = this.#consumers.get(key);
    if (!client) return;
    this.#consumers.delete(key);
    this.#leave(client);
  }

  /** Other keys are in force, or another mode. Consumers that said no sealed hello have some time for it where that is needed. */
  rekey(beginsToSeal) {
    if (!this.#frames.keys) return;
    for (const client of [...this.#consumers.values(), ...this.#ready.values()]) {
      if (!this.#frames.hasRing) client.counter = 0n; // nobody has keys any more
      if (!this.#frames.takesPlain && client.counter === 0n) this.#askSealed(client, limits.strangerPatience);
      else if (beginsToSeal && this.#consumers.get(client.key) === client) this.#answer(client, kinds.floor, 0n);
    }
    for (const client of [...this.#strangers]) {
      const { first } = client;
      client.first = undefined;
      if (first) this.#onFrame(client, first);
    }
  }

  send(octets) {
    let isPrompt = true;
    for (const client of this.#consumers.values()) {
      const { connection } = client;
      if (connection.send(octets)) {
        if (connection.waiting <= limits.maxWaiting / 2) client.isLeftOut = false;
      } else {
        ++this.leftOut;
        this.#tellLeftOut(client);
      }
      if (connection.isEnough) isPrompt = false;
    }
    if (this.#pool.octets > limits.maxWaitingForAll) this.#closeSlow();
    return isPrompt;
  }

  /** Fulfilled when the system has taken everything that waits now, or the consumers are gone. */
  async drained() {
    await Promise.all([...this.#consumers.values()].map(({ connection }) => connection.drained()));
  }

  /** Writes the frames that wait and the end to each consumer, and closes. */
  async end() {
    const server = this.#server;
    this.#server = undefined;
    for (const client of [...this.#strangers]) this.#dismiss(client);
    const consumers = [...this.#consumers.values()];
    this.#consumers.clear();
    const octets = consumers.length > 0 ? this.#frames.end() : undefined;
    const gone = consumers.map(({ connection }) => {
      if (octets) connection.append(octets);
      return connection.finish();
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

  #onConnection(socket) {
    const address = canonicalAddress(socket.remoteAddress) ?? '';
    this.#io.add(socket);
    socket.on('error', () => {});
    const client = new Client(new TcpConnection(this.#io.clock, socket, this.#pool), address);
    const { isTaken, loser } = this.#strangers.take(client, address);
    if (!isTaken) {
      ++this.dropped;
      socket.destroy();
      return;
    }
    if (loser) {
      ++this.dropped;
      this.#dismiss(loser);
    }
    client.timer = this.#timers.after(limits.strangerPatience, () => this.#refuse(client));
    socket.on('data', (octets) => this.#onData(client, octets));
    socket.once('close', () => this.#onClose(client));
  }

  #onData(client, octets) {
    const { reader, connection } = client;
    if (this.#leaving.has(client)) return;
    reader.push(octets);
    for (let frame = reader.next(); frame && !connection.socket.destroyed; frame = reader.next()) this.#onFrame(client, frame);
    if (reader.isBroken) this.#refuse(client);
  }

  #onFrame(client, read) {
    if (!this.#frames.keys) {
      if (client.first || read.kind !== kinds.hello) this.#refuse(client);
      else client.first = { ...read, payload: Buffer.from(read.payload), octets: read.octets && Buffer.from(read.octets) };
      return;
    }
    const frame = this.#frames.take(read);
    const said = frame && readHandshake(frame.payload);
    if (!frame && client.asking !== undefined) ++this.dropped; // it is asked again
    else if (frame?.kind !== kinds.hello || said?.life !== this.#frames.life || said.challenge === 0n) this.#refuse(client);
    else if (client.key === undefined) this.#onHello(client, frame, said);
    else this.#onSealedHello(client, frame, said);
  }

  /** A consumer that said a plain hello says another one, sealed, which is no recording if it has the cookie of this connection. */
  #onSealedHello(client, frame, said) {
    const isRight = said.cookie === client.cookie && said.challenge === client.challenge && frame.life === client.life;
    if (client.asking === undefined || !frame.isSealed || !isRight) {
      ++this.dropped; // a hello that is not needed
      return;
    }
    this.#timers.clear(client.asking);
    Object.assign(client, { asking: undefined, counter: frame.counter });
    if (this.#consumers.get(client.key) === client) this.#answer(client, kinds.floor, 0n);
  }

  /** Asks a consumer for a sealed hello, again and again until its time is over. */
  #askSealed(client, patience) {
    this.#timers.clear(client.asking);
    client.asking = undefined;
    if (this.#frames.takesPlain || !this.#frames.keys) return;
    if (patience <= 0) {
      client.connection.close();
      return;
    }
    client.cookie = newLife();
    this.#answer(client, kinds.floor, client.cookie);
    client.asking = this.#timers.after(limits.askInterval, () => this.#askSealed(client, patience - limits.askInterval));
  }

  #onHello(client, frame, said) {
    const counter = counterOf(frame);
    if (frame.isSealed || this.#frames.seals) {
      if (client.cookie === 0n) {
        Object.assign(client, { life: frame.life, challenge: said.challenge, counter, cookie: newLife() });
        this.#answer(client, kinds.floor, client.cookie);
        return;
      }
      const hasRisen = counter > client.counter || (counter === 0n && client.counter === 0n);
      if (said.cookie !== client.cookie || said.challenge !== client.challenge || frame.life !== client.life || !hasRisen) {
        this.#refuse(client);
        return;
      }
    }
    Object.assign(client, { life: frame.life, key: lifeText(frame.life), challenge: said.challenge, counter });
    if (this.#isStream || this.#awaited.has(client.key)) {
      this.#admit(client);
      return;
    }
    const other = this.#ready.get(client.key);
    if (other) this.#dismiss(other);
    this.#ready.set(client.key, client);
  }

  #admit(client) {
    const former = this.#consumers.get(client.key);
    if (former) {
      this.#places.leave(former);
      this.#consumers.delete(client.key);
      former.connection.close();
    }
    const { isTaken, loser } = this.#places.take(client, client.address);
    if (!isTaken || loser) this.#hooks.onNoPlace('consumers', limits.maxConsumers);
    this.#forgetStranger(client);
    if (!isTaken) {
      ++this.dropped;
      this.#answer(client, kinds.full, 0n);
      this.#leave(client);
      return;
    }
    if (loser) this.#lose(loser);
    this.#consumers.set(client.key, client);
    if (client.cookie !== 0n) this.#answer(client, kinds.floor, 0n);
    this.#hooks.onCome(client.key);
  }

  /** A consumer loses its place. */
  #lose(client) {
    this.#consumers.delete(client.key);
    this.#leaving.add(client);
    client.connection.dismiss(this.#frames.other(kinds.full, writeHandshake(client.life, client.challenge, 0n)));
    this.#hooks.onGone(client.key, 'lost');
  }

  /** Ends the connection of a consumer behind what waits. */
  #leave(client) {
    this.#places.leave(client);
    this.#leaving.add(client);
    client.connection.finish();
    if (this.#leaving.size > limits.maxConsumers) {
      const [eldest] = this.#leaving;
      this.#leaving.delete(eldest);
      eldest.connection.close();
    }
    this.#look();
  }

  #answer({ connection, life, challenge }, kind, cookie) {
    connection.append(this.#frames.other(kind, writeHandshake(life, challenge, cookie)));
  }

  /** A frame came that is no hello of a consumer. */
  #refuse(client) {
    ++this.dropped;
    client.connection.close();
  }

  /** Closes the connection of a stranger. */
  #dismiss(client) {
    this.#forgetStranger(client);
    client.connection.close();
  }

  #forgetStranger(client) {
    this.#timers.clear(client.timer);
    this.#strangers.leave(client);
    if (this.#ready.get(client.key) === client) this.#ready.delete(client.key);
  }

  #onClose(client) {
    this.#forgetStranger(client);
    this.#timers.clear(client.asking);
    this.#leaving.delete(client);
    this.#places.leave(client);
    if (this.#consumers.get(client.key) === client) {
      this.#consumers.delete(client.key);
      this.#hooks.onGone(client.key, 'lost');
    }
    this.#look();
  }

  #look() {
    if (this.#places.hasRoomAgain) this.#hooks.onPlaces();
  }

  #tellLeftOut(client) {
    if (client.isLeftOut) return;
    client.isLeftOut = true;
    const text = `the consumer ${client.key} is slow: messages to it are left out until it has taken some`;
    setImmediate(() => this.#hooks.onProblem(new GemingaError(text, 'GEMINGA_CHANNEL'))); // not within send()
  }

  /** Closes the consumers that have taken nothing for the longest time, until what waits is within its limit. */
  #closeSlow() {
    const slow = [...this.#consumers.values(), ...this.#leaving].filter(({ connection }) => connection.waiting > 0);
    slow.sort((a, b) => a.connection.tookAt - b.connection.tookAt);
    for (const client of slow) {
      if (this.#pool.octets <= limits.maxWaitingForAll) return;
      client.connection.close();
      if (this.#consumers.get(client.key) !== client) continue;
      this.#consumers.delete(client.key);
      setImmediate(() => this.#hooks.onGone(client.key, 'slow')); // not within send()
    }
  }
}
