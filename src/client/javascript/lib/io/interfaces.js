// The interfaces on which a group is spoken and heard.
import { networkInterfaces } from 'node:os';

import { maxInterfaces } from '../core/limits.js';

/** What dgram takes as an interface of this family: IPv4 addresses, or `::%NAME`; one each, the loopback's last. */
export function interfacesOf(isSix) {
  const found = [];
  for (const [name, addresses] of Object.entries(networkInterfaces())) {
    const one = addresses.find(({ family }) => family === (isSix ? 'IPv6' : 'IPv4') || family === (isSix ? 6 : 4));
    if (one) found.push({ name: isSix ? `::%${name}` : one.address, isLoopback: one.internal });
  }
  return found.sort((a, b) => Number(a.isLoopback) - Number(b.isLoopback)).slice(0, maxInterfaces + 1);
}
