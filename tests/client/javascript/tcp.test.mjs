// Channels over TCP on real sockets: who becomes a consumer, who is closed, who is held back.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { test } from 'node:test';

import { encodeFrame, frameOfDatagram, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { lifeOf } from '../../../src/client/javascript/lib/protocol/life.js';
import { limits, MessageTooLargeError } from '../../../src/client/javascript/lib/index.js';
import { readHandshake, writeHandshake } from '../../../src/client/javascript/lib/protocol/handshake.js';
import { added, consumer, consumerSocket, helloOf, lab, message, ours } from './lab.mjs';
import { event, until, valueOf } from './support.mjs';

test('over TCP a full queue holds the provider back, and nothing is lost up to its end', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x', queue: 4, protocol: 'tcp' });
  const stated = await daemon.line(/^1 sub create/);
  assert.equal(valueOf(stated, 'port'), undefined);
  const server = createServer().listen(0, '127.0.0.1');
  t.after(() => server.close());
  await once(server, 'listening');
  daemon.say(added(1, server.address().port, { protocol: 'tcp' }));
  const [socket] = await once(server, 'connection');
  const [hello] = await once(socket, 'data');
  assert.equal(frameOfDatagram(hello).life, lifeOf(valueOf(stated, 'channel')));
  const removed = event(subscriber, 'provider', ({ change }) => change === 'removed');
  const frames = Array.from({ length: 300 }, (_, i) => message(i + 1));
  socket.end(Buffer.concat([...frames, encodeFrame(kinds.end, ours, 300n)]));
  daemon.say('1 pub del service=0000000b/1/1 reason=withdrawn');
  for (let i = 1n; i <= 300n; ++i) assert.equal((await subscriber.receive()).sequence, i);
  assert.equal((await removed).reason, 'withdrawn');
  assert.deepEqual(subscriber.statistics, { received: 300, missed: 0, dropped: 0, overflowed: 0 });
});

test('a TCP stream that holds no frame is closed, and tried again with back-off', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const server = createServer().listen(0, '127.0.0.1');
  t.after(() => server.close());
  await once(server, 'listening');
  daemon.say(added(1, server.address().port, { protocol: 'tcp' }));
  for (const wait of [100, 200]) {
    const [socket] = await once(server, 'connection');
    socket.on('error', () => {});
    socket.resume();
    socket.write('HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n');
    await once(socket, 'close');
    await until(() => clock.next === wait);
    clock.advance(wait);
  }
  const [socket] = await once(server, 'connection');
  socket.write(message(1));
  assert.equal((await subscriber.receive()).sequence, 1n);
  assert.equal(subscriber.statistics.dropped, 2);
  socket.destroy();
});

test('a TCP consumer is one when both its hello and its sub add are there, whichever comes first', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const publisher = await node.publish({ mode: 'oto', text: 'x', protocol: 'tcp' });
  const early = await consumerSocket(t, publisher, ours);
  await until(() => early.bytesWritten === 48);
  publisher.send(Buffer.from('nobody'));
  assert.equal(publisher.statistics.sent, 0);
  const come = event(publisher, 'consumer');
  daemon.say(consumer(1, 1));
  assert.equal((await come).change, 'added');
  publisher.send(Buffer.from('one'));
  await until(() => early.frames.length === 1);
  // A second connection with the same life takes the place of the first; nobody is told.
  const second = await consumerSocket(t, publisher, ours);
  await once(early, 'close');
  publisher.send(Buffer.from('two'));
  await until(() => second.frames.length === 1);
  assert.deepEqual([second.frames[0].sequence, second.frames[0].life], [2n, publisher.life]);
  const lost = event(publisher, 'consumer');
  second.destroy();
  assert.deepEqual([(await lost).change, (await lost).reason], ['removed', 'lost']);
  const again = event(publisher, 'consumer');
  const third = await consumerSocket(t, publisher, ours);
  assert.equal((await again).change, 'added');
  // A connection without a sub add is closed after 5 s.
  const stranger = await consumerSocket(t, publisher, 0xbbn);
  const silent = await consumerSocket(t, publisher);
  await until(() => clock.running >= 2);
  clock.advance(limits.strangerPatience);
  await Promise.all([once(stranger, 'close'), once(silent, 'close')]);
  const closed = publisher.close();
  await until(() => third.frames.length === 1);
  assert.equal(third.frames[0].kind, kinds.end);
  await closed;
});

