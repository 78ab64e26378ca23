// The reception of a publisher over UDP: hellos are answered by floors and fulls.
import { kinds } from '../protocol/frame.js';
import { Allowance, Cookies, readHandshake, writeHandshake } from '../protocol/handshake.js';
import { anyFrameOfDatagram } from '../protocol/sealed_frame.js';

/** The counter of a frame, 0n of a plain one. */
export const counterOf = ({ counter }) => counter ?? 0n;

/**
 * Hooks: `onHello(from, frame, said)` and `onEnd(from, frame)`, for frames with a hello's payload that have the publisher's life.
 * `from` is `{address, port}`, `said` a handshake.
 */
export class Reception {
  #clock;
  #frames;
  #hooks;
  #isHelloPort;
  #cookies = new Cookies();
  #allowance;
  #out;
  /** Datagrams that were not believed. */
  dropped = 0;

  constructor(io, frames, hooks, isHelloPort = false) {
    this.#clock = io.clock;
    this.#frames = frames;
    this.#hooks = hooks;
    this.#isHelloPort = isHelloPort;
    this.#allowance = new Allowance(io.clock.now());
  }

  /** Reads this port from now on, as long as it is open. */
  read(out) {
    this.#out = out;
    out.listen((octets, address, port) => {
      if (out === this.#out) this.#heard(octets, { address, port });
    });
  }

  /** Reads no more. */
  rest() {
    this.#out = undefined;
  }

  /** Whether a hello gives back a cookie that was made for it. */
  hasCookie({ address, port }, { life }, { challenge, cookie }) {
    return this.#cookies.isRight(address, port, life, challenge, cookie, this.#clock.now());
  }

  /** Answers a hello by a cookie. */
  ask(from, { life }, { challenge }) {
    this.#answer(kinds.floor, from, life, challenge, this.#cookies.cookie(from.address, from.port, life, challenge, this.#clock.now()));
  }

  /** Answers a hello that was accepted. Half of the answers are for those that are not known yet. */
  accept(from, { life }, { challenge }, isKnown) {
    this.#answer(kinds.floor, from, life, challenge, 0n, isKnown);
  }

  /** Says that there is no place. */
  refuse(from, { life }, { challenge }) {
    this.#answer(kinds.full, from, life, challenge, 0n);
  }

  /** Sends a floor to a consumer that was accepted, which has not asked for one. */
  floor(to, life, challenge) {
    this.#send(kinds.floor, to, life, challenge, 0n);
  }

  #answer(kind, to, life, challenge, cookie, isKnown = false) {
    if (this.#allowance.take(this.#clock.now(), isKnown)) this.#send(kind, to, life, challenge, cookie);
  }

  #send(kind, { address, port }, life, challenge, cookie) {
    this.#out?.send(this.#frames.other(kind, writeHandshake(life, challenge, cookie), this.#isHelloPort), address, port);
  }

  #heard(octets, from) {
    const read = anyFrameOfDatagram(octets);
    const frame = read && this.#frames.take(read);
    const said = frame && readHandshake(frame.payload);
    if (said?.life !== this.#frames.life || from.address === undefined) ++this.dropped;
    else if (frame.kind === kinds.hello && said.challenge !== 0n) this.#hooks.onHello(from, frame, said);
    else if (frame.kind === kinds.end) this.#hooks.onEnd(from, frame);
    else ++this.dropped;
  }
}
