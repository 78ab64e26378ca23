// Channels over UDP on real sockets: what is believed, what is lost, who listens, ports.
import assert from 'node:assert/strict';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { networkInterfaces } from 'node:os';
import { test } from 'node:test';

import { encodeFrame, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { lifeOctets } from '../../../src/client/javascript/lib/protocol/life.js';
import { limits, PortError } from '../../../src/client/javascript/lib/index.js';
import { DatagramPort } from '../../../src/client/javascript/lib/channels/datagram_port.js';
import { Io } from '../../../src/client/javascript/lib/channels/io.js';
import { writeHandshake } from '../../../src/client/javascript/lib/protocol/handshake.js';
import { added, consumer, datagramSocket, heardBy, helloOf, lab, life, message, ours, sendTo } from './lab.mjs';
import { event, until, valueOf } from './support.mjs';

test('only what the matched provider sends is delivered, once and in order', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const port = Number(valueOf(await daemon.line(/^1 sub create/), 'port'));
  assert.equal(port, subscriber.port);
  const provider = await datagramSocket(t);
  const stranger = await datagramSocket(t);
  daemon.say(added(1, provider.address().port));
  assert.equal((await event(subscriber, 'provider')).life, ours);
  const bad = [message(1), Buffer.from('hello')];
  for (const octets of bad) await sendTo(stranger, octets, port);
  await sendTo(provider, encodeFrame(kinds.message, 0xabn, 1n), port);
  await sendTo(provider, Buffer.alloc(0), port);
  for (const sequence of [5, 5, 4, 6, 9]) await sendTo(provider, message(sequence, `m${sequence}`), port);
  const got = [];
  for (let i = 0; i < 3; ++i) got.push(await subscriber.receive());
  assert.deepEqual(got.map(({ sequence, missed, payload }) => [sequence, missed, String(payload)]),
    [[5n, 0, 'm5'], [6n, 0, 'm6'], [9n, 2, 'm9']]);
  await until(() => subscriber.statistics.dropped === 6);
  // An end is a hint only, which the daemon confirms, for whatever reason.
  const removed = event(subscriber, 'provider');
  await sendTo(provider, encodeFrame(kinds.end, ours, 11n), port);
  await sendTo(provider, message(10, 'm10'), port);
  assert.equal((await subscriber.receive()).sequence, 10n);
  daemon.say('1 pub del service=0000000b/1/1 reason=expired');
  assert.deepEqual([(await removed).change, (await removed).reason], ['removed', 'withdrawn']);
  assert.equal(subscriber.statistics.missed, 3);
});

test('what a provider sends before the daemon tells of it is delivered then', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  await daemon.line(/^1 sub create/);
  const provider = await datagramSocket(t);
  for (const sequence of [1, 2]) await sendTo(provider, message(sequence, `m${sequence}`), subscriber.port);
  for (const octets of [encodeFrame(kinds.hello, ours, 0n), Buffer.from('no frame')]) await sendTo(provider, octets, subscriber.port);
  await until(() => subscriber.statistics.dropped === 4);
  daemon.say(added(1, provider.address().port));
  await event(subscriber, 'provider');
  await sendTo(provider, message(3, 'm3'), subscriber.port);
  for (const text of ['m1', 'm2', 'm3']) {
    const { payload, missed } = await subscriber.receive();
    assert.deepEqual([String(payload), missed], [text, 0]);
  }
  assert.equal(subscriber.statistics.dropped, 2);
  // It is started again at its port: another life, which the daemon tells later.
  const again = 0xabn;
  await sendTo(provider, encodeFrame(kinds.message, again, 1n, Buffer.from('again')), subscriber.port);
  await sendTo(provider, encodeFrame(kinds.end, again, 3n), subscriber.port);
  await until(() => subscriber.statistics.dropped === 4);
  const told = [];
  subscriber.on('provider', ({ change, reason }) => told.push([change, reason]));
  daemon.say(added(1, provider.address().port, { channel: '00000000000000ab' }).replace('service=0000000b/1/1', 'service=0000000b/1/2'));
  const { life: other, payload } = await subscriber.receive();
  assert.deepEqual([other, String(payload)], [again, 'again']);
  daemon.say('1 pub del service=0000000b/1/2 reason=left');
  await until(() => told.length === 2);
  assert.deepEqual(told, [['added', undefined], ['removed', 'withdrawn']]);
  assert.deepEqual([subscriber.statistics.dropped, subscriber.statistics.missed], [2, 2]);
});

