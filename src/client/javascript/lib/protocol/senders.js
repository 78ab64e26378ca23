// The addresses and ports from which datagrams are believed, each with the channels whose lives are expected there.
import { kinds } from './frame.js';
import { anyFrameOfDatagram } from './sealed_frame.js';

/** The frame of any form that a datagram is, if a provider sends such frames; else undefined. It has not been opened. */
export function frameOfProvider(octets) {
  const frame = anyFrameOfDatagram(octets);
  if (!frame || frame.kind === kinds.hello) return undefined;
  return frame.kind === kinds.end && frame.payload.length > 0 ? undefined : frame;
}

export class Senders {
  #places = new Map();

  /** The channel of a life at this place. */
  find(place, life) {
    return this.#places.get(place)?.find((one) => one.life === life);
  }

  set(place, channel) {
    const there = this.#places.get(place);
    if (!there) this.#places.set(place, [channel]);
    else if (!there.includes(channel)) there.push(channel);
  }

  delete(place, channel) {
    const left = this.#places.get(place)?.filter((one) => one !== channel) ?? [];
    if (left.length > 0) this.#places.set(place, left);
    else this.#places.delete(place);
  }

  /**
   * The channel of a datagram from this place, which is this frame or none: `{channel, frame}`. A channel whose life is 0n takes
   * any datagram as a message. Undefined if the datagram is not believed.
   */
  take(place, octets, frame = frameOfProvider(octets)) {
    const there = this.#places.get(place);
    if (!there) return undefined;
    if (frame) {
      const channel = there.find(({ life }) => life === frame.life);
      if (channel) return { channel, frame };
    }
    const plain = there.find(({ life }) => life === 0n);
    return plain && { channel: plain, frame: { kind: kinds.message, life: 0n, sequence: 0n, payload: octets } };
  }
}
