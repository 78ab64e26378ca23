// The values of GCNP's keys. Each reader gives a value in its canonical form, or throws StatementError.
import { isIP } from 'node:net';

import { StatementError } from './errors.js';
import * as limits from './limits.js';

export const modes = Object.freeze(['oto', 'otm/stream', 'otm/pubsub']);
const reaches = Object.freeze(['routed', 'any']);
const degrees = Object.freeze(['exact', 'equivalent', 'narrower', 'broader', 'overlapping']);
const anyCost = 0xffffffff;

const fail = (key, value, expected) => {
  throw new StatementError(`${key}=${value} cannot be read: it must be ${expected}`);
};

/** A decimal number without sign or spaces, or undefined. */
export function readNumber(text, most = 0xffffffff) {
  return /^[0-9]{1,20}$/.test(text) && Number(text) <= most ? Number(text) : undefined;
}

const text = (most) => (value, key) => {
  if (Buffer.byteLength(value) > most) throw new StatementError(`${key} is too long: at most ${most} octets`, 413);
  return value;
};

const name = (most, what) => (value, key) => (value === '' ? fail(key, value, what) : text(most)(value, key));

const oneOf = (words) => (value, key) => (words.includes(value) ? value : fail(key, value, words.join(', ')));

function number(value, key) {
  return String(readNumber(value) ?? fail(key, value, 'a number from 0 to 4294967295'));
}

function id(value, key) {
  const hexadecimal = /^0[xX][0-9a-fA-F]{1,8}$/.test(value) ? parseInt(value, 16) : undefined;
  return String(hexadecimal ?? readNumber(value) ?? fail(key, value, 'a number from 0 to 4294967295, decimal or behind 0x'));
}

function priority(value, key) {
  const read = /^-?[0-9]{1,10}$/.test(value) ? Number(value) : NaN;
  return read >= -2147483648 && read <= 2147483647
    ? String(read + 0)
    : fail(key, value, 'a number from -2147483648 to 2147483647');
}

function port(value, key) {
  return String(readNumber(value, 65535) || fail(key, value, 'a number from 1 to 65535'));
}

function address(value, key) {
  if (value === '') return value;
  if (!isIP(value)) throw new StatementError(`${key}=${value} is no IP address in numbers`, 422);
  if (/^[0:.]+$/.test(value)) throw new StatementError(`${key}=${value} cannot be sent to`, 422);
  return value;
}

function conversion(value, key) {
  if (value === 'no' || value === 'yes') return value;
  const cost = readNumber(value) ?? fail(key, value, 'yes, no or the largest cost');
  return cost === 0 ? 'no' : cost === anyCost ? 'yes' : String(cost);
}

function providers(value, key) {
  if (value === '') return value;
  const items = value.split(',');
  for (const item of items) {
    if (!/^[^/]+(\/[^/]+)?$/.test(item)) fail(key, value, 'PARTICIPANT[/PEER], or several with commas');
    for (const one of item.split('/')) text(limits.maxName)(one, key);
  }
  if (items.length > limits.maxProviders) {
    throw new StatementError(`${key} is too long: at most ${limits.maxProviders} providers`, 413);
  }
  return value;
}

function protocols(value, key) {
  if (value === '') return value;
  const words = value.split(',');
  if (words.includes('')) fail(key, value, 'a word such as udp, or several with commas');
  for (const one of words) text(limits.maxProtocol)(one, key);
  if (words.length > limits.maxProtocols) {
    throw new StatementError(`${key} is too long: at most ${limits.maxProtocols} words`, 413);
  }
  return value;
}

/** The readers of values, by key. `protocol` of a `pub` is one word: `protocol:pub`. */
export const readers = Object.freeze({
  mode: oneOf(modes),
  id,
  text: name(limits.maxText, 'a text that is not empty'),
  concept: name(limits.maxConcept, 'a name that is not empty'),
  representation: text(limits.maxConcept),
  port,
  address,
  protocol: protocols,
  'protocol:pub': text(limits.maxProtocol),
  priority,
  scope: text(limits.maxScope),
  for: text(limits.maxCondition),
  match: oneOf(degrees),
  provider: providers,
  favour: providers,
  where: text(limits.maxCondition),
  prefer: text(limits.maxPrefer),
  rank: text(limits.maxRank),
  convert: conversion,
  on: text(limits.maxConcept),
  reach: oneOf(reaches),
  limit: number,
});
