// Frames, in which messages travel (src/client/CHANNELS.md, "Frames").
import { maxDatagramMessage } from './limits.js';

export const headerSize = 24;
export const kinds = Object.freeze({ message: 1, hello: 2, end: 3 });
const magic = 0x4743;
const version = 1;
/** Memory that messages up to `maxShared` octets are written into, one behind the other. It is freed with the last of them. */
const slabSize = 64 * 1024;
const maxShared = 16 * 1024;

/** Whether the 24 octets at `at` begin a frame with a payload of at most `most` octets. */
export function isHeader(octets, at, most) {
  const kind = octets[at + 3];
  return octets.readUInt16BE(at) === magic && octets[at + 2] === version && kind >= 1 && kind <= 3 &&
      octets.readUInt32BE(at + 4) <= most && octets.readBigUInt64BE(at + 8) !== 0n;
}

/** The frame at `at`, whose header is one and whose payload is there. The payload shares the octets. */
export function frameAt(octets, at) {
  const begin = at + headerSize;
  return {
    kind: octets[at + 3],
    life: octets.readBigUInt64BE(at + 8),
    sequence: octets.readBigUInt64BE(at + 16),
    payload: octets.subarray(begin, begin + octets.readUInt32BE(at + 4)),
  };
}

/** The frame that a datagram is, or undefined. */
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

/** Writes the messages of one life; quicker than encodeFrame, since senders are measured against plain sockets. */
export class MessageWriter {
  #head;
  #scratch;
  #slab;
  #used = 0;
  #isReused;
  /** Whether what was written last is in octets that are written again. */
  isLent = false;

  /** `isReused`: octets that were written are free when the next ones are, unless `keep` is called between. */
  constructor(life, isReused = false) {
    this.#head = encodeFrame(kinds.message, life, 0n);
    this.#isReused = isReused;
  }

  /** What was written last is still needed. */
  keep() {
    this.#scratch = undefined;
  }

  /** A sequence up to 2^53, which nobody reaches. */
  write(sequence, payload) {
    const octets = this.#room(headerSize + payload.length);
    octets.set(this.#head);
    octets.writeUInt32BE(payload.length, 4);
    octets.writeUInt32BE(Math.floor(sequence / 0x100000000), 16);
    octets.writeUInt32BE(sequence % 0x100000000, 20);
    octets.set(payload, headerSize);
    return octets;
  }

  /** Many messages share a piece of memory: one of its own for each costs more than what is copied into it. */
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
