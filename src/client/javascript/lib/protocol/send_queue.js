// The frames that wait for the TCP consumers of one publisher. The octets of each frame are kept once, whoever waits for it.
import { headerSize } from './frame.js';
import { enoughWaiting, enoughWaitingFrames, maxWaiting, maxWaitingFrames } from './limits.js';
import { isSealed, sealedHeaderSize } from './sealed_frame.js';

/** The memory of all frames that wait. Small frames share pieces of memory, which are counted as a whole. */
export class Pool {
  #holders = new Map();
  octets = 0;

  hold({ buffer }) {
    const holders = this.#holders.get(buffer) ?? 0;
    if (holders === 0) this.octets += buffer.byteLength;
    this.#holders.set(buffer, holders + 1);
  }

  release({ buffer }) {
    const holders = this.#holders.get(buffer) - 1;
    if (holders > 0) {
      this.#holders.set(buffer, holders);
      return;
    }
    this.#holders.delete(buffer);
    this.octets -= buffer.byteLength;
  }
}

/** Whether the second frame lies behind the first one in memory. */
const isBehind = (first, second) =>
  first.buffer === second.buffer && first.byteOffset + first.length === second.byteOffset;

/** The end of the frame of which so many octets were sent, where frames follow each other from the beginning on. */
function endOfBegun(octets, sent) {
  let at = 0;
  while (at < sent) at += (isSealed(octets, at) ? sealedHeaderSize : headerSize) + octets.readUInt32BE(at + 4);
  return at;
}

/** The frames that wait for one consumer, in order. Those that lie behind each other in memory are one piece. */
export class SendQueue {
  #pool;
  #pieces = [];
  /** How many frames each piece has. */
  #counts = [];
  #frames = 0;
  #head = 0;
  /** Octets of the first piece that were sent. */
  #sent = 0;
  /** Octets that wait. */
  octets = 0;

  constructor(pool) {
    this.#pool = pool;
  }

  get isEmpty() {
    return this.#head === this.#pieces.length;
  }

  /** Whether a frame of this size may wait: within 4 MiB and 16 384 frames, or alone. The frames of a piece count until it was sent. */
  hasRoomFor(octets) {
    return this.isEmpty || (this.octets + octets <= maxWaiting && this.#frames < maxWaitingFrames);
  }

  /** Whether it is better to wait until all has been sent. */
  get isEnough() {
    return this.octets >= enoughWaiting || this.#frames >= enoughWaitingFrames;
  }

  put(frame) {
    this.octets += frame.length;
    ++this.#frames;
    const last = this.isEmpty ? undefined : this.#pieces.at(-1);
    if (last && isBehind(last, frame)) {
      this.#pieces[this.#pieces.length - 1] = Buffer.from(last.buffer, last.byteOffset, last.length + frame.length);
      ++this.#counts[this.#counts.length - 1];
      return;
    }
    this.#pool.hold(frame);
    this.#pieces.push(frame);
    this.#counts.push(1);
  }

  /** The next octets to send, of one piece and at most so many. Requires that it is not empty. */
  next(most) {
    return this.#pieces[this.#head].subarray(this.#sent, this.#sent + most);
  }

  /** So many of the octets that `next` gave were sent. */
  took(octets) {
    this.octets -= octets;
    this.#sent += octets;
    if (this.#sent === this.#pieces[this.#head].length) this.#shift();
  }

  /** Forgets all frames, but not the rest of one that was sent in part. Of the first piece so many octets are being sent. */
  dismiss(sending) {
    if (this.isEmpty) return;
    const first = this.#pieces[this.#head];
    const end = endOfBegun(first, this.#sent + sending);
    const rest = first.subarray(this.#sent, end);
    this.clear();
    if (rest.length > 0) this.put(rest);
  }

  /** Forgets all frames. */
  clear() {
    while (!this.isEmpty) this.#shift();
    this.octets = 0;
  }

  #shift() {
    this.#pool.release(this.#pieces[this.#head]);
    this.#frames -= this.#counts[this.#head];
    this.#pieces[this.#head++] = undefined;
    this.#sent = 0;
    if (this.#head > 64 && this.#head * 2 > this.#pieces.length) {
      this.#pieces.splice(0, this.#head);
      this.#counts.splice(0, this.#head);
      this.#head = 0;
    }
  }
}
