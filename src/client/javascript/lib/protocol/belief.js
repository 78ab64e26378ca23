// The belief of a subscriber in one provider: its keys, the challenge, the floor, and the hellos until it is accepted.
import { kinds } from './frame.js';
import { readHandshake, writeHandshake } from './handshake.js';
import { newLife } from './life.js';
import { firstHello, helloInterval } from './limits.js';

/** The outcomes of `answered`. */
export const outcomes = Object.freeze({ forged: 'forged', heard: 'heard', again: 'again', full: 'full' });

export class Belief {
  #ownLife;
  #life;
  #keys;
  #hasTakenSealed = false;
  #challenge;
  #cookie;
  #floor;
  #isFloorSealed;
  #hellos;
  /** Whether the provider has accepted the last hello. */
  isAccepted;
  /** Whether the application was told that the provider has no place. */
  hasToldFull = false;

  /** `ownLife` is the subscriber's, `life` the provider's. */
  constructor(ownLife, life, keys) {
    this.#ownLife = ownLife;
    this.#life = life;
    this.#keys = keys;
    this.greet();
  }

  /** The keys of the provider's life; undefined where there are some that cannot be used. */
  get keys() {
    return this.#keys;
  }

  /** Whether hello is said on every channel. */
  get hasRing() {
    return this.#keys?.hasRing ?? false;
  }

  /** Other keys are in force, or another mode. */
  rekey(keys) {
    this.#keys = keys;
    if (!this.hasRing) this.#hasTakenSealed = false;
  }

  /** Begins the handshake anew: draws another challenge, and forgets the floor. */
  greet() {
    this.#challenge = newLife();
    this.#cookie = 0n;
    this.#floor = undefined;
    this.#isFloorSealed = false;
    this.#hellos = 0;
    this.isAccepted = false;
  }

  /** The payload of a hello, or of the end by which a listener leaves. */
  hello() {
    return writeHandshake(this.#life, this.#challenge, this.#cookie);
  }

  /** The milliseconds until the hello after this one: 20, 40, 80, ... 640, then 1000. */
  wait() {
    const wait = this.isAccepted ? helloInterval : firstHello * 2 ** this.#hellos;
    if (wait >= helloInterval) return helloInterval;
    ++this.#hellos;
    return wait;
  }

  /** A frame of the provider as this host takes it, opened; undefined if it does not. */
  take(frame) {
    const taken = this.#keys?.takeForward(frame);
    if (taken?.isSealed) this.#hasTakenSealed = true;
    else if (this.#hasTakenSealed) return undefined;
    return taken;
  }

  /** Whether a frame may be opened by a key that the daemon has not told yet. */
  isAhead(frame) {
    return frame.form !== undefined && this.hasRing && !this.#keys.hasKeyOf(frame);
  }

  /** Takes a floor or a full. After `outcomes.again`, say hello at once. */
  answered({ kind, payload, sequence, isSealed = false }) {
    const said = readHandshake(payload);
    if (!said || said.life !== this.#ownLife || said.challenge !== this.#challenge) return outcomes.forged;
    if (kind === kinds.full) {
      this.isAccepted = false;
      return outcomes.full;
    }
    if (this.#floor === undefined || (isSealed && !this.#isFloorSealed)) {
      this.#floor = sequence;
      this.#isFloorSealed = isSealed;
    }
    if (said.cookie === 0n) {
      this.isAccepted = true;
      this.hasToldFull = false;
      this.#hellos = 0;
      return outcomes.heard;
    }
    this.isAccepted = false;
    if (said.cookie === this.#cookie) return outcomes.heard; // it is being considered: the next hello has its time
    this.#cookie = said.cookie;
    return outcomes.again;
  }

  /** The sequence above which sealed messages are believed; undefined if no floor has come that this mode believes. */
  get floor() {
    return this.#isFloorSealed || this.#keys?.takesPlain ? this.#floor : undefined;
  }
  /**
   * Whether a message or an end is believed, as far as the floor says: false for a sealed message that was sent before the floor,
   * undefined for a sealed frame where no floor has come yet.
   */
  isBehindFloor({ kind, sequence, isSealed }) {
    if (!isSealed) return true;
    const { floor } = this;
    if (floor === undefined) return undefined;
    return kind !== kinds.message || sequence > floor;
  }
}
