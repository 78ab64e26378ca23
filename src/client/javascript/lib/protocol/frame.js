// Frames (src/client/CHANNELS.md, "Frames").
import { maxDatagramMessage } from './limits.js';

export const headerSize = 24;
export const kinds = Object.freeze({ message: 1, hello: 2, end: 3 });
const magic = 0x4743;
const version = 1;
/** A piece of memory that messages up to `maxShared` octets share. It is freed with the last of them. */
const slabSize = 64 * 1024;
const maxShared = 16 * 1024;

/** Whether the 24 octets at `at` begin a frame with a payload of at most `most` octets. */
export function isHeader(octets, at, most) {
  const kind = octets[at + 3];
  return octets.readUInt16BE(at) === magic && octets[at + 2] === version && kind >= 1 && kind <= 3 &&
      octets.readUInt32BE(at + 4) <= most && octets.readBigUInt64BE(at + 8) !== 0n;
}

/** The frame at `at`. Requires a header and the whole payload. The payload shares the octets. */
export function frameAt(octets, at) {
  const begin = at + headerSize;
  return {
    kind: octets[at + 3],
    life: octets.readBigUInt64BE(at + 8),
    sequence: octets.readBigUInt64BE(at + 16),
    payload: octets.subarray(begin, begin + octets.readUInt32BE(at + 4)),
  };
}

/** The frame that a datagram is; undefined if it is none. */
export function frameOfDatagram(octets) {
  if (octets.length < headerSize || !isHeader(octets, 0, maxDatagramMessage)) return undefined;
  return octets.readUInt32BE(4) === octets.length - headerSize ? frameAt(octets, 0) : undefined;
}

/** The octets of a frame, in a buffer of their own. */
export function encodeFrame(kind, life, sequence, payload) {
  const length = payload?.length ?? 0;
  const octets = Buffer.allocUnsafe(headerSize + length);
  octets.writeUInt32BE((magic << 16 | version << 8 | kind) >>> 0, 0);
  octets.writeUInt32BE(length, 4);
  octets.writeBigUInt64BE(life, 8);
  octets.writeBigUInt64BE(sequence, 16);
  if (length > 0) octets.set(payload, headerSize);
  return octets;
}

/** Writes the messages of one life, faster than encodeFrame does. */
export class MessageWriter {
  #head;
  #scratch;
  #slab;
  #used = 0;
  #isReused;
  /** Whether the last message is in octets that will be written again. */
  isLent = false;

  /** With `isReused` the octets of a message may be written again by the next one, unless `keep` is called between. */
  constructor(life, isReused = false) {
    this.#head = encodeFrame(kinds.message, life, 0n);
    this.#isReused = isReused;
  }

  /** Keeps the octets of the last message, which are still needed. */
  keep() {
    this.#scratch = undefined;
  }

  /** The frame of a message. The sequence is at most 2^53, which no publisher reaches. */
  write(sequence, payload) {
    const octets = this.#room(headerSize + payload.length);
    octets.set(this.#head);
    octets.writeUInt32BE(payload.length, 4);
    octets.writeUInt32BE(Math.floor(sequence / 0x100000000), 16);
    octets.writeUInt32BE(sequence % 0x100000000, 20);
    octets.set(payload, headerSize);
    return octets;
  }

  /** Room for a message. Small messages share memory, because an allocation for each costs more than the copy. */
  #room(size) {
    this.isLent = this.#isReused && size * 2 >= Buffer.poolSize;
    if (this.isLent) {
      if (!this.#scratch || this.#scratch.length < size) this.#scratch = Buffer.allocUnsafeSlow(headerSize + maxDatagramMessage);
      return this.#scratch.subarray(0, size);
    }
    if (size > maxShared) return Buffer.allocUnsafeSlow(size);
    if (!this.#slab || this.#used + size > slabSize) {
      this.#slab = Buffer.allocUnsafeSlow(slabSize);
      this.#used = 0;
    }
    const begin = this.#used;
    this.#used = begin + size;
    return this.#slab.subarray(begin, this.#used);
  }
}
