// Addresses as they are compared: one spelling each, IPv4 in IPv6 as IPv4, link-local ones with their zone.
import { isIPv4, isIPv6, SocketAddress } from 'node:net';

/** The one spelling of a numeric address, or undefined. */
export function canonicalAddress(text) {
  if (isIPv4(text)) return text;
  if (!isIPv6(text ?? '')) return undefined;
  const [plain, zone] = text.split('%');
  const { address } = new SocketAddress({ address: plain, family: 'ipv6' });
  const mapped = /^::ffff:([0-9.]+)$/i.exec(address);
  if (mapped) return mapped[1];
  return zone === undefined ? address : `${address}%${zone}`;
}

/** Whether a canonical address is that of a group. */
export const isMulticast = (address) =>
  address !== undefined && (isIPv4(address) ? /^2(2[4-9]|3[0-9])\./.test(address) : /^ff/i.test(address));

/** Whether a canonical address is an IPv6 group of a link, or of an interface, that does not say of which one. */
export const isOfSomeLink = (address) => /^ff.[12]:[^%]*$/i.test(address);

/** Address and port as one word. */
export const place = (address, port) => `${address} ${port}`;
