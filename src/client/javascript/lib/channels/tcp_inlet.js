// The inlet from one provider over TCP: it connects, says hello, reads frames, and connects again when the connection is lost.
import { connect } from 'node:net';

import { Backoff } from '../protocol/backoff.js';
import { outcomes } from '../protocol/belief.js';
import { FrameReader } from '../protocol/frame_reader.js';
import { kinds } from '../protocol/frame.js';
import { maxStreamMessage } from '../protocol/limits.js';

/**
 * Hooks: `hasRoom()`; `onMessage(frame)`; `onEnd(frame)`, the provider has ended; `onUp()`, the connection is open; `onLost()`,
 * it is gone or was not made, which gives false if it is not to be made again; `onDropped()`; `onOctets()`, octets have come;
 * `onFull()`, the provider has no place; `onFailed(error)`, no frame can be sent any more.
 */
export class TcpInlet {
  #io;
  #timers;
  #frames;
  #channel;
  #place;
  #hooks;
  #backoff;
  #socket;
  #reader;
  #isClosed = false;
  #isHeld = false;
  #isGone = false;

  /** `frames` are those of a consumer. A channel has a `life` and a `belief`. */
  constructor(io, frames, channel, { address, port }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#frames = frames;
    this.#channel = channel;
    this.#place = { host: address, port };
    this.#hooks = hooks;
    this.#backoff = new Backoff(io.random);
    this.#connect();
  }

  get isConnected() {
    return this.#socket?.readyState === 'open' || this.#socket?.readyState === 'readOnly';
  }

  /** Whether it has stopped reading until there is room. */
  get isHeld() {
    return this.#isHeld;
  }

  /** The provider has another address. A connection that is open is kept. */
  move(address, port) {
    if (this.#place.host === address && this.#place.port === port) return;
    this.#place = { host: address, port };
    if (this.isConnected || this.#isClosed) return;
    this.#timers.clearAll();
    this.#backoff.reset();
    this.#socket?.destroy();
    this.#connect();
  }

  /** Other keys are in force, or another mode. A connection that says nothing that is believed is made again. */
  rekey() {
    const { belief } = this.#channel;
    if (!belief.keys.takesPlain && belief.floor === undefined) this.#socket.destroy();
  }

  /** There is room again. */
  resume() {
    if (!this.#isHeld) return;
    this.#isHeld = false;
    this.#decode(this.#socket, this.#reader);
    if (this.#isHeld) return;
    if (this.#isGone) this.#onClose(this.#socket);
    else this.#socket.resume();
  }

  close() {
    this.#isClosed = true;
    this.#io.forget(this.#timers);
    this.#socket?.destroy();
  }

  #connect() {
    const socket = this.#io.add(connect({ ...this.#place, noDelay: true }));
    const reader = new FrameReader(maxStreamMessage);
    this.#socket = socket;
    this.#reader = reader;
    this.#isHeld = false;
    this.#isGone = false;
    socket.on('error', () => {});
    socket.once('connect', () => {
      if (socket !== this.#socket) return;
      this.#channel.belief.greet();
      this.#hello(socket);
      this.#hooks.onUp();
    });
    socket.on('data', (octets) => {
      if (!this.#isClosed) this.#hooks.onOctets();
      reader.push(octets);
      this.#decode(socket, reader);
    });
    socket.once('close', () => this.#onClose(socket));
  }

  #hello(socket) {
    const { belief } = this.#channel;
    try {
      if (belief.keys) socket.write(this.#frames.write(belief.keys, kinds.hello, belief.hello()));
    } catch (error) {
      this.#hooks.onFailed(error);
    }
  }

  #decode(socket, reader) {
    while (!this.#isClosed && socket === this.#socket && reader === this.#reader) {
      if (!this.#hooks.hasRoom()) {
        this.#isHeld = true;
        socket.pause();
        return;
      }
      const frame = reader.next();
      if (!frame) break;
      this.#take(socket, frame);
    }
    if (reader.isBroken) {
      this.#hooks.onDropped();
      socket.destroy();
    }
  }

  #take(socket, read) {
    if (read.life !== this.#channel.life || read.kind === kinds.hello) {
      this.#hooks.onDropped();
      return;
    }
    const { belief } = this.#channel;
    const frame = belief.take(read);
    if (!frame && belief.isAhead(read)) {
      this.#hooks.onDropped(); // its key may be told later
    } else if (!frame) {
      this.#break(socket); // nothing behind it can be believed
    } else if (frame.kind === kinds.floor || frame.kind === kinds.full) {
      const outcome = belief.answered(frame);
      if (outcome === outcomes.forged) this.#hooks.onDropped();
      else if (outcome === outcomes.full) this.#hooks.onFull();
      else if (outcome === outcomes.again) this.#hello(socket);
    } else {
      this.#hear(socket, frame);
    }
  }

  #hear(socket, frame) {
    const isHeard = this.#channel.belief.isBehindFloor(frame);
    if (isHeard === undefined) {
      this.#break(socket); // a floor comes before the messages of the next connection
    } else if (!isHeard) {
      this.#hooks.onDropped();
    } else {
      this.#backoff.reset();
      if (frame.kind === kinds.message) {
        this.#hooks.onMessage(frame);
        return;
      }
      this.close();
      this.#hooks.onEnd(frame);
    }
  }

  /** Ends this connection, of which nothing more is read; another one is made. */
  #break(socket) {
    this.#hooks.onDropped();
    this.#reader = new FrameReader(0);
    socket.removeAllListeners('data');
    socket.destroy();
  }

  #onClose(socket) {
    if (this.#isClosed || socket !== this.#socket) return;
    if (this.#isHeld) {
      this.#isGone = true; // frames that were read are delivered when there is room
      return;
    }
    if (this.#hooks.onLost() && !this.#isClosed) this.#timers.after(this.#backoff.next(), () => this.#connect());
  }
}
