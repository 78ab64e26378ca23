// Nodes, publishers and subscribers on real sockets of the loopback interface, with a daemon that says what the test wants and
// a clock that stands still.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { connect as dial, createServer } from 'node:net';
import { test } from 'node:test';

import { encodeFrame, frameOfDatagram, kinds, lifeOf } from '../../../src/client/javascript/lib/core/frame.js';
import { FrameDecoder } from '../../../src/client/javascript/lib/core/decoder.js';
import { ClosedError, connect, limits, MessageTooLargeError, PortError, RefusedError } from '../../../src/client/javascript/lib/index.js';
import { event, lib, ManualClock, ScriptedDaemon, until, valueOf } from './support.mjs';

const life = '00000000000000aa';
const ours = 0xaan;
const message = (sequence, text = 'x') => encodeFrame(kinds.message, ours, BigInt(sequence), Buffer.from(text));

/** A node with its daemon and clock; all is closed behind the test. */
async function lab(t) {
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

const added = (id, port, { protocol = 'udp', mode = 'oto', channel = life, change = 'add' } = {}) =>
  `${id} pub ${change} service=0000000b/1/1 provider=0000000b/1 text=x degree=exact distance=0 mode=${mode} address=127.0.0.1 ` +
  `port=${port} protocol=${protocol} priority=0${channel ? ` channel=${channel}` : ''}`;
const consumer = (id, port, channel = life, mode = 'oto') =>
  `${id} sub add subscription=0000000b/1/${port} consumer=0000000b/1 text=x degree=exact distance=0 mode=${mode} ` +
  `address=127.0.0.1 port=${port} priority=0${channel ? ` channel=${channel}` : ''}`;

async function datagramSocket(t) {
  const socket = createSocket('udp4');
  t.after(() => socket.close());
  socket.bind(0, '127.0.0.1');
  await once(socket, 'listening');
  return socket;
}

const sendTo = (socket, octets, port) => new Promise((resolve) => socket.send(octets, port, '127.0.0.1', resolve));

/** A socket that has connected, whose frames are kept. */
async function consumerSocket(t, port, hello) {
  const socket = dial(port, '127.0.0.1');
  socket.on('error', () => {});
  t.after(() => socket.destroy());
  await once(socket, 'connect');
  const decoder = new FrameDecoder(limits.maxStreamMessage);
  socket.frames = [];
  socket.on('data', (octets) => {
    decoder.push(octets);
    for (let frame = decoder.next(); frame; frame = decoder.next()) socket.frames.push(frame);
  });
  if (hello) socket.write(encodeFrame(kinds.hello, hello, 0n));
  return socket;
}

test('connect waits for a daemon that starts later, with back-off', async (t) => {
  const daemon = await new ScriptedDaemon().listen();
  const { port } = daemon;
  await daemon.kill();
  const clock = new ManualClock();
  const coming = connect({ daemon: `127.0.0.1:${port}`, clock, random: () => 0 });
  for (const wait of [100, 200, 400, 800, 1000, 1000]) {
    await until(() => clock.next === wait);
    clock.advance(wait);
  }
  await until(() => clock.next === 1000);
  await daemon.listen(port);
  clock.advance(1000);
  const node = await coming;
  t.after(() => daemon.kill());
  assert.equal(node.hello.participant, '0000000a');
  await node.close();
  await assert.rejects(node.connected(), ClosedError);
});

test('a channel goes on while the daemon is away, and is stated again', async (t) => {
  const all = await lab(t);
  const { daemon, clock, node } = all;
  const publisher = await node.publish({ mode: 'otm/pubsub', text: 'x', attributes: { rate: 30 } });
  const stated = await daemon.line(/^1 pub create/);
  assert.equal(lifeOf(valueOf(stated, 'channel')), publisher.life);
  const socket = await datagramSocket(t);
  daemon.say(consumer(1, socket.address().port, life, 'otm/pubsub'));
  const { change } = await event(publisher, 'consumer');
  assert.equal(change, 'added');
  const heard = [];
  socket.on('message', (octets, { port }) => heard.push([frameOfDatagram(octets), port]));
  publisher.send(Buffer.from('one'));
  const changes = [];
  publisher.on('consumer', (one) => changes.push(one));
  const gone = event(node, 'disconnected');
  await daemon.kill();
  await gone;
  publisher.send(Buffer.from('two'));
  await daemon.listen(daemon.port);
  clock.advance(100);
  await event(node, 'connected');
  assert.equal(await daemon.line(/^1 pub create/), stated);
  daemon.say(consumer(1, socket.address().port, life, 'otm/pubsub').replace('0000000b/1/', '0000000b/7/'));
  await daemon.line(/^0 sys ping/);
  publisher.send(Buffer.from('three'));
  await until(() => heard.length === 3);
  assert.deepEqual(heard.map(([frame, port]) => [frame.sequence, String(frame.payload), port]),
    [[1n, 'one', publisher.port], [2n, 'two', publisher.port], [3n, 'three', publisher.port]]);
  clock.advance(60_000);
  assert.deepEqual(changes, []);
  const closed = publisher.close();
  await until(() => heard.length === 4);
  assert.deepEqual([heard[3][0].kind, heard[3][0].sequence], [kinds.end, 3n]);
  await closed;
  assert.throws(() => publisher.send(Buffer.alloc(0)), ClosedError);
});

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
  const removed = event(subscriber, 'provider');
  await sendTo(provider, encodeFrame(kinds.end, ours, 11n), port);
  assert.deepEqual([(await removed).change, (await removed).reason], ['removed', 'withdrawn']);
  assert.equal(subscriber.statistics.missed, 4);
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
  assert.deepEqual([(await subscriber.receive()).missed, subscriber.statistics.missed], [0, 0]);
});

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
  const early = await consumerSocket(t, publisher.port, ours);
  await until(() => early.bytesWritten === 24);
  publisher.send(Buffer.from('nobody'));
  assert.equal(publisher.statistics.sent, 0);
  const come = event(publisher, 'consumer');
  daemon.say(consumer(1, 1));
  assert.equal((await come).change, 'added');
  publisher.send(Buffer.from('one'));
  await until(() => early.frames.length === 1);
  // A second connection with the same life takes the place of the first, which nobody is told.
  const second = await consumerSocket(t, publisher.port, ours);
  await once(early, 'close');
  publisher.send(Buffer.from('two'));
  await until(() => second.frames.length === 1);
  assert.deepEqual([second.frames[0].sequence, second.frames[0].life], [2n, publisher.life]);
  const lost = event(publisher, 'consumer');
  second.destroy();
  assert.deepEqual([(await lost).change, (await lost).reason], ['removed', 'lost']);
  const again = event(publisher, 'consumer');
  const third = await consumerSocket(t, publisher.port, ours);
  assert.equal((await again).change, 'added');
  // One that no sub add comes for is closed behind 5 s.
  const stranger = await consumerSocket(t, publisher.port, 0xbbn);
  const silent = await consumerSocket(t, publisher.port);
  await until(() => clock.running >= 2);
  clock.advance(limits.strangerPatience);
  await Promise.all([once(stranger, 'close'), once(silent, 'close')]);
  const closed = publisher.close();
  await until(() => third.frames.length === 1);
  assert.equal(third.frames[0].kind, kinds.end);
  await closed;
});

