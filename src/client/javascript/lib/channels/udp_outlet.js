// The outlet of `oto` and `otm/pubsub` over UDP: it sends to each consumer that the daemon has named.
import { canonicalAddress } from '../protocol/address.js';
import { PortError } from '../protocol/errors.js';
import { lifeText } from '../protocol/life.js';
import * as limits from '../protocol/limits.js';
import { DatagramPort } from './datagram_port.js';
import { counterOf, Reception } from './reception.js';

/**
 * With `isLazy` the socket is open only while there are consumers. Where frames are sealed, messages go to those whose hello
 * was accepted. Hooks: `onCome(key)`, messages reach a consumer, which may be told again; `onMoved(port)`, the port had to change;
 * `onProblem(error)`, no socket can be opened, so a consumer is not sent to.
 */
export class UdpOutlet {
  #io;
  #frames;
  #options;
  #isLazy;
  #hooks;
  #out;
  #reception;
  /** By key: `{key, life, target, counter, challenge, source}`. `counter` is that of its last hello, 0n if it was plain. */
  #consumers = new Map();
  #targets = [];
  #leftOut = 0;
  #timers;
  /** The time that consumers have for a sealed hello. */
  #grace;
  port;

  constructor(io, frames, { address, port, isLazy, hooks }) {
    this.#io = io;
    this.#frames = frames;
    this.#timers = io.timers();
    this.#options = { address };
    this.#isLazy = isLazy;
    this.#hooks = hooks;
    this.#reception = new Reception(io, frames, {
      onHello: (from, frame, said) => this.#onHello(from, frame, said),
      onEnd: (from, frame) => this.#onEnd(frame),
    });
    this.port = port ?? 0;
  }

  /** Throws PortError. */
  async open() {
    this.#open();
    if (this.#isLazy) this.#close();
  }

  get hasConsumer() {
    return this.#targets.length > 0;
  }

  get leftOut() {
    return this.#leftOut + (this.#out?.leftOut ?? 0);
  }

  get waiting() {
    return this.#out?.waiting ?? 0;
  }

  get dropped() {
    return this.#reception.dropped;
  }

  /** Adds a consumer, or changes its address. One without address and port is not sent to; one without a life gets payloads. */
  set(key, { address, port }, life) {
    const canonical = canonicalAddress(address);
    if (canonical === undefined || port === undefined) {
      this.delete(key);
      return;
    }
    if (!this.#out && !this.#reopen()) return;
    const consumer = this.#consumers.get(key) ?? { key, life, counter: undefined };
    consumer.target = { address: canonical, port, isPlain: life === 0n };
    this.#consumers.set(key, consumer);
    this.#change();
  }

  delete(key) {
    this.#consumers.delete(key);
    this.#change();
    if (this.#consumers.size === 0 && this.#isLazy && this.#out) this.#close();
  }

  /** Other keys are in force, or another mode. Consumers that said no sealed hello have some time for it where that is needed. */
  rekey(beginsToSeal) {
    this.#timers.clear(this.#grace);
    // Without keys nobody is known by a seal.
    if (!this.#frames.hasRing) for (const consumer of this.#consumers.values()) consumer.counter = undefined;
    for (const { counter, source, life, challenge } of this.#consumers.values()) {
      if (beginsToSeal && counter !== undefined) this.#reception.floor(source, life, challenge);
    }
    if (this.#frames.keys && !this.#frames.takesPlain) this.#grace = this.#timers.after(limits.strangerPatience, () => this.#endPlain());
    this.#change();
  }

  send(octets, payload) {
    let isPrompt = true;
    for (const { address, port, isPlain } of this.#targets) {
      isPrompt = this.#out.send(isPlain ? payload : octets, address, port) && isPrompt;
    }
    return isPrompt;
  }

  async end() {
    const out = this.#out;
    const octets = this.hasConsumer ? this.#frames.end() : undefined;
    const targets = octets ? this.#targets.filter(({ isPlain }) => !isPlain) : [];
    this.#consumers.clear();
    this.#targets = [];
    this.#out = undefined;
    this.#reception.rest();
    this.#io.forget(this.#timers);
    await out?.end(octets, targets);
  }

  #endPlain() {
    for (const consumer of this.#consumers.values()) if (consumer.counter === 0n) consumer.counter = undefined;
    this.#change();
  }

  #reaches({ life, counter }) {
    if (!this.#frames.keys) return false;
    return life === 0n ? this.#frames.takesPlain : !this.#frames.seals || counter !== undefined;
  }

  #change() {
    const consumers = [...this.#consumers.values()];
    this.#targets = consumers.filter((one) => this.#reaches(one)).map(({ target }) => target);
    for (const one of consumers) if (this.#reaches(one)) this.#hooks.onCome(one.key);
  }

  #onHello(from, frame, said) {
    const consumer = this.#consumers.get(lifeText(frame.life));
    const counter = counterOf(frame);
    if (!this.#frames.hasRing) {
      ++this.#reception.dropped;
      return;
    }
    // Anybody may have said a plain hello where there was a sealed one; a sealed one behind a plain one may be a recording.
    if (consumer?.counter > 0n && counter <= consumer.counter) {
      ++this.#reception.dropped;
      return;
    }
    const isKnown = consumer?.counter !== undefined && (counter === 0n || consumer.counter > 0n);
    if (!isKnown && !this.#reception.hasCookie(from, frame, said)) {
      this.#reception.ask(from, frame, said);
      return;
    }
    // A hello that comes before its `sub add` is accepted when it is said again.
    if (!consumer) return;
    Object.assign(consumer, { counter, challenge: said.challenge, source: from });
    if (!isKnown) this.#change();
    this.#reception.accept(from, frame, said, isKnown);
  }

  /** A consumer says that it has ended, before its daemon does. Without a seal anybody could. */
  #onEnd(frame) {
    const consumer = this.#consumers.get(lifeText(frame.life));
    if (consumer?.counter === undefined || counterOf(frame) <= consumer.counter) {
      ++this.#reception.dropped;
      return;
    }
    consumer.counter = undefined;
    this.#change();
  }

  #open() {
    this.#out = DatagramPort.open(this.#io, { ...this.#options, port: this.port });
    this.#reception.read(this.#out);
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
    this.#reception.rest();
    this.#out.close();
    this.#out = undefined;
  }
}
