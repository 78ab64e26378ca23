// The keys of one publisher's life, as the daemon's line `pub keys` gives them (src/client/CHANNELS.md, "Sealed channels").
import { createSecretKey, getCiphers } from 'node:crypto';

import { GemingaError } from './errors.js';
import { forms } from './frame.js';
import { lifeOf } from './life.js';
import { maxKeysOfRing } from './limits.js';
import { algorithm, openSealed, sealInto } from './sealed_frame.js';

/** The largest counter of a consumer. */
export const lastBack = 0xffff_ffff;

/** The form that a host of each mode sends, and whether it takes plain frames. */
const modes = new Map([
  ['plain', { form: forms.plain, takesPlain: true }],
  ['prepared', { form: forms.plain, takesPlain: true }],
  ['mixed', { form: forms.encrypted, takesPlain: true }],
  ['authenticated', { form: forms.authenticated, takesPlain: false }],
  ['encrypted', { form: forms.encrypted, takesPlain: false }],
]);

/** Whether a host of this mode takes plain frames. No host of an unknown mode does. */
export const takesPlainIn = (mode) => modes.get(mode)?.takesPlain ?? false;

/** The keys of a channel cannot be used. No text has anything of them. */
const fail = (text) => {
  throw new GemingaError(text, 'GEMINGA_KEYS');
};

function forwardNonce(counter) {
  const nonce = Buffer.alloc(12);
  nonce.writeBigUInt64BE(BigInt(counter), 4);
  return nonce;
}

function backNonce(life, counter) {
  const nonce = Buffer.allocUnsafe(12);
  nonce.writeBigUInt64BE(life, 0);
  nonce.writeUInt32BE(Number(counter), 8);
  return nonce;
}

/** The mode of this host and the ring of one life. It never changes and shows no key, neither printed nor as JSON. */
export class ChannelKeys {
  #ring = new Map();
  #first;

  /** `ring`: for each key its id, and the octets of its forward and its back key. Throws GemingaError. */
  constructor(mode, ring = []) {
    const meant = modes.get(mode) ?? fail('the daemon names a mode of sealing that this library does not know');
    this.mode = mode;
    this.form = meant.form;
    this.takesPlain = meant.takesPlain;
    if (ring.length === 0 && mode !== 'plain') fail('the daemon gives no keys for a sealed channel');
    if (ring.length > 0 && !getCiphers().includes(algorithm)) {
      fail(`this Node has no ${algorithm}, so the channel cannot be sealed`);
    }
    for (const [id, forward, back] of ring) {
      this.#ring.set(id, { forward: createSecretKey(forward), back: createSecretKey(back) });
      this.#first ??= id;
    }
    Object.freeze(this);
  }

  /** Whether sealed frames can be opened. */
  get hasRing() {
    return this.#ring.size > 0;
  }

  /** Whether frames are sent sealed. */
  get seals() {
    return this.form !== forms.plain;
  }

  /** Whether the key of a sealed frame is in the ring. */
  hasKeyOf(frame) {
    return this.#ring.has(frame.key);
  }

  /** Writes a publisher's frame into octets of its size. Requires that this mode seals. */
  sealForward(octets, { kind, life, sequence, counter, port }, payload) {
    const head = { form: this.form, kind, life, sequence, id: this.#first, port, counter };
    sealInto(octets, this.#ring.get(this.#first).forward, forwardNonce(counter), head, payload);
  }

  /** Writes a consumer's frame into octets of its size. Requires that this mode seals, and a counter of at most 32 bits. */
  sealBack(octets, { kind, life, counter }, payload) {
    const head = { form: this.form, kind, life, sequence: 0n, id: this.#first, port: 0, counter };
    sealInto(octets, this.#ring.get(this.#first).back, backNonce(life, counter), head, payload);
  }

  /** A publisher's frame of any form as this mode takes it, opened; undefined if it does not. */
  takeForward(frame) {
    if (frame.form === undefined) return this.takesPlain ? frame : undefined;
    const keys = this.#ring.get(frame.key);
    return keys && this.#opened(frame, openSealed(keys.forward, forwardNonce(frame.counter), frame));
  }

  /** A consumer's frame of any form as this mode takes it, opened; undefined if it does not. */
  takeBack(frame) {
    if (frame.form === undefined) return this.takesPlain ? frame : undefined;
    const keys = this.#ring.get(frame.key);
    if (!keys || frame.counter > BigInt(lastBack)) return undefined;
    return this.#opened(frame, openSealed(keys.back, backNonce(frame.life, frame.counter), frame));
  }

  #opened({ kind, life, sequence, port, counter }, payload) {
    return payload && { kind, life, sequence, payload, port, counter, isSealed: true };
  }
}

/** The keys of a channel that has none. */
export const plainKeys = new ChannelKeys('plain');

/** The life and the keys of a statement `pub keys`. Throws GemingaError, whose text has nothing of the line. */
export function readChannelKeys({ parameters }) {
  const values = new Map(parameters);
  const life = lifeOf(values.get('life')) || fail('the daemon gives keys for no life');
  const words = values.get('ring') ? values.get('ring').split(',') : [];
  if (words.length > maxKeysOfRing) fail(`the daemon gives more than ${maxKeysOfRing} keys for a channel`);
  const ring = words.map((word) => {
    const found = /^([0-9a-f]{4}):([0-9a-f]{64}):([0-9a-f]{64})$/.exec(word) ?? fail('the daemon gives a key that cannot be read');
    return [parseInt(found[1], 16), Buffer.from(found[2], 'hex'), Buffer.from(found[3], 'hex')];
  });
  return { life, keys: new ChannelKeys(values.get('mode'), ring) };
}
