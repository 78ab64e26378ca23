// The frames of one life, plain or sealed as the mode wants it, with the one counter of this life.
import { lastBack } from './channel_keys.js';
import { ClosedError } from './errors.js';
import { encodeFrame, forms, headerSize, kinds } from './frame.js';
import { maxDatagramMessage } from './limits.js';
import { sealedHeaderSize, tagSize } from './sealed_frame.js';

/** A piece of memory that messages up to `maxShared` octets share. It is freed with the last of them. */
const slabSize = 64 * 1024;
const maxShared = 16 * 1024;
const seal = sealedHeaderSize + tagSize;
const none = Buffer.alloc(0);

/** The next number of a counter. Throws ClosedError where it is used up, because no nonce is used twice. */
function counted(counter, last) {
  if (counter < last) return counter + 1;
  throw new ClosedError('channel', 'its counter is used up, so make another one');
}

/** Octets for messages. Small ones share memory, because an allocation for each costs more than the copy. */
class Room {
  #scratch;
  #slab;
  #used = 0;
  #isReused;
  /** Whether the last octets will be given again. */
  isLent = false;

  /** With `isReused` large octets may be given again, unless `keep` is called between. */
  constructor(isReused) {
    this.#isReused = isReused;
  }

  keep() {
    this.#scratch = undefined;
  }

  take(size, isAlone) {
    this.isLent = this.#isReused && size * 2 >= Buffer.poolSize;
    if (this.isLent) {
      if (!this.#scratch || this.#scratch.length < size) this.#scratch = Buffer.allocUnsafeSlow(seal + maxDatagramMessage);
      return this.#scratch.subarray(0, size);
    }
    if (size > maxShared || isAlone) return Buffer.allocUnsafeSlow(size);
    if (!this.#slab || this.#used + size > slabSize) {
      this.#slab = Buffer.allocUnsafeSlow(slabSize);
      this.#used = 0;
    }
    const begin = this.#used;
    this.#used = begin + size;
    return this.#slab.subarray(begin, this.#used);
  }
}

/** The frames of a publisher. */
export class PublisherFrames {
  #life;
  #head;
  #room;
  #counter;
  #sequence = 0;
  /** The keys of this life; undefined until the daemon has said which there are. */
  keys;
  /** The port where hellos are taken, if it is not the one that is sent from. */
  helloPort = 0;

  /** `isReused`: the octets of a large message may be written again by the next one, unless `keep` is called between. */
  constructor(life, isReused = false, counter = 0) {
    this.#life = life;
    this.#head = encodeFrame(kinds.message, life, 0n);
    this.#room = new Room(isReused);
    this.#counter = counter;
  }

  get life() {
    return this.#life;
  }

  /** The sequence of the last message. It is at most 2^53, which no publisher reaches. */
  get sequence() {
    return this.#sequence;
  }

  get seals() {
    return this.keys?.seals ?? false;
  }

  get hasRing() {
    return this.keys?.hasRing ?? false;
  }

  /** Whether plain frames are taken; not where it is not known which keys there are. */
  get takesPlain() {
    return this.keys?.takesPlain ?? false;
  }

  /** Whether the last message is in octets that will be written again. */
  get isLent() {
    return this.#room.isLent;
  }

  /** Keeps the octets of the last message, which are still needed. */
  keep() {
    this.#room.keep();
  }

  /** The frame of the next message; with `isAlone` in memory that it shares with no other. Requires keys. Throws ClosedError. */
  message(payload, isAlone = false) {
    if (this.keys.form !== forms.plain) return this.#sealedMessage(payload, isAlone);
    const sequence = ++this.#sequence;
    const octets = this.#room.take(headerSize + payload.length, isAlone);
    octets.set(this.#head);
    octets.writeUInt32BE(payload.length, 4);
    octets.writeUInt32BE(Math.floor(sequence / 0x100000000), 16);
    octets.writeUInt32BE(sequence % 0x100000000, 20);
    octets.set(payload, headerSize);
    return octets;
  }

  /** A floor or a full with the payload of a handshake, or an end without one. Throws ClosedError. */
  other(kind, payload = none, isFromHelloPort = false) {
    if (!this.seals) return encodeFrame(kind, this.#life, BigInt(this.#sequence), payload);
    const octets = Buffer.allocUnsafe(seal + payload.length);
    const port = isFromHelloPort ? 0 : this.helloPort;
    this.keys.sealForward(octets, { kind, life: this.#life, sequence: this.#sequence, counter: this.#next(), port }, payload);
    return octets;
  }

  /** The end; undefined where the counter is used up, because then nothing can be said any more. */
  end() {
    try {
      return this.other(kinds.end);
    } catch (error) {
      if (error instanceof ClosedError) return undefined;
      throw error;
    }
  }

  /** A frame of a consumer as this host takes it, opened; undefined if it does not. */
  take(frame) {
    return this.keys?.takeBack(frame);
  }

  #sealedMessage(payload, isAlone) {
    const counter = this.#next();
    const octets = this.#room.take(seal + payload.length, isAlone);
    const head = { kind: kinds.message, life: this.#life, sequence: ++this.#sequence, counter, port: this.helloPort };
    this.keys.sealForward(octets, head, payload);
    return octets;
  }

  #next() {
    this.#counter = counted(this.#counter, Number.MAX_SAFE_INTEGER);
    return this.#counter;
  }
}

/** The frames of a subscriber. */
export class ConsumerFrames {
  #life;
  #counter;

  constructor(life, counter = 0) {
    this.#life = life;
    this.#counter = counter;
  }

  get life() {
    return this.#life;
  }

  /** A hello or an end to a publisher with these keys. Throws ClosedError. */
  write(keys, kind, payload) {
    if (!keys.seals) return encodeFrame(kind, this.#life, 0n, payload);
    this.#counter = counted(this.#counter, lastBack);
    const octets = Buffer.allocUnsafe(seal + payload.length);
    keys.sealBack(octets, { kind, life: this.#life, counter: this.#counter }, payload);
    return octets;
  }
}
