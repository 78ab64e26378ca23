// The interfaces that multicasts use.
import { networkInterfaces } from 'node:os';

import { maxInterfaces } from '../protocol/limits.js';

/**
 * The interfaces in the form that dgram takes, IPv4 addresses or `::%NAME`: all that are up and no loopback, or the loopback if
 * there is no other.
 */
export function groupInterfaces(isSix, interfaces = networkInterfaces()) {
  const found = [];
  for (const [name, addresses] of Object.entries(interfaces)) {
    const one = addresses.find(({ family }) => family === (isSix ? 'IPv6' : 'IPv4'));
    if (one) found.push({ name: isSix ? `::%${name}` : one.address, isLoopback: one.internal });
  }
  const others = found.filter(({ isLoopback }) => !isLoopback);
  return (others.length > 0 ? others : found).slice(0, maxInterfaces).map(({ name }) => name);
}
