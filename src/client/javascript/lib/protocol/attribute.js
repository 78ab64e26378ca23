// Names of attributes among the keys of GCNP.
import { StatementError } from './errors.js';

/** src/discovery/gcnp/GCNP.md, the block `reserved`, in its order. */
export const reservedKeys = Object.freeze(
  ('mode id text concept representation port address protocol priority match provider where limit service name degree ' +
    'reason subscription participant_name consumer distance age local used served participant peer favour prefer ' +
    'convert scope rank for').split(' '),
);
const reserved = new Set(reservedKeys);
const keysOfLines = new Set(['why', 'because', 'on', 'placed', 'unplaced', 'hops', 'reachable', 'reach']);
/** Keys of a request that are names of attributes in an offer. */
const keysOfRequests = ['on', 'reach'];

/** Whether the words are one slip from each other: a letter wrong, missing, too many, of the other case, or two swapped. */
export function isSlip(a, b) {
  if (a === b) return false;
  const [short, long] = a.length <= b.length ? [a.toLowerCase(), b.toLowerCase()] : [b.toLowerCase(), a.toLowerCase()];
  if (long.length - short.length > 1) return false;
  let i = 0;
  while (i < short.length && short[i] === long[i]) ++i;
  if (i === long.length) return true;
  if (long.length > short.length) return short.slice(i) === long.slice(i + 1);
  if (short.slice(i + 1) === long.slice(i + 1)) return true;
  return short[i] === long[i + 1] && short[i + 1] === long[i] && short.slice(i + 2) === long.slice(i + 2);
}

/** The attribute that a key of a client's statement names. Throws StatementError if it names none. */
export function attributeName(key, keysOfStatement = []) {
  if (key.startsWith('attr.')) {
    if (key.length === 5) throw new StatementError('the name of an attribute is missing behind attr.');
    return key.slice(5);
  }
  const escape = `; an attribute of this name is written attr.${key}`;
  if (reserved.has(key)) throw new StatementError(`${key} is reserved and means nothing here${escape}`);
  const meant = [...keysOfStatement, ...reservedKeys].find((one) => isSlip(key, one));
  if (meant) throw new StatementError(`${key} is no key: did you mean ${meant}?${escape}`);
  const dot = key.indexOf('.');
  if (dot >= 0 && isSlip(key.slice(0, dot), 'attr')) {
    throw new StatementError(`${key} is no key: did you mean attr.${key.slice(dot + 1)}?${escape}`);
  }
  return key;
}

/** The key by which a client states an attribute. */
export function statedKey(name) {
  if (name.startsWith('attr.')) return `attr.${name}`;
  if (keysOfRequests.some((key) => key === name || isSlip(key, name))) return `attr.${name}`;
  try {
    return attributeName(name);
  } catch {
    return `attr.${name}`;
  }
}

/** The attribute that a key of the daemon's line shows; undefined if it is a key of GCNP. */
export function shownAttribute(key) {
  if (key.startsWith('attr.')) return key.slice(5);
  return reserved.has(key) || keysOfLines.has(key) ? undefined : key;
}

/** Attributes in the order in which they are written, which is that of the octets of their names. */
export const inOrder = (attributes) =>
  Object.entries(attributes).sort(([a], [b]) => Buffer.compare(Buffer.from(a), Buffer.from(b)));
