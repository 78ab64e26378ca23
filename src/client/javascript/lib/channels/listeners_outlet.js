// The outlet of `otm/stream` over UDP to a unicast address: it sends to each listener that has shown by a cookie to receive there.
import { maxListeners } from '../protocol/limits.js';
import { Listeners } from '../protocol/listeners.js';
import { DatagramPort } from './datagram_port.js';
import { counterOf, Reception } from './reception.js';

/** Hooks: `onNoPlace(what, count)`, a newcomer found all places taken; `onPlaces()`, enough are free again, which may be told again. */
export class ListenersOutlet {
  #io;
  #frames;
  #options;
  #hooks;
  #listeners = new Listeners();
  #reception;
  #out;

  constructor(io, frames, { address, port, hooks }) {
    this.#io = io;
    this.#frames = frames;
    this.#options = { address, port: port ?? 0 };
    this.#hooks = hooks;
    this.#reception = new Reception(io, frames, {
      onHello: (from, frame, said) => this.#onHello(from, frame, said),
      onEnd: (from, frame) => this.#onEnd(from, frame),
    });
  }

  get port() {
    return this.#options.port;
  }

  async open() {
    this.#out = DatagramPort.open(this.#io, this.#options);
    this.#options.port = this.#out.port;
    this.#reception.read(this.#out);
  }

  get hasConsumer() {
    return this.#listeners.size > 0 && this.#frames.keys !== undefined;
  }

  get leftOut() {
    return this.#out?.leftOut ?? 0;
  }

  get waiting() {
    return this.#out?.waiting ?? 0;
  }

  /** Datagrams that were no hello to this publisher. */
  get dropped() {
    return this.#reception.dropped;
  }

  set() {}
  delete() {}

  /** Other keys are in force, or another mode. Listeners that said no sealed hello are forgotten after their time where that is needed. */
  rekey(beginsToSeal) {
    if (!this.#frames.hasRing) for (const one of this.#listeners.values()) one.counter = 0n; // nobody has keys any more
    if (!beginsToSeal) return;
    for (const one of this.#listeners.values()) this.#reception.floor(one, one.life, one.challenge);
  }

  send(octets) {
    this.#expire();
    let isPrompt = true;
    for (const { address, port } of this.#listeners.values()) isPrompt = this.#out.send(octets, address, port) && isPrompt;
    return isPrompt;
  }

  async end() {
    const out = this.#out;
    const octets = this.hasConsumer ? this.#frames.end() : undefined;
    const targets = octets ? [...this.#listeners.values()] : [];
    this.#out = undefined;
    this.#reception.rest();
    await out?.end(octets, targets);
  }

  #expire() {
    this.#listeners.expire(this.#io.clock.now());
    this.#look();
  }

  #look() {
    if (this.#listeners.places.hasRoomAgain) this.#hooks.onPlaces();
  }

  #onHello(from, frame, said) {
    const heard = this.#io.clock.now();
    const counter = counterOf(frame);
    let known = this.#listeners.get(from.address, from.port);
    if (known?.life === frame.life && known.counter > 0n && counter <= known.counter) {
      ++this.#reception.dropped; // a recording, or a plain hello, which anybody may have said
      return;
    }
    // A seal is shown to be no recording by a cookie. The port may also belong to another subscriber by now.
    if (known && (known.counter === 0n) !== (counter === 0n)) known = undefined;
    if (known && known.life !== frame.life && counter > 0n) known = undefined;
    if (known) {
      Object.assign(known, { life: frame.life, challenge: said.challenge, heard, counter });
    } else if (!this.#reception.hasCookie(from, frame, said)) {
      this.#reception.ask(from, frame, said);
      return;
    } else if (!this.#admit({ ...from, life: frame.life, challenge: said.challenge, heard, counter })) {
      this.#reception.refuse(from, frame, said);
      return;
    }
    this.#reception.accept(from, frame, said, known !== undefined);
  }

  #admit(listener) {
    this.#expire();
    const { isTaken, loser } = this.#listeners.add(listener);
    if (!isTaken || loser) this.#hooks.onNoPlace('listeners', maxListeners);
    if (loser) this.#reception.refuse(loser, loser, loser);
    return isTaken;
  }

  #onEnd(from, frame) {
    const known = this.#listeners.get(from.address, from.port);
    const counter = counterOf(frame);
    if (!known || (known.counter > 0n && (known.life !== frame.life || counter <= known.counter))) {
      ++this.#reception.dropped;
      return;
    }
    this.#listeners.end(known);
    this.#look();
  }
}
