// Endpoints of daemons: `ADDRESS:PORT`, `[ADDRESS]:PORT`, `/PATH` or `unix:PATH`.
import { isIPv6 } from 'node:net';

import { readNumber } from '../protocol/key.js';

/** The endpoint of a text, as net.connect takes it. Throws TypeError. */
export function endpointOf(text) {
  if (text.startsWith('unix:') || text.startsWith('/')) {
    const path = text.replace(/^unix:/, '');
    if (path !== '' && !path.includes('\0')) return { path };
  }
  const [, address, port] = /^(.+):([0-9]+)$/.exec(text) ?? [];
  const host = address?.replace(/^\[(.*)\]$/, '$1');
  const number = readNumber(port ?? '', 65535);
  if (host && number && (!host.includes(':') || (address.startsWith('[') && isIPv6(host)))) return { host, port: number };
  throw new TypeError(`no endpoint: '${text}'; write ADDRESS:PORT, [ADDRESS]:PORT, /PATH or unix:PATH`);
}

/** An endpoint as people write it. */
export const endpointText = ({ path, host, port }) => path ?? `${host.includes(':') ? `[${host}]` : host}:${port}`;

/** The endpoints to try: that of the text, or of GEMINGA_CONNECT, or the usual ones of gemingad. */
export function endpointsOf(text = process.env.GEMINGA_CONNECT) {
  if (text) return [endpointOf(text)];
  return [{ host: '127.0.0.1', port: 4717 }, { host: '::1', port: 4717 }];
}
