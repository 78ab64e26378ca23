// See ../clients.
import { createSocket } from 'node:dgram';
import { connect as connectTcp } from 'node:net';
import { createInterface } from 'node:readline';

import { connect } from 'geminga';

const [mode, protocol, text, portWord] = process.argv.slice(2);
const port = Number(portWord);
const turn = () => new Promise((resolve) => setImmediate(resolve));

const node = await connect({ name: 'sender' });
const publisher = await node.publish({ mode, text, protocol });
while (!publisher.hasConsumer) await turn();

/** A plain socket of Node.js and its send function. */
async function plainSocket() {
  if (protocol === 'udp') {
    const socket = createSocket('udp4');
    await new Promise((resolve) => socket.bind(0, resolve));
    return { send: (payload) => socket.send(payload, port, '127.0.0.1'), waiting: () => socket.getSendQueueSize(), socket };
  }
  const socket = connectTcp({ port, host: '127.0.0.1', noDelay: true });
  await new Promise((resolve) => socket.once('connect', resolve));
  return { send: (payload) => socket.write(payload), waiting: () => socket.writableLength, socket };
}
const plain = await plainSocket();

const send = { library: (payload) => publisher.send(payload), plain: plain.send };
const isSent = { library: () => publisher.drained(), plain: async () => {
  while (plain.waiting() > 0) await turn();
} };

console.log('ready');
for await (const line of createInterface({ input: process.stdin })) {
  const [how, count, size] = line.split(' ');
  if (how === 'quit') break;
  const payload = Buffer.alloc(Number(size), 'x');
  const one = send[how];
  const begin = process.hrtime.bigint();
  for (let i = Number(count); i > 0; --i) one(payload);
  await isSent[how](); // what the call left for later is part of what it costs
  await turn();
  console.log(String(process.hrtime.bigint() - begin));
}
plain.socket[protocol === 'udp' ? 'close' : 'destroy']();
await node.close();
