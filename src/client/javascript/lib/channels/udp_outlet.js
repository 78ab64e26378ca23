// The outlet of `oto` and `otm/pubsub` over UDP: it sends to each consumer that the daemon has named.
import { canonicalAddress } from '../protocol/address.js';
import { PortError } from '../protocol/errors.js';
import { headerSize } from '../protocol/frame.js';
import { DatagramPort } from './datagram_port.js';

/**
 * With `isLazy` the socket is open only while there are consumers. Hooks: `onMoved(port)`, the port had to change;
 * `onProblem(error)`, no socket can be opened, so a consumer is not sent to.
 */
export class UdpOutlet {
  #io;
  #options;
  #isLazy;
  #hooks;
  #out;
  #targets = new Map();
  #leftOut = 0;
  port;

  constructor(io, { address, port, isLazy, hooks }) {
    this.#io = io;
    this.#options = { address };
    this.#isLazy = isLazy;
    this.#hooks = hooks;
    this.port = port ?? 0;
  }

  /** Throws PortError. */
  async open() {
    this.#open();
    if (this.#isLazy) this.#close();
  }

  get hasConsumer() {
    return this.#targets.size > 0;
  }

  get leftOut() {
    return this.#leftOut + (this.#out?.leftOut ?? 0);
  }

  get waiting() {
    return this.#out?.waiting ?? 0;
  }

  get dropped() {
    return 0;
  }

  /**
   * Adds a consumer, or changes its address. One without address and port is not sent to; one without a life gets payloads
   * without frames.
   */
  set(key, { address, port }, isPlain) {
    const canonical = canonicalAddress(address);
    if (canonical === undefined || port === undefined) {
      this.delete(key);
      return;
    }
    if (!this.#out && !this.#reopen()) return;
    this.#targets.set(key, { address: canonical, port, isPlain });
  }

  delete(key) {
    this.#targets.delete(key);
    if (this.#targets.size === 0 && this.#isLazy && this.#out) this.#close();
  }

  send(octets) {
    let isPrompt = true;
    for (const { address, port, isPlain } of this.#targets.values()) {
      isPrompt = this.#out.send(isPlain ? octets.subarray(headerSize) : octets, address, port) && isPrompt;
    }
    return isPrompt;
  }

  async end(octets) {
    const targets = [...this.#targets.values()].filter(({ isPlain }) => !isPlain);
    this.#targets.clear();
    const out = this.#out;
    this.#out = undefined;
    await out?.end(octets, targets);
  }

  #open() {
    this.#out = DatagramPort.open(this.#io, { ...this.#options, port: this.port });
    this.port = this.#out.port;
  }

  #reopen() {
    const stated = this.port;
    for (const port of [stated, 0]) {
      try {
        this.port = port;
        this.#open();
        if (this.port !== stated) this.#hooks.onMoved(this.port);
        return true;
      } catch (error) {
        if (!(error instanceof PortError)) throw error;
        this.port = stated;
        if (port === 0) this.#hooks.onProblem(error);
      }
    }
    return false;
  }

  #close() {
    this.#leftOut += this.#out.leftOut;
    this.#out.close();
    this.#out = undefined;
  }
}
