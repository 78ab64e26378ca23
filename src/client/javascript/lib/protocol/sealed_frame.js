// Sealed frames: those of the forms 2 and 3 (src/client/CHANNELS.md, "Sealed channels").
import { createCipheriv, createDecipheriv } from 'node:crypto';

import { forms, frameOfDatagram, headerSize, isBeginning, writeHeader } from './frame.js';
import { maxDatagramMessage } from './limits.js';

export const sealedHeaderSize = 36;
export const tagSize = 16;
export const algorithm = 'chacha20-poly1305';
const how = Object.freeze({ authTagLength: tagSize });

/** Whether octets, at least 3 of them at `at`, begin as a sealed frame does. */
export const isSealed = (octets, at) => octets[at + 2] === forms.encrypted || octets[at + 2] === forms.authenticated;

/** Whether the 24 octets at `at`, of a sealed form, begin a frame with a payload of at most `most` octets. */
export const isSealedHeader = (octets, at, most) => isBeginning(octets, at, tagSize, most + tagSize);

/**
 * The sealed frame at `at`, which has not been opened. Requires a header and all that follows it. It shares the octets. The
 * payload is as it was sent.
 */
export function sealedFrameAt(octets, at) {
  const end = at + sealedHeaderSize + octets.readUInt32BE(at + 4);
  return {
    form: octets[at + 2],
    kind: octets[at + 3],
    life: octets.readBigUInt64BE(at + 8),
    sequence: octets.readBigUInt64BE(at + 16),
    key: octets.readUInt16BE(at + 24),
    port: octets.readUInt16BE(at + 26),
    counter: octets.readBigUInt64BE(at + 28),
    payload: octets.subarray(at + sealedHeaderSize, end - tagSize),
    octets: octets.subarray(at, end),
  };
}

/** The frame of any form that a datagram is; undefined if it is none. */
export function anyFrameOfDatagram(octets) {
  if (octets.length < headerSize || !isSealed(octets, 0)) return frameOfDatagram(octets);
  if (octets.length < sealedHeaderSize || !isSealedHeader(octets, 0, maxDatagramMessage)) return undefined;
  return octets.readUInt32BE(4) === octets.length - sealedHeaderSize ? sealedFrameAt(octets, 0) : undefined;
}

/**
 * Writes a sealed frame into octets that have exactly its size: `{form, kind, life, sequence, id, port, counter}` and the
 * payload, by a key and a nonce that was never used under it.
 */
export function sealInto(octets, key, nonce, { form, kind, life, sequence, id, port, counter }, payload) {
  const end = octets.length - tagSize;
  writeHeader(octets, form, kind, octets.length - sealedHeaderSize, life, sequence);
  octets.writeUInt16BE(id, 24);
  octets.writeUInt16BE(port, 26);
  octets.writeBigUInt64BE(BigInt(counter), 28);
  const cipher = createCipheriv(algorithm, key, nonce, how);
  if (form === forms.encrypted) {
    cipher.setAAD(octets.subarray(0, sealedHeaderSize), { plaintextLength: payload.length });
    octets.set(cipher.update(payload), sealedHeaderSize);
  } else {
    octets.set(payload, sealedHeaderSize);
    cipher.setAAD(octets.subarray(0, end), { plaintextLength: 0 });
  }
  cipher.final();
  octets.set(cipher.getAuthTag(), end);
}

/** The payload of a sealed frame; undefined if this key and nonce do not open it. */
export function openSealed(key, nonce, { form, payload, octets }) {
  const end = octets.length - tagSize;
  const decipher = createDecipheriv(algorithm, key, nonce, how);
  decipher.setAuthTag(octets.subarray(end));
  const isEncrypted = form === forms.encrypted;
  decipher.setAAD(isEncrypted ? octets.subarray(0, sealedHeaderSize) : octets.subarray(0, end), { plaintextLength: isEncrypted ? payload.length : 0 });
  try {
    const opened = isEncrypted ? decipher.update(payload) : payload;
    decipher.final();
    return opened;
  } catch {
    return undefined;
  }
}