test('a hello that is none is closed at once: a wrong payload, another life, no challenge, a message', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const { life } = publisher;
  const bad = [encodeFrame(kinds.message, 1n, 1n, Buffer.from('x')), encodeFrame(kinds.hello, 1n, 0n), encodeFrame(kinds.hello, 1n, 0n, Buffer.alloc(8)),
    encodeFrame(kinds.hello, 1n, 0n, Buffer.alloc(25)).subarray(0, 24), helloOf(1n, { life: life ^ 1n }), helloOf(1n, publisher, 0n),
    encodeFrame(kinds.end, 1n, 0n, writeHandshake(life, 1n, 0n)), encodeFrame(kinds.message, 1n, 1n, writeHandshake(life, 1n, 0n))];
  for (const octets of bad) {
    const socket = await consumerSocket(t, publisher);
    socket.write(octets);
    await once(socket, 'close');
    assert.deepEqual(socket.frames, []);
  }
  assert.deepEqual([publisher.statistics.dropped, publisher.hasConsumer], [bad.length, false]);
});

test('64 TCP strangers of one host have places, one more is refused, and one of another host takes the place of the newest', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'oto', text: 'x', protocol: 'tcp' });
  const strangers = [];
  for (let i = 0; i < limits.maxStrangers; ++i) strangers.push(await consumerSocket(t, publisher));
  const more = await consumerSocket(t, publisher);
  await once(more, 'close');
  assert.equal(publisher.statistics.dropped, 1);
  const other = await consumerSocket(t, publisher, undefined, '127.0.0.2');
  await once(strangers.at(-1), 'close');
  assert.equal(strangers.slice(0, -1).some(({ destroyed }) => destroyed) || other.destroyed, false);
});

test('a 257th TCP consumer is refused and told so, and one of another host takes a place', async (t) => {
  const { daemon, node, logged } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const sockets = [];
  for (let i = 1; i <= limits.maxConsumers; ++i) {
    const socket = await consumerSocket(t, publisher, BigInt(i));
    sockets.push(socket);
    if (i % 32 === 0) await until(() => socket.bytesWritten === 48);
  }
  const isFull = ({ frames }) => frames.length === 1 && frames[0].kind === kinds.full && frames[0].life === publisher.life;
  for (const life of [1000n, 1001n]) {
    const more = await consumerSocket(t, publisher, life);
    await once(more, 'close');
    assert.ok(isFull(more));
    assert.deepEqual(readHandshake(more.frames[0].payload), { life, challenge: 1n, cookie: 0n });
  }
  assert.deepEqual(logged, ['all 256 places for consumers are taken']);
  assert.equal(await daemon.line(/ pub modify/), '1 pub modify channel.full=256');
  const other = await consumerSocket(t, publisher, 2000n, '127.0.0.2');
  await once(sockets.at(-1), 'close');
  assert.ok(isFull(sockets.pop()));
  publisher.send(Buffer.from('x'));
  await until(() => [other, ...sockets].every(({ frames }) => frames.length === 1));
  for (const socket of sockets.splice(0, 64)) socket.destroy();
  assert.equal(await daemon.line(/ pub modify/), '1 pub modify channel.full=0');
});

test('64 MiB wait for all consumers, each frame counted once; then the one that took nothing for the longest time is closed', async (t) => {
  const { node, clock, daemon } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/pubsub', text: 'x', protocol: 'tcp' });
  const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
  const told = [];
  publisher.on('consumer', ({ change, reason, life }) => told.push([change, reason, life]));
  const add = async (life) => {
    const text = life.toString(16).padStart(16, '0');
    daemon.say(consumer(id, Number(life), text, 'otm/pubsub'));
    const socket = await consumerSocket(t, publisher, life);
    socket.pause();
    await until(() => told.some((one) => one[0] === 'added' && one[2] === life));
    return socket;
  };
  const payload = Buffer.alloc(limits.maxStreamMessage - 24, 1); // four frames are 64 MiB
  const sockets = [await add(1n)];
  clock.advance(1);
  publisher.send(payload); // it waits alone
  sockets.push(await add(2n));
  clock.advance(1);
  for (let life = 2n; life <= 5n; ++life) {
    clock.advance(1);
    publisher.send(payload); // to the newest one, since no other has room
    if (life < 5n) sockets.push(await add(life + 1n));
    if (life === 4n) assert.equal(told.filter(([change]) => change === 'removed').length, 0);
  }
  await until(() => told.some(([change]) => change === 'removed'));
  assert.deepEqual(told.filter(([change]) => change === 'removed'), [['removed', 'slow', 1n]]);
  assert.equal(publisher.statistics.leftOut, 1 + 2 + 3 + 4);
  await until(() => publisher.consumers.length === 4);
  for (const socket of sockets) socket.destroy();
});