test('what came a second before the daemon told of its provider is not delivered', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  await daemon.line(/^1 sub create/);
  const provider = await datagramSocket(t);
  await sendTo(provider, message(1, 'old'), subscriber.port);
  await until(() => subscriber.statistics.dropped === 1);
  clock.advance(limits.earlyPatience);
  await sendTo(provider, message(2, 'new'), subscriber.port);
  await until(() => subscriber.statistics.dropped === 2);
  daemon.say(added(1, provider.address().port));
  const { payload, missed } = await subscriber.receive();
  assert.deepEqual([String(payload), missed, subscriber.statistics.dropped], ['new', 0, 1]);
});

test('what does not speak in frames is delivered as it is over UDP, and is a problem over TCP', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const provider = await datagramSocket(t);
  daemon.say(added(1, provider.address().port, { channel: '' }));
  await event(subscriber, 'provider');
  await sendTo(provider, Buffer.from('plain'), subscriber.port);
  const { payload, life: none, sequence } = await subscriber.receive();
  assert.deepEqual([String(payload), none, sequence], ['plain', 0n, 0n]);
  const problem = event(subscriber, 'problem');
  daemon.say(added(1, 9, { channel: '', protocol: 'tcp' }).replaceAll('0000000b', '0000000c'));
  assert.match((await problem).message, /no channel that can be opened/);
  const publisher = await node.publish({ mode: 'oto', text: 'x' });
  daemon.say(consumer(2, provider.address().port, ''));
  await event(publisher, 'consumer');
  publisher.send(Buffer.from('as it is'));
  assert.equal(String((await once(provider, 'message'))[0]), 'as it is');
});

test('nobody takes messages: the oldest datagrams are lost, and the next one says how many', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x', queue: 4 });
  const provider = await datagramSocket(t);
  daemon.say(added(1, provider.address().port));
  await event(subscriber, 'provider');
  for (let i = 1; i <= 10; ++i) await sendTo(provider, message(i), subscriber.port);
  await until(() => subscriber.statistics.overflowed === 6);
  const first = await subscriber.receive();
  assert.deepEqual([first.sequence, first.missed], [7n, 6]);
  assert.deepEqual([(await subscriber.receive()).missed, subscriber.statistics.missed, subscriber.statistics.dropped], [0, 6, 0]);
});

test('a port that is taken is an error; where it was taken while pubsub was silent, another one is stated', async (t) => {
  const { daemon, node } = await lab(t);
  const other = await datagramSocket(t);
  await assert.rejects(node.publish({ mode: 'oto', text: 'x', port: other.address().port }), PortError);
  assert.throws(() => node.subscribe({ mode: 'oto', text: 'x', port: other.address().port }), PortError);
  await assert.rejects(node.publish({ mode: 'oto', text: 'x', port: 65536 }), /port=65536/);
  const publisher = await node.publish({ mode: 'otm/pubsub', text: 'x' });
  const { port } = publisher;
  const taker = createSocket('udp4');
  t.after(() => taker.close());
  taker.bind(port, '127.0.0.1');
  await once(taker, 'listening');
  const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
  daemon.say(consumer(id, other.address().port, life, 'otm/pubsub'));
  const moved = await daemon.line(/ pub modify/);
  assert.equal(Number(valueOf(moved, 'port')), publisher.port);
  assert.notEqual(publisher.port, port);
});

