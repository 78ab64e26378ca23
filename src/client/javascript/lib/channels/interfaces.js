// The interfaces on which a group is spoken and heard.
import { networkInterfaces } from 'node:os';

import { maxInterfaces } from '../protocol/limits.js';

/**
 * What dgram takes as an interface of this family, IPv4 addresses or `::%NAME`: every interface that is up and no loopback,
 * or the loopback where there is no other.
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
