// The handshake of a consumer with a publisher, and the cookies that nobody keeps (src/client/CHANNELS.md, "The handshake").
import { createHmac, randomBytes } from 'node:crypto';

import * as limits from './limits.js';

export const handshakeSize = 24;

/** The payload of a hello, a floor, a full, or the end of a listener. `life` is that of the other side. */
export function writeHandshake(life, challenge, cookie) {
  const octets = Buffer.allocUnsafe(handshakeSize);
  octets.writeBigUInt64BE(life, 0);
  octets.writeBigUInt64BE(challenge, 8);
  octets.writeBigUInt64BE(cookie, 16);
  return octets;
}

/** The handshake `{life, challenge, cookie}` that a payload is; undefined if it has another size. */
export function readHandshake(payload) {
  if (payload.length !== handshakeSize) return undefined;
  const octets = Buffer.from(payload.buffer, payload.byteOffset, handshakeSize);
  return { life: octets.readBigUInt64BE(0), challenge: octets.readBigUInt64BE(8), cookie: octets.readBigUInt64BE(16) };
}

/** The cookies of one publisher. Time is milliseconds that never go back. */
export class Cookies {
  #secret;

  constructor(secret = randomBytes(32)) {
    this.#secret = secret;
  }

  /** The cookie for a hello of this life from this address and port; never 0n. */
  cookie(address, port, life, challenge, now) {
    return this.#of(address, port, life, challenge, Math.floor(now / limits.cookiePatience));
  }

  /** Whether a cookie is that of the present 8 s, or of the 8 s before. */
  isRight(address, port, life, challenge, cookie, now) {
    const period = Math.floor(now / limits.cookiePatience);
    return cookie !== 0n && [period, period - 1].some((one) => this.#of(address, port, life, challenge, one) === cookie);
  }

  #of(address, port, life, challenge, period) {
    const said = `${address} ${port} ${life} ${challenge} ${period}`;
    return createHmac('sha256', this.#secret).update(said).digest().readBigUInt64BE(0) || 1n;
  }
}

/** The answers to datagrams that a publisher may give: 512 at once, and 512 a second. */
export class Allowance {
  #left = limits.maxAnswers;
  #at;

  constructor(now) {
    this.#at = now;
  }

  /** Whether there is one more; with `keepsHalf`, whether there is one without the half that is kept for others. */
  take(now, keepsHalf = false) {
    this.#left = Math.min(limits.maxAnswers, this.#left + ((now - this.#at) / 1000) * limits.maxAnswers);
    this.#at = now;
    if (this.#left < 1 + (keepsHalf ? limits.maxAnswers / 2 : 0)) return false;
    --this.#left;
    return true;
  }
}