test('hello is said at once and then less often until it is accepted, with the cookie that comes, and its end when it is over', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'otm/stream', text: 'x' });
  const provider = await datagramSocket(t);
  const heard = heardBy(provider);
  daemon.say(added(1, provider.address().port, { mode: 'otm/stream' }));
  await until(() => heard.length === 1);
  for (const [i, wait] of [20, 40, 80, 160, 320, 640, 1000, 1000].entries()) {
    clock.advance(wait - 1);
    assert.equal(heard.length, i + 1);
    clock.advance(1);
    await until(() => heard.length === i + 2);
  }
  const { challenge } = heard[0].said;
  const floor = (back, cookie) => encodeFrame(kinds.floor, ours, 0n, writeHandshake(subscriber.life, back, cookie));
  await sendTo(provider, floor(challenge ^ 1n, 6n), subscriber.port);
  await until(() => subscriber.statistics.dropped === 1);
  heard.splice(0);
  await sendTo(provider, floor(challenge, 5n), subscriber.port);
  await until(() => heard.length === 1);
  await sendTo(provider, floor(challenge, 0n), subscriber.port);
  await sendTo(provider, message(1), subscriber.port);
  await subscriber.receive();
  for (let count = 2; count <= 4; ++count) {
    clock.advance(limits.helloInterval);
    await until(() => heard.length === count);
  }
  const { port } = subscriber;
  await subscriber.close();
  await until(() => heard.length === 5);
  assert.deepEqual(heard.map(({ kind }) => kind), [2, 2, 2, 2, 3]);
  for (const { life: from, sequence, said, from: { port: source } } of heard) {
    assert.deepEqual([from, sequence, said, source], [subscriber.life, 0n, { life: ours, challenge, cookie: 5n }, port]);
  }
});

test('a listener of an otm/stream says the life of the publisher, and is sent to when it has shown by a cookie to receive', async (t) => {
  const { node, clock } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x' });
  const socket = await datagramSocket(t);
  const heard = heardBy(socket);
  const { life: to } = publisher;
  const other = { life: to ^ 1n };
  const bad = [encodeFrame(kinds.hello, 9n, 0n), encodeFrame(kinds.hello, 9n, 0n, lifeOctets(to)), helloOf(9n, other), helloOf(9n, publisher, 0n),
    encodeFrame(kinds.hello, 9n, 0n, Buffer.concat([writeHandshake(to, 1n, 0n), Buffer.alloc(1)])),
    encodeFrame(kinds.message, 9n, 1n, writeHandshake(to, 1n, 0n)), Buffer.from('x')];
  for (const octets of bad) await sendTo(socket, octets, publisher.port);
  await until(() => publisher.statistics.dropped === bad.length);
  // A hello without a cookie, or with a wrong one, gets one. Its sender is not sent to.
  for (const [i, cookie] of [0n, 7n].entries()) {
    await sendTo(socket, helloOf(9n, publisher, 3n, cookie), publisher.port);
    await until(() => heard.length === i + 1);
  }
  const [first, second] = heard;
  assert.deepEqual([first.kind, first.life, first.said.life, first.said.challenge], [kinds.floor, to, 9n, 3n]);
  assert.equal(first.said.cookie, second.said.cookie);
  assert.deepEqual([publisher.hasConsumer, publisher.statistics.dropped], [false, bad.length]);
  await sendTo(socket, helloOf(9n, publisher, 3n, first.said.cookie), publisher.port);
  await until(() => heard.length === 3);
  assert.deepEqual([heard[2].said.cookie, publisher.hasConsumer], [0n, true]);
  // A renewal is taken without a cookie. Listeners are forgotten after 3 s.
  clock.advance(limits.listenerPatience - 1);
  await sendTo(socket, helloOf(9n, publisher, 3n), publisher.port);
  await until(() => heard.length === 4);
  clock.advance(limits.listenerPatience - 1);
  publisher.send(Buffer.from('x'));
  assert.equal(publisher.hasConsumer, true);
  await sendTo(socket, encodeFrame(kinds.end, 9n, 0n, writeHandshake(to, 3n, 0n)), publisher.port);
  await until(() => !publisher.hasConsumer);
});

