// A node on real sockets of the loopback interface, with a daemon that says what the test tells it to, and a clock that stands still.
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { connect as dial } from 'node:net';

import { FrameReader } from '../../../src/client/javascript/lib/protocol/frame_reader.js';
import { encodeFrame, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { connect, limits } from '../../../src/client/javascript/lib/index.js';
import { ManualClock, ScriptedDaemon } from './support.mjs';

export const life = '00000000000000aa';
export const ours = 0xaan;
export const message = (sequence, text = 'x') => encodeFrame(kinds.message, ours, BigInt(sequence), Buffer.from(text));

/** A node with its daemon and clock; all is closed after the test. */
export async function lab(t) {
  const daemon = await new ScriptedDaemon().listen();
  const clock = new ManualClock();
  const node = await connect({ name: 'me', daemon: daemon.endpoint, clock, random: () => 0 });
  const lab = { daemon, clock, node };
  t.after(async () => {
    await node.close();
    await lab.daemon.kill();
  });
  return lab;
}

export const added = (id, port, { protocol = 'udp', mode = 'oto', channel = life, change = 'add' } = {}) =>
  `${id} pub ${change} service=0000000b/1/1 provider=0000000b/1 text=x degree=exact distance=0 mode=${mode} address=127.0.0.1 ` +
  `port=${port} protocol=${protocol} priority=0${channel ? ` channel=${channel}` : ''}`;
export const consumer = (id, port, channel = life, mode = 'oto') =>
  `${id} sub add subscription=0000000b/1/${port} consumer=0000000b/1 text=x degree=exact distance=0 mode=${mode} ` +
  `address=127.0.0.1 port=${port} priority=0${channel ? ` channel=${channel}` : ''}`;

export async function datagramSocket(t) {
  const socket = createSocket('udp4');
  t.after(() => socket.close());
  socket.bind(0, '127.0.0.1');
  await once(socket, 'listening');
  return socket;
}

export const sendTo = (socket, octets, port) => new Promise((resolve) => socket.send(octets, port, '127.0.0.1', resolve));

/** A socket that has connected, whose frames are kept. */
export async function consumerSocket(t, port, hello) {
  const socket = dial(port, '127.0.0.1');
  socket.on('error', () => {});
  t.after(() => socket.destroy());
  await once(socket, 'connect');
  const decoder = new FrameReader(limits.maxStreamMessage);
  socket.frames = [];
  socket.on('data', (octets) => {
    decoder.push(octets);
    for (let frame = decoder.next(); frame; frame = decoder.next()) socket.frames.push(frame);
  });
  if (hello) socket.write(encodeFrame(kinds.hello, hello, 0n));
  return socket;
}
