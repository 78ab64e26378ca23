// Messages that wait until the application takes them (src/client/CHANNELS.md, "A full inbox").
import { maxRemembered } from './limits.js';

/**
 * Full at either limit, but one message always has room. A datagram that comes then takes the place of the eldest one; a
 * stream is to be read no more, which `hasRoom` says. The message behind one that was lost says so in `missed`.
 */
export class Inbox {
  #waiting = [];
  #head = 0;
  #octets = 0;
  #datagrams = 0;
  #maxMessages;
  #maxOctets;
  /** By life, how many messages were lost since the last one that was taken. */
  #lost = new Map();

  /** @param maxMessages how many may wait; @param maxOctets of their payloads */
  constructor(maxMessages, maxOctets) {
    this.#maxMessages = maxMessages;
    this.#maxOctets = maxOctets;
  }

  get size() {
    return this.#waiting.length - this.#head;
  }

  /** Whether there is room for one more. */
  get hasRoom() {
    return this.size < this.#maxMessages && this.#octets < this.#maxOctets;
  }

  /** Whether a stream that had to wait may go on: half of the room is free. */
  get isHalfEmpty() {
    return this.size <= this.#maxMessages / 2 && this.#octets <= this.#maxOctets / 2;
  }

  /** Keeps a message of a stream, which cannot be lost. */
  putStreamed(message) {
    this.#put(message, false);
  }

  /** Keeps a message that came in a datagram. Gives how many are lost for it: the eldest datagrams, or this one. */
  putDatagram(message) {
    let lost = 0;
    while (this.#datagrams > 0 && !this.hasRoom) {
      this.#lose(this.#removeEldestDatagram());
      ++lost;
    }
    if (!this.hasRoom) {
      this.#lose(message);
      return lost + 1;
    }
    ++this.#datagrams;
    this.#put(message, true);
    return lost;
  }

  /** The eldest message; undefined where none waits. */
  take() {
    const message = this.#removeFirst();
    const lost = message && this.#lost.get(message.life);
    if (lost === undefined) return message;
    this.#lost.delete(message.life);
    return { ...message, missed: message.missed + lost };
  }

  #put(message, isDatagram) {
    this.#waiting.push({ message, isDatagram });
    this.#octets += message.payload.length;
  }

  #lose({ life, missed }) {
    if (life === 0n) return;
    const lost = this.#lost.get(life) ?? 0n;
    if (lost === 0n && this.#lost.size >= maxRemembered) this.#lost.delete(this.#lost.keys().next().value);
    this.#lost.set(life, lost + missed + 1n);
  }

  #removeFirst() {
    if (this.size === 0) return undefined;
    const { message, isDatagram } = this.#waiting[this.#head];
    this.#waiting[this.#head++] = undefined;
    if (this.#head > 64 && this.#head * 2 > this.#waiting.length) {
      this.#waiting.splice(0, this.#head);
      this.#head = 0;
    }
    this.#octets -= message.payload.length;
    if (isDatagram) --this.#datagrams;
    return message;
  }

  #removeEldestDatagram() {
    if (this.#waiting[this.#head].isDatagram) return this.#removeFirst();
    const at = this.#waiting.findIndex((one, i) => i >= this.#head && one.isDatagram);
    const [{ message }] = this.#waiting.splice(at, 1);
    this.#octets -= message.payload.length;
    --this.#datagrams;
    return message;
  }
}
