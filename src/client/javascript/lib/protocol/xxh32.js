// XXH32 with the seed 0, as the xxHash project specifies it.
const p1 = 0x9e3779b1;
const p2 = 0x85ebca77;
const p3 = 0xc2b2ae3d;
const p4 = 0x27d4eb2f;
const p5 = 0x165667b1;

const rotated = (x, bits) => (x << bits) | (x >>> (32 - bits));
const round = (lane, word) => Math.imul(rotated((lane + Math.imul(word, p2)) | 0, 13), p1);

/** The hash of a Uint8Array, from 0 to 4294967295. */
export function xxh32(octets) {
  const view = new DataView(octets.buffer, octets.byteOffset, octets.byteLength);
  const length = octets.byteLength;
  let at = 0;
  let hash = p5 | 0;
  if (length >= 16) {
    let a = (p1 + p2) | 0;
    let b = p2 | 0;
    let c = 0;
    let d = -p1 | 0;
    for (; at + 16 <= length; at += 16) {
      a = round(a, view.getUint32(at, true));
      b = round(b, view.getUint32(at + 4, true));
      c = round(c, view.getUint32(at + 8, true));
      d = round(d, view.getUint32(at + 12, true));
    }
    hash = (rotated(a, 1) + rotated(b, 7) + rotated(c, 12) + rotated(d, 18)) | 0;
  }
  hash = (hash + length) | 0;
  for (; at + 4 <= length; at += 4) {
    hash = Math.imul(rotated((hash + Math.imul(view.getUint32(at, true), p3)) | 0, 17), p4);
  }
  for (; at < length; ++at) hash = Math.imul(rotated((hash + Math.imul(view.getUint8(at), p5)) | 0, 11), p1);
  hash = Math.imul(hash ^ (hash >>> 15), p2);
  hash = Math.imul(hash ^ (hash >>> 13), p3);
  return (hash ^ (hash >>> 16)) >>> 0;
}
