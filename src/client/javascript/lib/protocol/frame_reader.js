// Frames of all forms put together from the octets of a stream.
import { frameAt, headerSize, isHeader } from './frame.js';
import { isSealed, isSealedHeader, sealedFrameAt, sealedHeaderSize } from './sealed_frame.js';

/**
 * Gives the frames of a stream one at a time, so that a subscriber without room need not take more. Keeps at most one
 * unfinished frame and the last piece.
 */
export class FrameReader {
  #pieces = [];
  #length = 0;
  #most;
  /** Whether something was no frame, so that nothing behind it can be read. */
  isBroken = false;

  /** @param most the largest payload, in octets */
  constructor(most) {
    this.#most = most;
  }

  push(piece) {
    if (piece.length === 0) return;
    this.#pieces.push(piece);
    this.#length += piece.length;
  }

  /** The next frame; undefined if more octets are needed, or the stream is broken. Its payload shares the stream's octets. */
  next() {
    if (this.isBroken || this.#length < headerSize) return undefined;
    const head = this.#atLeast(headerSize);
    const hasSeal = isSealed(head, 0);
    if (!(hasSeal ? isSealedHeader : isHeader)(head, 0, this.#most)) {
      this.isBroken = true;
      this.#pieces = [];
      this.#length = 0;
      return undefined;
    }
    const size = (hasSeal ? sealedHeaderSize : headerSize) + head.readUInt32BE(4);
    if (this.#length < size) return undefined;
    const octets = this.#atLeast(size);
    const frame = hasSeal ? sealedFrameAt(octets, 0) : frameAt(octets, 0);
    this.#length -= size;
    if (octets.length === size) this.#pieces.shift();
    else this.#pieces[0] = octets.subarray(size);
    return frame;
  }

  /** Makes the first piece at least so long. Requires that so many octets are here. */
  #atLeast(size) {
    if (this.#pieces[0].length >= size) return this.#pieces[0];
    let count = 0;
    for (let length = 0; length < size; ++count) length += this.#pieces[count].length;
    this.#pieces.splice(0, count, Buffer.concat(this.#pieces.slice(0, count)));
    return this.#pieces[0];
  }
}
