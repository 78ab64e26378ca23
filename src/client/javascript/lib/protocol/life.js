// Lives: 64 random bits by which both sides of a channel know each other. A life is a BigInt, 0n where there is none.
import { randomBytes } from 'node:crypto';

/** A new life, which is not 0. */
export function newLife(random = randomBytes) {
  for (;;) {
    const life = random(8).readBigUInt64BE();
    if (life !== 0n) return life;
  }
}

/** Sixteen lower-case hexadecimal digits. */
export const lifeText = (life) => life.toString(16).padStart(16, '0');

/** The life that an attribute `channel` states; 0n where it cannot be read. */
export const lifeOf = (text) => (/^[0-9a-f]{16}$/.test(text ?? '') ? BigInt(`0x${text}`) : 0n);

/** The eight octets of a life. */
export function lifeOctets(life) {
  const octets = Buffer.alloc(8);
  octets.writeBigUInt64BE(life);
  return octets;
}
