// Waits that an AbortSignal can end.
import { AbortError } from '../protocol/errors.js';

export function throwIfAborted(signal) {
  if (signal?.aborted) throw new AbortError(signal);
}

/** Calls a function when the signal is aborted, until the function that it gives is called. */
export function onAbort(signal, callback) {
  if (!signal) return () => {};
  signal.addEventListener('abort', callback, { once: true });
  return () => signal.removeEventListener('abort', callback);
}

/** The result of a promise, or an AbortError as soon as the signal is aborted. */
export async function abortable(promise, signal) {
  if (!signal) return promise;
  throwIfAborted(signal);
  let off;
  const aborted = new Promise((_, reject) => {
    off = onAbort(signal, () => reject(new AbortError(signal)));
  });
  try {
    return await Promise.race([promise, aborted]);
  } finally {
    off();
  }
}
