// Addresses in one spelling, so that they can be compared: mapped IPv4 addresses as IPv4, link-local ones with their zone.
import { isIPv4, isIPv6, SocketAddress } from 'node:net';

/** The canonical spelling of a numeric address; undefined for another text. */
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

/** Whether a canonical address is a link-local or interface-local IPv6 group without a zone. */
export const isOfSomeLink = (address) => /^ff.[12]:[^%]*$/i.test(address);

/** Address and port as one word. */
export const place = (address, port) => `${address} ${port}`;
