// A UDP port that is bound at once, for both families if the host has both.
import { createSocket } from 'node:dgram';
import { isIPv6 } from 'node:net';

import { canonicalAddress } from '../protocol/address.js';
import { PortError } from '../protocol/errors.js';
import * as limits from '../protocol/limits.js';

// Addresses are numeric, so this look-up lets bind() and send() work at once.
const lookup = (address, family, callback) => callback(null, address, family);
const bufferSize = 1024 * 1024;

/**
 * A socket that is bound when this returns. `isShared` lets several sockets have the port; `isDual` lets an IPv6 socket use
 * IPv4, too. Throws the system's error.
 */
function bound(io, address, port, { isShared = false, isDual = false } = {}) {
  const isSix = isIPv6(address);
  const socket = createSocket({
    type: isSix ? 'udp6' : 'udp4',
    lookup,
    reuseAddr: isShared,
    ipv6Only: isSix && !isDual,
    recvBufferSize: bufferSize,
    sendBufferSize: bufferSize,
  });
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

// The codes for an address that is not the host's, or a family that it does not speak.
const absences = new Set(['EADDRNOTAVAIL', 'EAFNOSUPPORT', 'EPROTONOSUPPORT']);

/** The socket of one address; undefined if the host has no such address. Throws the system's error. */
function boundIfThere(io, address, port, how) {
  try {
    return bound(io, address, port, how);
  } catch (error) {
    if (absences.has(error.code)) return undefined;
    throw error;
  }
}

/** Sockets of both families with one port. Throws the system's error. */
function boundToAll(io, port) {
  for (let tries = 16; ; --tries) {
    const four = boundIfThere(io, '0.0.0.0', port);
    try {
      const six = boundIfThere(io, '::', four?.address().port ?? port);
      return [four, six].filter(Boolean);
    } catch (error) {
      // The port that the system gave to IPv4 is taken for IPv6.
      four?.close();
      if (port !== 0 || tries === 0 || error.code !== 'EADDRINUSE') throw error;
    }
  }
}

/** Sends from one port, and counts the datagrams that are left out. */
export class DatagramPort {
  #four;
  #six;
  #isOne;
  /** Datagrams that were left out, and that the system did not take. */
  leftOut = 0;

  /**
   * Opens `port` (0: any) of `address`, or of all addresses of both families. An address that is not this host's is accepted,
   * because the user knows how the host is reached. `isOne`: one socket for both families, which needs half the descriptors
   * but makes sending over IPv4 slower. Throws PortError.
   */
  static open(io, { address, port = 0, isShared = false, isOne = false }) {
    try {
      const one = isOne
        ? boundIfThere(io, '::', port, { isDual: true })
        : address && boundIfThere(io, address, port, { isShared });
      const sockets = one ? [one] : boundToAll(io, port);
      if (sockets.length === 0) throw new Error('the host speaks neither IPv4 nor IPv6');
      return new DatagramPort(sockets, isOne && one !== undefined);
    } catch (error) {
      throw new PortError(port, error);
    }
  }

  constructor(sockets, isOne = false) {
    this.#isOne = isOne;
    for (const socket of sockets) {
      if (socket.address().family === 'IPv6') this.#six = socket;
      else this.#four = socket;
      socket.on('error', () => ++this.leftOut);
    }
  }

  get sockets() {
    return [this.#four, this.#six].filter(Boolean);
  }

  get port() {
    return (this.#four ?? this.#six).address().port;
  }

  /** Calls a function with the octets, the canonical address and the port of each datagram. */
  listen(callback) {
    const spelling = new Map();
    const onMessage = (octets, { address, port }) => {
      let known = spelling.get(address);
      if (known === undefined) {
        // Most datagrams come from a few addresses.
        if (spelling.size >= 256) spelling.clear();
        known = canonicalAddress(address);
        spelling.set(address, known);
      }
      callback(octets, known, port);
    };
    for (const socket of this.sockets) socket.on('message', onMessage);
  }

  /** Sends to a canonical address. False if many datagrams wait in the system. */
  send(octets, address, port) {
    const socket = this.#of(address);
    const waiting = socket?.getSendQueueSize() ?? Infinity;
    if (waiting + octets.length > limits.maxWaitingDatagrams) ++this.leftOut;
    else socket.send(octets, port, this.#isOne && !address.includes(':') ? `::ffff:${address}` : address);
    return waiting < limits.enoughWaiting || !socket;
  }

  get waiting() {
    return this.sockets.reduce((sum, socket) => sum + socket.getSendQueueSize(), 0);
  }

  /** Sends a last datagram to each target, and closes when the system has taken all of them. */
  async end(octets, targets) {
    await Promise.all(targets.map(({ address, port }) => new Promise((resolve) => {
      const socket = this.#of(address);
      if (socket) socket.send(octets, port, this.#isOne && !address.includes(':') ? `::ffff:${address}` : address, resolve);
      else resolve();
    })));
    this.close();
  }

  close() {
    for (const socket of this.sockets) socket.close();
  }

  #of(address) {
    return this.#isOne || address.includes(':') ? this.#six : this.#four;
  }
}
