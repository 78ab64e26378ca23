// What waits for the application: messages in order, bounded by number and octets.

/**
 * Full at either limit, but one message always has room. Datagrams that come then push out the oldest datagrams, since who
 * sent them does not wait, and are lost themselves where there are none; streams are asked to wait by `hasRoom`, so of what
 * came over TCP nothing is lost.
 */
export class MessageQueue {
  #items = [];
  #head = 0;
  #octets = 0;
  #datagrams = 0;
  #length;
  #maxOctets;

  /** @param length messages; @param maxOctets of their payloads */
  constructor(length, maxOctets) {
    this.#length = length;
    this.#maxOctets = maxOctets;
  }

  get size() {
    return this.#items.length - this.#head;
  }

  /** Whether there is room for one more. */
  get hasRoom() {
    return this.size < this.#length && this.#octets < this.#maxOctets;
  }

  /** Whether a stream that had to wait may go on: half of the room is there. */
  get isHalfEmpty() {
    return this.size <= this.#length / 2 && this.#octets <= this.#maxOctets / 2;
  }

  /** Adds one; gives the datagrams that were lost for that, perhaps this one itself. */
  push(item, isDatagram) {
    const lost = [];
    if (isDatagram) {
      while (this.#datagrams > 0 && !this.hasRoom) lost.push(this.#oldestDatagram());
      if (!this.hasRoom) return [...lost, item];
      ++this.#datagrams;
    }
    this.#items.push({ item, isDatagram });
    this.#octets += item.payload.length;
    return lost;
  }

  shift() {
    if (this.size === 0) return undefined;
    const { item, isDatagram } = this.#items[this.#head];
    this.#items[this.#head++] = undefined;
    if (this.#head > 64 && this.#head * 2 > this.#items.length) {
      this.#items.splice(0, this.#head);
      this.#head = 0;
    }
    this.#octets -= item.payload.length;
    if (isDatagram) --this.#datagrams;
    return item;
  }

  #oldestDatagram() {
    if (this.#items[this.#head].isDatagram) return this.shift();
    const at = this.#items.findIndex((one, i) => i >= this.#head && one.isDatagram);
    const [{ item }] = this.#items.splice(at, 1);
    this.#octets -= item.payload.length;
    --this.#datagrams;
    return item;
  }
}
