// The addresses and ports from which datagrams are believed, each with the channels whose lives are expected there.
import { frameOfDatagram, kinds } from './frame.js';

/** The frame that a datagram is, if a provider sends such frames; else undefined. */
export function frameOfProvider(octets) {
  const frame = frameOfDatagram(octets);
  const isOne = frame && (frame.kind === kinds.message || (frame.kind === kinds.end && frame.payload.length === 0));
  return isOne ? frame : undefined;
}

export class Places {
  #places = new Map();

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
   * The channel of a datagram from this place: `{channel, frame}`. A channel whose life is 0n takes any datagram as a message.
   * Undefined if the datagram is not believed.
   */
  take(place, octets) {
    const there = this.#places.get(place);
    if (!there) return undefined;
    const frame = frameOfProvider(octets);
    if (frame) {
      const channel = there.find(({ life }) => life === frame.life);
      if (channel) return { channel, frame };
    }
    const plain = there.find(({ life }) => life === 0n);
    return plain && { channel: plain, frame: { kind: kinds.message, life: 0n, sequence: 0n, payload: octets } };
  }
}