test('256 connections that read nothing share the frames that wait for them', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const wrong = [];
  for (let i = 0; i < 60; ++i) wrong.push(await consumerSocket(t, { port: publisher.port, life: 5n }, BigInt(i + 1)));
  await until(() => wrong.every(({ destroyed }) => destroyed));
  assert.equal(publisher.hasConsumer, false);
  const sockets = [];
  for (let i = 0; i < limits.maxConsumers - 1; ++i) {
    const socket = await consumerSocket(t, publisher, BigInt(i + 1));
    socket.pause();
    sockets.push(socket);
  }
  const reader = await consumerSocket(t, publisher, 1000n);
  const before = process.memoryUsage().arrayBuffers;
  let sent = 0;
  while (publisher.statistics.leftOut < sockets.length) {
    publisher.send(Buffer.alloc(64 * 1024, 1));
    ++sent;
    if (sent === 1) await until(() => reader.frames.length > 0 || (publisher.send(Buffer.alloc(1)) && ++sent && false));
    await until(() => reader.frames.at(-1).sequence === BigInt(sent));
    reader.frames.splice(0, reader.frames.length - 1);
  }
  globalThis.gc?.();
  const grown = process.memoryUsage().arrayBuffers - before;
  for (const socket of sockets) socket.destroy();
  assert.ok(grown < limits.maxWaitingForAll, `${grown} octets for ${sent} messages`);
});

