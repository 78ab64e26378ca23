// Frames without a seal (src/client/CHANNELS.md, "Frames").
import { maxDatagramMessage } from './limits.js';

export const headerSize = 24;
export const kinds = Object.freeze({ message: 1, hello: 2, end: 3, floor: 4, full: 5 });
export const forms = Object.freeze({ plain: 1, encrypted: 2, authenticated: 3 });
const magic = 0x4743;

/** Whether octets begin as those of any form do, with a payload of `least` to `most` octets behind the header. */
export function isBeginning(octets, at, least, most) {
  const kind = octets[at + 3];
  const length = octets.readUInt32BE(at + 4);
  return octets.readUInt16BE(at) === magic && kind >= kinds.message && kind <= kinds.full && length >= least && length <= most &&
      octets.readBigUInt64BE(at + 8) !== 0n;
}

/** Whether the 24 octets at `at` begin a plain frame with a payload of at most `most` octets. */
export const isHeader = (octets, at, most) => octets[at + 2] === forms.plain && isBeginning(octets, at, 0, most);

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

/** The plain frame that a datagram is; undefined if it is none. */
export function frameOfDatagram(octets) {
  if (octets.length < headerSize || !isHeader(octets, 0, maxDatagramMessage)) return undefined;
  return octets.readUInt32BE(4) === octets.length - headerSize ? frameAt(octets, 0) : undefined;
}

/** Writes the part of a header that all forms have. `sequence` is a number, at most 2^53, or a BigInt. */
export function writeHeader(octets, form, kind, length, life, sequence) {
  octets.writeUInt32BE((magic << 16 | form << 8 | kind) >>> 0, 0);
  octets.writeUInt32BE(length, 4);
  octets.writeBigUInt64BE(life, 8);
  octets.writeBigUInt64BE(BigInt(sequence), 16);
}

/** The octets of a plain frame, in a buffer of their own. */
export function encodeFrame(kind, life, sequence, payload) {
  const length = payload?.length ?? 0;
  const octets = Buffer.allocUnsafe(headerSize + length);
  writeHeader(octets, forms.plain, kind, length, life, sequence);
  if (length > 0) octets.set(payload, headerSize);
  return octets;
}
