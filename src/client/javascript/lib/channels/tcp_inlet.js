// The inlet from one provider over TCP: it connects, says hello, reads frames, and connects again when the connection is lost.
import { connect } from 'node:net';

import { Backoff } from '../protocol/backoff.js';
import { FrameReader } from '../protocol/frame_reader.js';
import { encodeFrame, kinds } from '../protocol/frame.js';
import { maxStreamMessage } from '../protocol/limits.js';

/**
 * Hooks: `hasRoom()`; `onMessage(frame)`; `onEnd(frame)`, the provider has ended; `onLost()`, the connection is gone, which
 * gives false if it is not to be made again; `onDropped()`; `onOctets()`, octets have come.
 */
export class TcpInlet {
  #io;
  #timers;
  #hello;
  #life;
  #place;
  #hooks;
  #backoff;
  #socket;
  #decoder;
  #isClosed = false;
  #isHeld = false;
  #isGone = false;

  constructor(io, { ownLife, life, address, port }, hooks) {
    this.#io = io;
    this.#timers = io.timers();
    this.#hello = encodeFrame(kinds.hello, ownLife, 0n);
    this.#life = life;
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

  /** There is room again. */
  resume() {
    if (!this.#isHeld) return;
    this.#isHeld = false;
    this.#decode(this.#socket, this.#decoder);
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
    const decoder = new FrameReader(maxStreamMessage);
    this.#socket = socket;
    this.#decoder = decoder;
    this.#isHeld = false;
    this.#isGone = false;
    socket.on('error', () => {});
    socket.once('connect', () => socket.write(this.#hello));
    socket.on('data', (octets) => {
      if (!this.#isClosed) this.#hooks.onOctets();
      decoder.push(octets);
      this.#decode(socket, decoder);
    });
    socket.once('close', () => this.#onClose(socket));
  }

  #decode(socket, decoder) {
    while (!this.#isClosed && socket === this.#socket) {
      if (!this.#hooks.hasRoom()) {
        this.#isHeld = true;
        socket.pause();
        return;
      }
      const frame = decoder.next();
      if (!frame) break;
      this.#backoff.reset();
      if (frame.life !== this.#life || frame.kind === kinds.hello) {
        this.#hooks.onDropped();
      } else if (frame.kind === kinds.message) {
        this.#hooks.onMessage(frame);
      } else {
        this.close();
        this.#hooks.onEnd(frame);
      }
    }
    if (decoder.isBroken) {
      this.#hooks.onDropped();
      socket.destroy();
    }
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
