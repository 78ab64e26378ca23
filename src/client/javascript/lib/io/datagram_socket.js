// UDP sockets that are bound at once, for both families where the host has both.
import { createSocket } from 'node:dgram';
import { isIPv6 } from 'node:net';

import { canonicalAddress } from '../core/address.js';
import { PortError } from '../core/errors.js';

// Addresses are numbers here: looking them up at once lets bind() and send() work at once.
const lookup = (address, family, callback) => callback(null, address, family);
const bufferSize = 1024 * 1024;

function bound(io, type, { address, port, isShared }) {
  const socket = createSocket({ type, lookup, reuseAddr: isShared, recvBufferSize: bufferSize, sendBufferSize: bufferSize });
  let failure;
  const onError = (error) => {
    failure = error;
  };
  socket.on('error', onError);
  socket.bind({ port, address, exclusive: true });
  if (failure) {
    socket.close();
    throw failure;
  }
  socket.off('error', onError);
  return io.add(socket);
}

const isTaken = ({ code }) => code === 'EADDRINUSE' || code === 'EACCES';

/**
 * A socket at `port` (0: any) of `address`, or of all addresses of both families. An address that is not this host's is
 * taken as said by somebody who knows how it is reached. `isShared` lets several sockets have the port. Throws PortError.
 */
export function openDatagramSocket(io, { address, port = 0, isShared = false }) {
  const tries = [];
  if (address !== undefined) tries.push([isIPv6(address) ? 'udp6' : 'udp4', address]);
  tries.push(['udp6', '::'], ['udp4', '0.0.0.0']);
  let failure;
  for (const [type, where] of tries) {
    try {
      return bound(io, type, { address: where, port, isShared });
    } catch (error) {
      failure = error;
      if (isTaken(error)) break;
    }
  }
  throw new PortError(port, failure);
}

/** 'udp4' or 'udp6' of a socket. */
export const familyOf = (socket) => (socket.address().family === 'IPv6' ? 'udp6' : 'udp4');

/** The canonical spelling of the addresses that datagrams come from, remembered: most come from a few. */
export class Spelling {
  #known = new Map();

  of(address) {
    let known = this.#known.get(address);
    if (known === undefined) {
      if (this.#known.size >= 256) this.#known.clear();
      known = canonicalAddress(address);
      this.#known.set(address, known);
    }
    return known;
  }
}
