// A node on real sockets of the loopback interface, with a daemon that says what the test tells it to, and a clock that stands still.
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { connect as dial } from 'node:net';

import { FrameReader } from '../../../src/client/javascript/lib/protocol/frame_reader.js';
import { encodeFrame, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { plainKeys } from '../../../src/client/javascript/lib/protocol/channel_keys.js';
import { connect, limits } from '../../../src/client/javascript/lib/index.js';
import { readHandshake, writeHandshake } from '../../../src/client/javascript/lib/protocol/handshake.js';
import { anyFrameOfDatagram } from '../../../src/client/javascript/lib/protocol/sealed_frame.js';
import { ManualClock, ScriptedDaemon, until } from './support.mjs';

export const life = '00000000000000aa';
export const ours = 0xaan;
export const message = (sequence, text = 'x') => encodeFrame(kinds.message, ours, BigInt(sequence), Buffer.from(text));

/** A node with its daemon and clock; all is closed after the test. */
export async function lab(t, { sealing } = {}) {
  const daemon = await new ScriptedDaemon(sealing).listen();
  const clock = new ManualClock();
  const logged = [];
  const node = await connect({ name: 'me', daemon: daemon.endpoint, clock, random: () => 0, log: (line) => logged.push(line) });
  const lab = { daemon, clock, node, logged };
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

/** The hello of a consumer to a publisher. */
export const helloOf = (life, publisher, challenge = 1n, cookie = 0n) =>
  encodeFrame(kinds.hello, life, 0n, writeHandshake(publisher.life, challenge, cookie));

/** A socket that has connected and says hello to a publisher with this life, if there is one. Its frames are kept. */
export async function consumerSocket(t, publisher, life, localAddress = '127.0.0.1') {
  const socket = dial({ port: publisher.port, host: '127.0.0.1', localAddress });
  socket.on('error', () => {});
  t.after(() => socket.destroy());
  await once(socket, 'connect');
  const reader = new FrameReader(limits.maxStreamMessage);
  socket.frames = [];
  socket.on('data', (octets) => {
    reader.push(octets);
    for (let frame = reader.next(); frame; frame = reader.next()) socket.frames.push(frame);
  });
  if (life) socket.write(helloOf(life, publisher));
  return socket;
}

/** Frames that a datagram socket has heard, opened by these keys, with where they came from. */
export function heardBy(socket, keys = plainKeys) {
  const heard = [];
  socket.on('message', (octets, { address, port }) => {
    const read = anyFrameOfDatagram(octets);
    const frame = read && (read.kind === kinds.hello || (read.kind === kinds.end && read.payload.length > 0) ? keys.takeBack(read) : keys.takeForward(read));
    if (frame) heard.push({ ...frame, said: readHandshake(frame.payload), from: { address, port } });
  });
  return heard;
}

/** A listener that has said hello with its cookie, and what it heard since. */
export async function listener(t, publisher, life) {
  const socket = await datagramSocket(t);
  const heard = heardBy(socket);
  await sendTo(socket, helloOf(life, publisher), publisher.port);
  await until(() => heard.length === 1);
  await sendTo(socket, helloOf(life, publisher, 1n, heard[0].said.cookie), publisher.port);
  await until(() => heard.length === 2);
  heard.splice(0);
  return { socket, heard };
}
