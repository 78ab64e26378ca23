// Frames over UDP that came before the daemon told of whom they are (src/client/CHANNELS.md, "Early frames").
import { earlyPatience, maxEarlyFrames, maxEarlyOctets } from './limits.js';

/** The oldest goes where one more comes. Places are those of `place`; time is milliseconds that never go back. */
export class EarlyFrames {
  #kept = [];
  #octets = 0;

  put(place, frame, now) {
    this.#forgetOld(now);
    const size = frame.payload.length;
    if (size > maxEarlyOctets) return;
    while (this.#kept.length >= maxEarlyFrames || this.#octets + size > maxEarlyOctets) this.#forgetFirst();
    // Its own octets: what came in may be a part of something larger.
    this.#kept.push({ place, frame: { ...frame, payload: Buffer.from(frame.payload) }, until: now + earlyPatience });
    this.#octets += size;
  }

  /** What is there of this life from there, in the order in which it came. */
  take(place, life, now) {
    this.#forgetOld(now);
    const isTaken = (one) => one.place === place && one.frame.life === life;
    const taken = this.#kept.filter(isTaken).map(({ frame }) => frame);
    if (taken.length === 0) return taken;
    this.#kept = this.#kept.filter((one) => !isTaken(one));
    for (const { payload } of taken) this.#octets -= payload.length;
    return taken;
  }

  #forgetOld(now) {
    while (this.#kept.length > 0 && this.#kept[0].until <= now) this.#forgetFirst();
  }

  #forgetFirst() {
    this.#octets -= this.#kept.shift().frame.payload.length;
  }
}
