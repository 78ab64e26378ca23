// Frames over UDP whose sender the daemon has not named yet, or whose floor has not come (src/client/CHANNELS.md, "Early frames").
import { earlyPatience, maxEarlyFrames, maxEarlyOctets } from './limits.js';
import { sealedFrameAt } from './sealed_frame.js';

/** A copy of a frame, because the payload may be a part of a larger buffer. */
const copied = (frame) =>
  (frame.octets ? sealedFrameAt(Buffer.from(frame.octets), 0) : { ...frame, payload: Buffer.from(frame.payload) });

/** For one more than the limit the oldest goes. Places are those of `place`, times are milliseconds that never go back. */
export class EarlyFrames {
  #kept = [];
  #octets = 0;

  put(place, frame, now) {
    this.#forgetOld(now);
    const size = frame.payload.length;
    if (size > maxEarlyOctets) return;
    while (this.#kept.length >= maxEarlyFrames || this.#octets + size > maxEarlyOctets) this.#forgetFirst();
    this.#kept.push({ place, frame: copied(frame), until: now + earlyPatience });
    this.#octets += size;
  }

  /** Removes the frames of this life from this place, and gives them in the order of arrival. */
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
