// The outlet of `otm/stream` over UDP to a unicast address: it sends to each listener that says hello.
import { frameOfDatagram, kinds } from '../protocol/frame.js';
import { lifeOctets } from '../protocol/life.js';
import { Listeners } from '../protocol/listeners.js';
import { DatagramPort } from './datagram_port.js';

export class ListenersOutlet {
  #io;
  #options;
  #life;
  #listeners = new Listeners();
  #out;
  /** Datagrams that were no hello to this publisher, and hellos for which there was no room. */
  dropped = 0;

  constructor(io, { address, port, life }) {
    this.#io = io;
    this.#options = { address, port: port ?? 0 };
    this.#life = lifeOctets(life);
  }

  get port() {
    return this.#options.port;
  }

  async open() {
    this.#out = DatagramPort.open(this.#io, this.#options);
    this.#options.port = this.#out.port;
    this.#out.listen((octets, address, port) => this.#onDatagram(octets, address, port));
  }

  get hasConsumer() {
    return this.#listeners.size > 0;
  }

  get leftOut() {
    return this.#out?.leftOut ?? 0;
  }

  get waiting() {
    return this.#out?.waiting ?? 0;
  }

  set() {}
  delete() {}

  send(octets) {
    this.#listeners.expire(this.#io.clock.now());
    let isPrompt = true;
    for (const { address, port } of this.#listeners.values()) isPrompt = this.#out.send(octets, address, port) && isPrompt;
    return isPrompt;
  }

  async end(octets) {
    const out = this.#out;
    this.#out = undefined;
    await out?.end(octets, [...this.#listeners.values()]);
  }
  #onDatagram(octets, address, port) {
    const frame = frameOfDatagram(octets);
    if (!frame || frame.kind === kinds.message || !this.#life.equals(frame.payload)) {
      ++this.dropped;
    } else if (frame.kind === kinds.end) {
      this.#listeners.end(address, port);
    } else if (!this.#listeners.hello(address, port, this.#io.clock.now())) {
      ++this.dropped;
    }
  }
}