/** A socket of an address of the loopback interface. */
async function socketOf(t, address) {
  const socket = createSocket('udp4');
  t.after(() => socket.close());
  socket.bind(0, address);
  await once(socket, 'listening');
  return socket;
}

test('1100 listeners of one host find 1024 places, another host finds one, and all are told', async (t) => {
  const { daemon, node, clock, logged } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x' });
  const add = async (life, address) => {
    const socket = await socketOf(t, address);
    const heard = heardBy(socket);
    await sendTo(socket, helloOf(life, publisher), publisher.port);
    await until(() => heard.length === 1);
    await sendTo(socket, helloOf(life, publisher, 1n, heard[0].said.cookie), publisher.port);
    await until(() => heard.length === 2);
    if (Number(life) % 64 === 0) clock.advance(250); // answers are allowed again
    return { socket, heard, kind: heard[1].kind, life };
  };
  const listeners = [];
  for (let i = 1; i <= limits.maxListeners; ++i) {
    listeners.push(await add(BigInt(i), '127.0.0.1'));
    if (i !== limits.maxListeners / 2) continue;
    for (const one of listeners) await sendTo(one.socket, helloOf(one.life, publisher), publisher.port); // else they are forgotten
  }
  assert.ok(listeners.every(({ kind }) => kind === kinds.floor));
  assert.deepEqual(logged, []);
  for (let i = 1; i <= 4; ++i) {
    const { kind, heard } = await add(BigInt(2000 + i), '127.0.0.1');
    assert.equal(kind, kinds.full);
    assert.deepEqual(heard[1].said, { life: BigInt(2000 + i), challenge: 1n, cookie: 0n });
  }
  const other = await add(3000n, '127.0.0.2');
  assert.equal(other.kind, kinds.floor);
  const loser = listeners.at(-1);
  await until(() => loser.heard.at(-1).kind === kinds.full);
  assert.deepEqual(logged, ['all 1024 places for listeners are taken']);
  assert.equal(await daemon.line(/ pub modify/), '1 pub modify channel.full=1024');
  publisher.send(Buffer.from('x'));
  await until(() => [other, listeners[0]].every(({ heard }) => heard.at(-1).kind === kinds.message));
  assert.equal(loser.heard.at(-1).kind, kinds.full);
  clock.advance(limits.listenerPatience);
  publisher.send(Buffer.from('x'));
  assert.equal(await daemon.line(/ pub modify/), '1 pub modify channel.full=0');
});

test('hellos of strangers are answered by no more octets than they have, and by 512 answers a second', async (t) => {
  const { node, clock } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x' });
  const socket = await datagramSocket(t);
  const sizes = [];
  socket.on('message', ({ length }) => sizes.push(length));
  const hello = helloOf(7n, publisher);
  for (let i = 0; i < limits.maxAnswers; ++i) {
    await sendTo(socket, hello, publisher.port);
    await until(() => sizes.length === i + 1);
  }
  for (let i = 0; i < 10; ++i) await sendTo(socket, hello, publisher.port);
  await sendTo(socket, Buffer.from('x'), publisher.port);
  await until(() => publisher.statistics.dropped === 1);
  clock.advance(1000 / limits.maxAnswers);
  await sendTo(socket, hello, publisher.port);
  await until(() => sizes.length === limits.maxAnswers + 1);
  assert.ok(sizes.every((size) => size === hello.length));
  assert.equal(publisher.hasConsumer, false);
});

