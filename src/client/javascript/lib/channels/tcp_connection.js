// The connection of one consumer, with the frames that wait to be written.
import { SendQueue } from '../protocol/send_queue.js';
import * as limits from '../protocol/limits.js';

/** Octets that the system is given at once, so that it shows whether a consumer takes anything. */
const portion = 64 * 1024;
const none = Buffer.alloc(0);

export class TcpConnection {
  #clock;
  #socket;
  #queue;
  /** Octets that the system has been given and has not taken. */
  #sending = 0;
  #isFinishing = false;
  #waiters = [];
  /** The time when the other side took something last, or something began to wait. It counts only while something waits. */
  tookAt = 0;

  /** The memory of the frames that wait counts in `pool`, which is that of all consumers of a publisher. */
  constructor(clock, socket, pool) {
    this.#clock = clock;
    this.#socket = socket;
    this.#queue = new SendQueue(pool);
    socket.once('close', () => {
      this.#queue.clear();
      this.#wake();
    });
  }

  get socket() {
    return this.#socket;
  }

  /** Octets that wait. */
  get waiting() {
    return this.#queue.octets;
  }

  /** Whether it is better to wait until it is drained. */
  get isEnough() {
    return this.#queue.isEnough;
  }

  /** Sends a frame, or keeps it until there is room. False if it was left out, because too much waits. */
  send(frame) {
    if (!this.#queue.hasRoomFor(frame.length)) return false;
    this.append(frame);
    return true;
  }

  /** Sends a frame behind those that wait, however many these are. */
  append(frame) {
    if (this.#socket.destroyed) return;
    if (!this.#queue.isEmpty) {
      this.#queue.put(frame);
      return;
    }
    if (frame.length <= portion) {
      this.#socket.write(frame);
      if (this.#socket.writableLength === 0) return; // as nearly always
      this.#queue.put(frame);
      this.#await(frame.length);
    } else {
      this.#queue.put(frame);
      this.#pump();
    }
    this.tookAt = this.#clock.now();
  }

  /** Fulfilled when the system has taken everything that waits, or the connection is gone. */
  async drained() {
    if (!this.#queue.isEmpty) await new Promise((resolve) => this.#waiters.push(resolve));
  }

  /** Writes what waits and ends the connection; fulfilled when it is gone. A consumer that takes nothing is not waited for. */
  finish() {
    this.#isFinishing = true;
    const socket = this.#socket;
    return new Promise((resolve) => {
      // The time-out of a socket counts from the last octet that the other side took.
      socket.setTimeout(limits.closePatience, () => socket.destroy());
      socket.once('close', resolve);
      if (socket.destroyed) resolve();
      if (this.#queue.isEmpty) socket.end();
      socket.resume();
    });
  }

  /** Ends the connection with a last frame in the place of those that wait. */
  dismiss(frame) {
    this.#queue.dismiss(this.#sending);
    this.append(frame);
    return this.finish();
  }

  /** Closes at once, and forgets what waits. */
  close() {
    this.#queue.clear();
    this.#socket.destroy();
  }

  /** Gives the system what it takes now. */
  #pump() {
    while (!this.#queue.isEmpty && this.#sending === 0 && !this.#socket.destroyed) {
      const octets = this.#queue.next(portion);
      this.#socket.write(octets);
      if (this.#socket.writableLength > 0) this.#await(octets.length);
      else this.#queue.took(octets.length);
    }
    if (!this.#queue.isEmpty) return;
    if (this.#isFinishing) this.#socket.end();
    this.#wake();
  }

  /** Goes on when the system has taken these octets. */
  #await(octets) {
    this.#sending = octets;
    this.#socket.write(none, (error) => {
      if (error || this.#socket.destroyed) return;
      this.#sending = 0;
      this.#queue.took(octets);
      this.tookAt = this.#clock.now();
      this.#pump();
    });
  }

  #wake() {
    for (const resolve of this.#waiters.splice(0)) resolve();
  }
}