test('a flood of forged providers over TCP holds places that an honest one gets', async (t) => {
  const { daemon, node, clock, logged } = await lab(t);
  const subscriber = node.subscribe({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  await subscriber.ready();
  // Nobody listens at port 1, so these never connect.
  const forged = (i, address) => added(1, 1, { protocol: 'tcp', mode: 'otm/stream', channel: (i + 4096).toString(16).padStart(16, '0') })
    .replace('0000000b/1/1', `0000000c/1/${i}`).replace('127.0.0.1', address);
  const told = [];
  subscriber.on('provider', ({ service }) => told.push(service));
  for (let i = 1; i <= limits.maxTcpProviders; ++i) daemon.say(forged(i, '127.0.0.3'));
  await until(() => told.length === limits.maxTcpProviders);
  assert.deepEqual(logged, []);
  const server = createServer().listen(0, '127.0.0.2');
  t.after(() => server.close());
  await once(server, 'listening');
  const connected = once(server, 'connection');
  daemon.say(added(1, server.address().port, { protocol: 'tcp', mode: 'otm/stream' }).replace('127.0.0.1', '127.0.0.2'));
  const [socket] = await connected;
  assert.deepEqual(logged, ['all 256 places for providers over TCP are taken']);
  socket.write(message(1));
  assert.equal((await subscriber.receive()).sequence, 1n);
  // A second honest one of the flooding host waits until one that does not connect has lost its place.
  const late = createServer().listen(0, '127.0.0.3');
  t.after(() => late.close());
  await once(late, 'listening');
  daemon.say(added(1, late.address().port, { protocol: 'tcp', mode: 'otm/stream', channel: '00000000000000ff' })
    .replace('0000000b/1/1', '0000000d/1/1').replace('127.0.0.1', '127.0.0.3'));
  await until(() => told.includes('0000000d/1/1'));
  let isLate = false;
  late.once('connection', () => {
    isLate = true;
  });
  for (let passed = 0; passed <= 4 * limits.unconnectedPatience && !isLate; passed += 100) {
    clock.advance(100);
    await new Promise((resolve) => setImmediate(resolve));
    await new Promise((resolve) => setImmediate(resolve));
  }
  await until(() => isLate);
  assert.equal(logged.length, 1);
  socket.destroy();
});

test('a provider that has ended although its match lasts is connected to again after 10 s', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x', protocol: 'tcp' });
  await subscriber.ready();
  const server = createServer().listen(0, '127.0.0.1');
  t.after(() => server.close());
  await once(server, 'listening');
  daemon.say(added(1, server.address().port, { protocol: 'tcp' }));
  const [socket] = await once(server, 'connection');
  const removed = event(subscriber, 'provider', ({ change }) => change === 'removed');
  socket.end(encodeFrame(kinds.end, ours, 0n));
  assert.equal((await removed).reason, 'withdrawn');
  daemon.say(added(1, server.address().port, { protocol: 'tcp', change: 'modify' }));
  const again = event(subscriber, 'provider', ({ change }) => change === 'added');
  const next = once(server, 'connection');
  await until(() => clock.waits.includes(limits.endHintPatience));
  clock.advance(limits.endHintPatience);
  await again;
  (await next)[0].destroy();
});

test('a slow consumer is told of once, until it has taken some', async (t) => {
  const { node, logged } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const slow = await consumerSocket(t, publisher, 5n);
  await until(() => publisher.hasConsumer);
  slow.pause();
  for (const expected of [1, 2]) {
    const before = publisher.statistics.leftOut;
    while (publisher.statistics.leftOut < before + 3) publisher.send(Buffer.alloc(1024 * 1024));
    await until(() => logged.length === expected);
    slow.resume();
    await publisher.drained();
    slow.pause();
  }
  assert.equal(logged[1], 'the consumer 0000000000000005 is slow: messages to it are left out until it has taken some');
  slow.destroy();
});

test('who does not read is left out once 4 MiB wait, and holds nobody up', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const slow = await consumerSocket(t, publisher, 1n);
  const quick = await consumerSocket(t, publisher, 2n);
  publisher.send(Buffer.from('x'));
  await until(() => {
    if (slow.frames.length === 0 || quick.frames.length === 0) publisher.send(Buffer.from('x'));
    return slow.frames.length > 0 && quick.frames.length > 0;
  });
  slow.pause();
  const payload = Buffer.alloc(1024 * 1024, 1);
  let sent = 0;
  while (publisher.statistics.leftOut === 0) {
    const before = quick.frames.length;
    publisher.send(payload);
    ++sent;
    await until(() => quick.frames.length > before);
  }
  assert.ok(sent >= 4);
  assert.equal(publisher.send(Buffer.alloc(1)), false);
  assert.equal(publisher.send(Buffer.alloc(limits.maxWaiting)), false);
  assert.equal(publisher.statistics.leftOut, 2);
  const aborting = new AbortController();
  const waiting = publisher.drained({ signal: aborting.signal });
  aborting.abort();
  await assert.rejects(waiting, { name: 'AbortError' });
  slow.resume();
  await publisher.drained();
  assert.equal(publisher.send(Buffer.from('y')), true);
  await until(() => slow.frames.at(-1).payload.length === 1 && slow.frames.at(-1).sequence === quick.frames.at(-1).sequence);
});

test('many small messages lose nothing if the publisher waits whenever it is told to', async (t) => {
  const { node, logged } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const slow = await consumerSocket(t, publisher, 1n);
  await until(() => publisher.hasConsumer);
  let rounds = 0;
  for (let i = 0; rounds < 2; ++i) {
    if (i % 1000 === 0 && rounds === 0) slow.pause();
    if (publisher.send(Buffer.alloc(1))) continue;
    ++rounds;
    slow.resume();
    await publisher.drained();
    slow.pause();
  }
  slow.resume();
  const { sent, leftOut } = publisher.statistics;
  await until(() => slow.frames.length === sent);
  assert.deepEqual([leftOut, logged], [0, []]);
});

test('messages have their largest size', async (t) => {
  const { node } = await lab(t);
  const [udp, tcp] = await Promise.all(['udp', 'tcp'].map((protocol) => node.publish({ mode: 'oto', text: 'x', protocol })));
  assert.equal(udp.send(Buffer.alloc(limits.maxDatagramMessage)), true);
  assert.throws(() => udp.send(Buffer.alloc(limits.maxDatagramMessage + 1)), /protocol=tcp/);
  assert.equal(tcp.send(Buffer.alloc(limits.maxStreamMessage)), true);
  assert.throws(() => tcp.send(Buffer.alloc(limits.maxStreamMessage + 1)), MessageTooLargeError);
  assert.throws(() => tcp.send('text'), TypeError);
});