test('a forged sequence mutes a channel for 2 s and one message, a forged end not at all', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const provider = await datagramSocket(t);
  daemon.say(added(1, provider.address().port));
  await event(subscriber, 'provider');
  const told = [];
  subscriber.on('provider', ({ change, reason }) => told.push([change, reason]));
  const send = (octets) => sendTo(provider, octets, subscriber.port);
  const got = async () => {
    const { sequence, missed } = await subscriber.receive();
    return [Number(sequence), missed];
  };
  await send(message(1));
  assert.deepEqual(await got(), [1, 0]);
  await send(message(2n ** 64n - 1n, 'forged'));
  await send(encodeFrame(kinds.end, ours, 2n ** 64n - 1n));
  await send(message(2));
  assert.deepEqual(await got(), [2, 0]);
  await send(message(60_000, 'forged'));
  assert.deepEqual(await got(), [60_000, 59_997]);
  for (let i = 3; i <= 5; ++i) await send(message(i));
  await until(() => subscriber.statistics.dropped === 4);
  clock.advance(limits.stragglerPatience);
  for (const i of [6, 7]) await send(message(i));
  assert.deepEqual(await got(), [6, 0]);
  assert.deepEqual(await got(), [7, 0]);
  // The end is forgotten after 10 s. What the daemon says then has its own reason.
  clock.advance(limits.endHintPatience);
  daemon.say('1 pub del service=0000000b/1/1 reason=outranked');
  await until(() => told.length === 1);
  assert.deepEqual(told, [['removed', 'outranked']]);
});

test('a withdrawn provider ends with its end, which may come before the word of the daemon or behind it', async (t) => {
  for (const isBefore of [true, false]) {
    const { daemon, node } = await lab(t);
    const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
    const provider = await datagramSocket(t);
    daemon.say(added(1, provider.address().port));
    await event(subscriber, 'provider');
    await sendTo(provider, message(1), subscriber.port);
    await subscriber.receive();
    const removed = event(subscriber, 'provider');
    const end = () => sendTo(provider, encodeFrame(kinds.end, ours, 4n), subscriber.port);
    const del = () => daemon.say('1 pub del service=0000000b/1/1 reason=withdrawn');
    for (const say of isBefore ? [end, del] : [del, end]) await say();
    assert.deepEqual([(await removed).reason, subscriber.statistics.missed], ['withdrawn', 3]);
  }
});

test('a refused listener is told once, and goes on asking', async (t) => {
  const { daemon, node, clock, logged } = await lab(t);
  const subscriber = node.subscribe({ mode: 'otm/stream', text: 'x' });
  const provider = await datagramSocket(t);
  const heard = heardBy(provider);
  const { port } = provider.address();
  daemon.say(added(1, port, { mode: 'otm/stream' }));
  const text = `the provider 127.0.0.1:${port} has no place for another consumer`;
  for (let i = 1; i <= 2; ++i) {
    await until(() => heard.length >= i);
    await sendTo(provider, encodeFrame(kinds.full, ours, 0n, writeHandshake(subscriber.life, heard[0].said.challenge, 0n)), subscriber.port);
    await until(() => logged.length === 1);
    clock.advance(limits.helloInterval);
  }
  await until(() => heard.length >= 3);
  assert.deepEqual(logged, [text]);
  // A full without the challenge is nothing.
  await sendTo(provider, encodeFrame(kinds.full, ours, 0n, writeHandshake(subscriber.life, 1n, 0n)), subscriber.port);
  await until(() => subscriber.statistics.dropped === 1);
});

test('one port is spoken by each family that the host has', async (t) => {
  const addresses = Object.values(networkInterfaces()).flat().map(({ address }) => address);
  const loopbacks = ['127.0.0.1', '::1'].filter((address) => addresses.includes(address));
  assert.ok(loopbacks.length > 0);
  for (const isOne of [false, true]) {
    const port = DatagramPort.open(new Io(), { isOne });
    t.after(() => port.close());
    const heard = [];
    port.listen((octets, address, from) => heard.push([String(octets), address, from]));
    for (const address of loopbacks) port.send(Buffer.from(address), address, port.port);
    await until(() => heard.length === loopbacks.length);
    assert.deepEqual(heard.sort(), loopbacks.map((address) => [address, address, port.port]).sort());
    assert.throws(() => DatagramPort.open(new Io(), { port: port.port }), PortError);
    assert.throws(() => DatagramPort.open(new Io(), { port: port.port, isOne }), PortError);
  }
  const elsewhere = DatagramPort.open(new Io(), { address: '192.0.2.1' });
  t.after(() => elsewhere.close());
  assert.ok(elsewhere.sockets.length > 0);
});