test('of 17 TCP strangers the oldest is closed, and what they say is no more than hello', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'oto', text: 'x', protocol: 'tcp' });
  const talker = await consumerSocket(t, publisher.port);
  talker.write(encodeFrame(kinds.message, 1n, 1n, Buffer.from('x')).subarray(0, 24));
  await once(talker, 'close');
  const strangers = [];
  for (let i = 0; i < limits.maxStrangers; ++i) strangers.push(await consumerSocket(t, publisher.port));
  await until(() => publisher.statistics.dropped === 1);
  const last = await consumerSocket(t, publisher.port);
  await once(strangers[0], 'close');
  assert.equal(strangers[1].destroyed || last.destroyed, false);
});

test('a 257th TCP consumer is closed', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const sockets = [];
  for (let i = 1; i <= limits.maxConsumers; ++i) sockets.push(await consumerSocket(t, publisher.port, BigInt(i)));
  const more = await consumerSocket(t, publisher.port, 1000n);
  await once(more, 'close');
  publisher.send(Buffer.from('x'));
  await until(() => sockets.every(({ frames }) => frames.length === 1));
});

test('who does not read is left out once 4 MiB wait, and holds nobody up', async (t) => {
  const { node } = await lab(t);
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const slow = await consumerSocket(t, publisher.port, 1n);
  const quick = await consumerSocket(t, publisher.port, 2n);
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

test('messages have their largest size', async (t) => {
  const { node } = await lab(t);
  const [udp, tcp] = await Promise.all(['udp', 'tcp'].map((protocol) => node.publish({ mode: 'oto', text: 'x', protocol })));
  assert.equal(udp.send(Buffer.alloc(limits.maxDatagramMessage)), true);
  assert.throws(() => udp.send(Buffer.alloc(limits.maxDatagramMessage + 1)), /protocol=tcp/);
  assert.equal(tcp.send(Buffer.alloc(limits.maxStreamMessage)), true);
  assert.throws(() => tcp.send(Buffer.alloc(limits.maxStreamMessage + 1)), MessageTooLargeError);
  assert.throws(() => tcp.send('text'), TypeError);
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

test('refusals are errors of the call that was refused', async (t) => {
  const { daemon, node } = await lab(t);
  const refusing = ([id]) => [`${id} 422 no such thing`];
  daemon.answers.set('1 pub create', refusing);
  daemon.answers.set('2 sub create', refusing);
  await assert.rejects(node.publish({ mode: 'oto', concept: 'x' }), (error) => error instanceof RefusedError && error.status === 422);
  const subscriber = node.subscribe({ mode: 'oto', concept: 'x' });
  await assert.rejects(subscriber.ready(), RefusedError);
  await assert.rejects(subscriber.receive(), RefusedError);
  await assert.rejects(node.publish({ mode: 'oto' }), { code: 'GEMINGA_STATEMENT' });
  assert.throws(() => node.subscribe({ mode: 'oto', text: 'x', protocol: 'ros' }), { code: 'GEMINGA_STATEMENT' });
});

test('what is taken back ends its channels', async (t) => {
  const { daemon, node } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  await subscriber.ready();
  daemon.say(added(1, 9));
  await event(subscriber, 'provider');
  const removed = event(subscriber, 'provider');
  const problem = event(subscriber, 'problem');
  daemon.say('1 429 taken back: there is no room');
  assert.equal((await problem).status, 429);
  assert.deepEqual([(await removed).change, (await removed).reason], ['removed', 'refused']);
});

test('hello is said at once and each second to an otm/stream, and its end when it is over', async (t) => {
  const { daemon, node, clock } = await lab(t);
  const subscriber = node.subscribe({ mode: 'otm/stream', text: 'x' });
  const provider = await datagramSocket(t);
  const heard = [];
  provider.on('message', (octets, { port }) => heard.push([frameOfDatagram(octets), port]));
  daemon.say(added(1, provider.address().port, { mode: 'otm/stream' }));
  for (let count = 1; count <= 3; ++count) {
    await until(() => heard.length === count);
    clock.advance(limits.helloInterval);
  }
  await until(() => heard.length === 4);
  const { port } = subscriber;
  await subscriber.close();
  await until(() => heard.length === 5);
  assert.deepEqual(heard.map(([{ kind }]) => kind), [2, 2, 2, 2, 3]);
  for (const [frame, from] of heard) {
    assert.deepEqual([frame.life, frame.sequence, frame.payload.readBigUInt64BE(), from], [subscriber.life, 0n, ours, port]);
  }
});

test('an AbortSignal ends whatever waits', async (t) => {
  const { daemon, node } = await lab(t);
  const reason = { name: 'AbortError', code: 'ABORT_ERR' };
  await assert.rejects(connect({ daemon: '127.0.0.1:1', signal: AbortSignal.abort() }), reason);
  const controller = new AbortController();
  const connecting = connect({ daemon: '127.0.0.1:1', signal: controller.signal });
  controller.abort();
  await assert.rejects(connecting, reason);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const receiving = new AbortController();
  const message = subscriber.receive({ signal: receiving.signal });
  receiving.abort();
  await assert.rejects(message, reason);
  const life = new AbortController();
  const other = node.subscribe({ mode: 'oto', text: 'x', signal: life.signal });
  const loop = (async () => {
    for await (const one of other) assert.fail(one);
  })();
  life.abort();
  await assert.rejects(loop, reason);
  await daemon.line(/^2 sub remove/);
});

test('leaving the loop closes the subscription', async (t) => {
  const { daemon, node } = await lab(t);
  const provider = await datagramSocket(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  daemon.say(added(1, provider.address().port));
  await event(subscriber, 'provider');
  await sendTo(provider, message(1, 'only'), subscriber.port);
  for await (const { payload, provider: from } of subscriber) {
    assert.deepEqual([String(payload), from.peer, from.identity], ['only', '0000000b/1', { text: 'x' }]);
    break;
  }
  await daemon.line(/^1 sub remove/);
  assert.equal(await subscriber.receive(), undefined);
});

test('a line that never ends, and lines that mean nothing, cost a connection at most', async (t) => {
  const { daemon, node, clock } = await lab(t);
  for (const line of ['nonsense', '1 pub add', '\u0001', '999 pub add service=x']) daemon.say(line);
  const gone = event(node, 'disconnected');
  daemon.write(Buffer.alloc(limits.maxLine + 3, 'x'));
  await gone;
  await until(() => clock.next === 100);
  clock.advance(100);
  await event(node, 'connected');
});

test('a program may end although a node is unref', async (t) => {
  const { daemon } = await lab(t);
  const program = `
    import { connect } from ${JSON.stringify(new URL('index.js', lib).href)};
    const node = await connect({ daemon: '${daemon.endpoint}' });
    await node.publish({ mode: 'oto', text: 'x', protocol: 'tcp' });
    await node.subscribe({ mode: 'oto', text: 'x' }).ready();
    node.unref();
    process.stdout.write('over');`;
  const child = spawn(process.execPath, ['--input-type=module', '-e', program]);
  let said = '';
  child.stdout.on('data', (octets) => {
    said += octets;
  });
  const [status] = await once(child, 'exit');
  assert.deepEqual([status, said], [0, 'over']);
});
