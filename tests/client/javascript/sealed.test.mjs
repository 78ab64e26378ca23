// Sealed channels on real sockets, with a daemon that gives keys as the test tells it to, and a clock that stands still.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';

import { ChannelKeys } from '../../../src/client/javascript/lib/protocol/channel_keys.js';
import { encodeFrame, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { ConsumerFrames, PublisherFrames } from '../../../src/client/javascript/lib/protocol/frame_writer.js';
import { writeHandshake } from '../../../src/client/javascript/lib/protocol/handshake.js';
import { lifeText } from '../../../src/client/javascript/lib/protocol/life.js';
import { limits } from '../../../src/client/javascript/lib/index.js';
import { added, consumer, consumerSocket, datagramSocket, heardBy, helloOf, lab, life, ours, sendTo } from './lab.mjs';
import { event, until, valueOf } from './support.mjs';

/** Keys by their ids, each of octets of its own. */
const octetsOf = (id) => [id, Buffer.alloc(32, id & 255), Buffer.alloc(32, (id & 255) + 1)];
const keysOf = (mode, ids) => new ChannelKeys(mode, mode === 'plain' ? [] : ids.map(octetsOf));
const hex = (id) => octetsOf(id).map((part) => (typeof part === 'number' ? part.toString(16).padStart(4, '0') : part.toString('hex'))).join(':');
const keyLine = (id, of, mode, ids) =>
  `${id} pub keys life=${of} mode=${mode}${mode === 'plain' ? '' : ` ring=${ids.map(hex).join(',')}`}`;
const key = 0x0a41;
const other = 0x0b61;

const channels = [['oto', 'udp'], ['otm/pubsub', 'udp'], ['otm/stream', 'udp'], ['oto', 'tcp'], ['otm/pubsub', 'tcp'], ['otm/stream', 'tcp']];

/** A publisher and a subscriber of one node that are told of each other, with functions that give each of them other keys. */
async function meet(t, { mode, protocol, sealing, address, ids = [key] }) {
  const all = await lab(t, { sealing });
  const { daemon, node } = all;
  const told = [];
  const offering = node.publish({ mode, text: 'x', protocol, address });
  const offer = await daemon.line(/ pub create/);
  const publisher = await offering;
  publisher.on('consumer', ({ change, reason }) => told.push(`consumer ${change} ${reason ?? '-'}`));
  const subscriber = node.subscribe({ mode, text: 'x' });
  subscriber.on('provider', ({ change, reason }) => told.push(`provider ${change} ${reason ?? '-'}`));
  const wish = await daemon.line(/ sub create/);
  const [p, s] = [offer, wish].map((line) => /^[0-9]+/.exec(line)[0]);
  const channel = valueOf(offer, 'channel');
  const toPublisher = (now, ring = ids) => daemon.say(keyLine(p, channel, now, ring));
  const toSubscriber = (now, ring = ids) => daemon.say(keyLine(s, channel, now, ring));
  const tell = () => {
    if (mode !== 'otm/stream') daemon.say(consumer(p, Number(valueOf(wish, 'port')), valueOf(wish, 'channel'), mode));
    daemon.say(added(s, publisher.port, { protocol, mode, channel }).replace('address=127.0.0.1', `address=${address ?? '127.0.0.1'}`));
  };
  if (sealing) {
    toPublisher(sealing);
    toSubscriber(sealing);
  }
  tell();
  await until(() => publisher.hasConsumer && told.includes('provider added -'));
  return { ...all, publisher, subscriber, told, p, s, channel, toPublisher, toSubscriber, tell };
}

/** Waits until the node has heard all that the daemon said. */
async function heardAll(daemon, node) {
  const heard = event(node, 'problem');
  daemon.say('0 400 that is all');
  await heard;
}

/** Lets time pass, with turns in which the sockets are read. */
async function pass({ clock, daemon, node }, milliseconds) {
  for (let left = milliseconds; left > 0; left -= 500) {
    clock.advance(Math.min(left, 500));
    for (let i = 0; i < 3; ++i) await heardAll(daemon, node);
  }
}

/** Sends messages, and receives each of them. */
async function exchange({ publisher, subscriber }, count) {
  const first = publisher.statistics.sent + 1;
  for (let i = 0; i < count; ++i) publisher.send(Buffer.from(`m${first + i}`));
  for (let i = 0; i < count; ++i) {
    const { payload, missed } = await subscriber.receive();
    assert.deepEqual([String(payload), missed], [`m${first + i}`, 0]);
  }
}

test('each mode and protocol delivers in order, and ends', async (t) => {
  for (const [mode, protocol] of channels) {
    for (const sealing of ['prepared', 'mixed', 'authenticated', 'encrypted']) {
      const met = await meet(t, { mode, protocol, sealing });
      await exchange(met, 10);
      const payload = Buffer.alloc(60_000, 7);
      met.publisher.send(payload);
      assert.deepEqual(Buffer.from((await met.subscriber.receive()).payload), payload);
      await met.publisher.close();
      const isSealedUdp = sealing !== 'prepared' || protocol === 'tcp';
      if (isSealedUdp) await until(() => met.told.includes('provider removed withdrawn'));
      const { missed, dropped } = met.subscriber.statistics;
      assert.deepEqual([missed, dropped, met.logged], [0, 0, []], `${mode} ${protocol} ${sealing}`);
    }
  }
});

test('over multicast the first authentic frame asks for a floor, and what was sent before it is not delivered', async (t) => {
  const met = await meet(t, { mode: 'otm/stream', protocol: 'udp', sealing: 'encrypted', address: '239.195.47.17' });
  const { publisher, subscriber } = met;
  let sent = 0;
  while (subscriber.statistics.dropped === 0) {
    publisher.send(Buffer.from(`m${++sent}`));
    await new Promise((resolve) => setImmediate(resolve));
  }
  let first;
  subscriber.receive().then((one) => { first = one; });
  while (!first) {
    publisher.send(Buffer.from(`m${++sent}`));
    await new Promise((resolve) => setImmediate(resolve));
  }
  assert.ok(first.sequence > 1n);
  assert.deepEqual([first.missed, String(first.payload)], [0, `m${first.sequence}`]);
});

test('nothing is sent or answered before the keys are known', async (t) => {
  for (const protocol of ['udp', 'tcp']) {
    const { daemon, node } = await lab(t, { sealing: 'encrypted' });
    const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol });
    const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
    const keys = keysOf('encrypted', [key]);
    const hello = new ConsumerFrames(7n).write(keys, kinds.hello, writeHandshake(publisher.life, 3n, 0n));
    if (protocol === 'udp') {
      const socket = await datagramSocket(t);
      const heard = heardBy(socket, keys);
      await sendTo(socket, hello, publisher.port);
      await until(() => publisher.statistics.dropped === 1);
      daemon.say(keyLine(id, lifeText(publisher.life), 'encrypted', [key]));
      await heardAll(daemon, node);
      await sendTo(socket, new ConsumerFrames(7n, 1).write(keys, kinds.hello, writeHandshake(publisher.life, 3n, 0n)), publisher.port);
      await until(() => heard.length === 1);
      assert.equal(heard[0].kind, kinds.floor);
    } else {
      const socket = await consumerSocket(t, publisher);
      socket.write(hello);
      await until(() => socket.bytesWritten === hello.length);
      assert.deepEqual([publisher.hasConsumer, socket.frames], [false, []]);
      daemon.say(keyLine(id, lifeText(publisher.life), 'encrypted', [key]));
      await until(() => socket.frames.length === 1);
      assert.equal(keys.takeForward(socket.frames[0]).kind, kinds.floor);
    }
    assert.equal(publisher.statistics.sent, 0);
  }
});

test('a publisher accepts no plain hello, no recorded one, none of another key, and writes a stranger no message', async (t) => {
  const { daemon, node, clock } = await lab(t, { sealing: 'encrypted' });
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x' });
  const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
  daemon.say(keyLine(id, lifeText(publisher.life), 'encrypted', [key]));
  await heardAll(daemon, node);
  const keys = keysOf('encrypted', [key]);
  const socket = await datagramSocket(t);
  const heard = heardBy(socket, keys);
  const frames = new ConsumerFrames(7n);
  const say = async (challenge, cookie, kind = kinds.hello) => {
    const octets = frames.write(keys, kind, writeHandshake(publisher.life, challenge, cookie));
    await sendTo(socket, octets, publisher.port);
    return octets;
  };
  const first = await say(3n, 0n);
  await until(() => heard.length === 1 || publisher.statistics.dropped > 0);
  const { cookie } = heard[0].said;
  const recorded = await say(3n, cookie);
  await until(() => publisher.hasConsumer && heard.length === 2);
  assert.equal(heard[1].said.cookie, 0n);
  // A recording, by its counter; a plain hello or end; frames of another key.
  const before = publisher.statistics.dropped;
  const forged = [recorded, first, helloOf(7n, publisher, 3n, cookie), encodeFrame(kinds.end, 7n, 0n, writeHandshake(publisher.life, 3n, cookie)),
    new ConsumerFrames(7n, 50).write(keysOf('encrypted', [other]), kinds.end, writeHandshake(publisher.life, 3n, cookie))];
  for (const octets of forged) await sendTo(socket, octets, publisher.port);
  await until(() => publisher.statistics.dropped === before + forged.length);
  assert.equal(publisher.hasConsumer, true);
  await say(3n, cookie, kinds.end);
  await until(() => !publisher.hasConsumer);
  // The recording opens nothing again, neither from here after 16 s nor from elsewhere.
  clock.advance(2 * limits.cookiePatience);
  const elsewhere = await datagramSocket(t);
  const answers = heardBy(elsewhere, keys);
  await sendTo(socket, recorded, publisher.port);
  await sendTo(elsewhere, recorded, publisher.port);
  await until(() => answers.length === 1 && heard.length === 3);
  assert.notEqual(answers[0].said.cookie, 0n);
  assert.notEqual(heard[2].said.cookie, 0n);
  assert.equal(publisher.hasConsumer, false);
});

test('over TCP a consumer says hello twice, with the cookie of its connection, and a stranger is sent nothing', async (t) => {
  const { daemon, node } = await lab(t, { sealing: 'encrypted' });
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
  daemon.say(keyLine(id, lifeText(publisher.life), 'encrypted', [key]));
  await heardAll(daemon, node);
  const keys = keysOf('encrypted', [key]);
  const strangers = [];
  for (let i = 1; i <= 8; ++i) strangers.push(await consumerSocket(t, publisher, BigInt(i)));
  await until(() => strangers.every(({ destroyed }) => destroyed));
  assert.ok(strangers.every(({ frames }) => frames.length === 0));
  const frames = new ConsumerFrames(7n);
  const hello = (challenge, cookie) => frames.write(keys, kinds.hello, writeHandshake(publisher.life, challenge, cookie));
  const socket = await consumerSocket(t, publisher);
  const first = hello(3n, 0n);
  socket.write(first);
  await until(() => socket.frames.length === 1);
  const { cookie } = readFloor(keys, socket.frames[0]);
  const second = hello(3n, cookie);
  socket.write(second);
  await until(() => publisher.hasConsumer && socket.frames.length === 2);
  assert.equal(readFloor(keys, socket.frames[1]).cookie, 0n);
  // Recorded hellos are answered by another cookie, and then the connection ends.
  const replay = await consumerSocket(t, publisher);
  replay.write(first);
  await until(() => replay.frames.length === 1);
  replay.write(second);
  await until(() => replay.destroyed);
  publisher.send(Buffer.from('one'));
  await until(() => socket.frames.length === 3);
  assert.equal(String(keys.takeForward(socket.frames[2]).payload), 'one');
  assert.equal(replay.frames.length, 1);
});

const readFloor = (keys, frame) => {
  const { kind, payload } = keys.takeForward(frame);
  assert.equal(kind, kinds.floor);
  return { life: payload.readBigUInt64BE(0), challenge: payload.readBigUInt64BE(8), cookie: payload.readBigUInt64BE(16) };
};

test('a subscriber delivers no plain, forged or recorded frame, and believes only a sealed end', async (t) => {
  const { daemon, node } = await lab(t, { sealing: 'encrypted' });
  const subscriber = node.subscribe({ mode: 'otm/pubsub', text: 'x' });
  const provider = await datagramSocket(t);
  const keys = keysOf('encrypted', [key]);
  const heard = heardBy(provider, keys);
  const { port } = provider.address();
  const frames = Object.assign(new PublisherFrames(ours), { keys });
  const recorded = [frames.message(Buffer.from('yesterday'))];
  daemon.say(keyLine(1, life, 'encrypted', [key]));
  daemon.say(added(1, port, { mode: 'otm/pubsub' }));
  await until(() => heard.length === 1);
  const { challenge } = heard[0].said;
  const floor = (to, back, cookie) => frames.other(kinds.floor, writeHandshake(to, back, cookie));
  const oldFloor = floor(subscriber.life, challenge ^ 1n, 0n);
  for (const octets of [...recorded, oldFloor]) await sendTo(provider, octets, subscriber.port);
  await until(() => subscriber.statistics.dropped === 2);
  await sendTo(provider, floor(subscriber.life, challenge, 9n), subscriber.port);
  await until(() => heard.length === 2);
  assert.equal(heard[1].said.cookie, 9n);
  const removed = event(subscriber, 'provider', ({ change }) => change === 'removed');
  const first = frames.message(Buffer.from('today'));
  const bad = [encodeFrame(kinds.message, ours, 0xffffffffffffffffn, Buffer.from('forged')), encodeFrame(kinds.end, ours, 3n),
    encodeFrame(kinds.floor, ours, 0xffffffffffffffffn, writeHandshake(subscriber.life, challenge, 0n)),
    Object.assign(new PublisherFrames(ours, false, 90), { keys: keysOf('encrypted', [other]) }).message(Buffer.from('forged'))];
  for (const octets of [...bad, first, first]) await sendTo(provider, octets, subscriber.port);
  const { payload, missed, sequence } = await subscriber.receive();
  assert.deepEqual([String(payload), missed, sequence], ['today', 0, 2n]);
  await sendTo(provider, frames.end(), subscriber.port);
  assert.equal((await removed).reason, 'withdrawn');
  assert.equal(subscriber.statistics.received, 1);
});

test('a team goes from plain to sealed and back, whichever side goes first, and nothing is lost', async (t) => {
  for (const [mode, protocol] of channels) {
    for (const isPublisherFirst of [true, false]) {
      const met = await meet(t, { mode, protocol });
      await exchange(met, 2);
      for (const step of ['prepared', 'mixed', 'encrypted', 'authenticated', 'encrypted']) {
        met.daemon.say(`0 msg sealing mode=${step}`);
        const tellings = [met.toPublisher, met.toSubscriber];
        for (const tell of isPublisherFirst ? tellings : tellings.reverse()) {
          tell(step);
          await exchange(met, 2); // perhaps before the node has heard it
          await heardAll(met.daemon, met.node);
          await exchange(met, 2);
        }
        await pass(met, limits.strangerPatience);
        await exchange(met, 2);
      }
      for (const tell of [met.toPublisher, met.toSubscriber]) tell('plain');
      await heardAll(met.daemon, met.node);
      await pass(met, limits.strangerPatience);
      await exchange(met, 2);
      assert.deepEqual(met.told.filter((one) => one.includes('removed')), [], `${mode} ${protocol}`);
      assert.deepEqual([met.subscriber.statistics.missed, met.publisher.statistics.sent], [0, 54]);
      await Promise.all([met.publisher.close(), met.subscriber.close()]);
    }
  }
});

test('where plain frames are taken no more, a TCP consumer proves itself by a sealed hello with the cookie of its connection, in 5 s', async (t) => {
  const { daemon, node, clock } = await lab(t, { sealing: 'mixed' });
  const publisher = await node.publish({ mode: 'otm/stream', text: 'x', protocol: 'tcp' });
  const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
  const say = async (mode) => {
    daemon.say(keyLine(id, lifeText(publisher.life), mode, [key]));
    await heardAll(daemon, node);
  };
  await say('prepared');
  const keys = keysOf('encrypted', [key]);
  const frames = new ConsumerFrames(7n);
  const hello = (cookie, challenge = 1n) => frames.write(keys, kinds.hello, writeHandshake(publisher.life, challenge, cookie));
  const recorded = hello(5n);
  const [good, silent] = [await consumerSocket(t, publisher, 7n), await consumerSocket(t, publisher, 8n)];
  await until(() => [good, silent].every(({ bytesWritten }) => bytesWritten === 48) && publisher.hasConsumer);
  await pass({ clock, daemon, node }, 1);
  await say('mixed');
  await until(() => good.frames.length === 1);
  assert.equal(readFloor(keys, good.frames[0]).cookie, 0n);
  await say('encrypted');
  await until(() => good.frames.length === 2);
  const { cookie } = readFloor(keys, good.frames[1]);
  assert.notEqual(cookie, 0n);
  const before = publisher.statistics.dropped;
  for (const octets of [recorded, hello(cookie ^ 1n), hello(cookie, 2n), helloOf(7n, publisher, 1n, cookie)]) good.write(octets);
  await until(() => publisher.statistics.dropped === before + 4);
  good.write(hello(cookie));
  await until(() => good.frames.length === 3);
  assert.equal(readFloor(keys, good.frames[2]).cookie, 0n);
  publisher.send(Buffer.from('x'));
  await pass({ clock, daemon, node }, limits.strangerPatience - 1);
  assert.deepEqual([good, silent].map(({ destroyed }) => destroyed), [false, false]);
  assert.ok(silent.frames.length > 8); // it was asked again and again
  await pass({ clock, daemon, node }, limits.askInterval);
  await until(() => silent.destroyed);
  assert.equal(good.destroyed, false);
});

test('over UDP a frame of a key that the daemon has not told yet is kept for a second', async (t) => {
  for (const mode of ['oto', 'otm/stream']) {
    const met = await meet(t, { mode, protocol: 'udp', sealing: 'encrypted' });
    await exchange(met, 1);
    met.toPublisher('encrypted', [other, key]);
    await heardAll(met.daemon, met.node);
    for (let i = 2; i <= 4; ++i) met.publisher.send(Buffer.from(`m${i}`));
    await until(() => met.subscriber.statistics.dropped === 3);
    met.toSubscriber('encrypted', [key, other]);
    for (let i = 2; i <= 4; ++i) assert.equal(String((await met.subscriber.receive()).payload), `m${i}`);
    await exchange(met, 1);
    assert.deepEqual([met.subscriber.statistics.dropped, met.subscriber.statistics.missed], [0, 0]);
  }
});

test('a rotation of keys loses nothing', async (t) => {
  for (const [mode, protocol] of channels) {
    const met = await meet(t, { mode, protocol, sealing: 'encrypted' });
    for (const ring of [[key], [key, other], [other, key], [other]]) {
      met.toPublisher('encrypted', ring);
      await exchange(met, 3);
      met.toSubscriber('encrypted', ring);
      await exchange(met, 3);
      await pass(met, limits.helloInterval);
      await exchange(met, 3);
    }
    assert.equal(met.subscriber.statistics.missed, 0);
  }
});

test('services without a life are not connected where plain frames are not taken, and that is told once', async (t) => {
  for (const [sealing, isConnected] of [['mixed', true], ['authenticated', false], ['encrypted', false]]) {
    const { daemon, node, logged } = await lab(t, { sealing });
    const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
    await subscriber.ready();
    const provider = await datagramSocket(t);
    for (const change of ['add', 'modify']) daemon.say(added(1, provider.address().port, { channel: '', change }));
    await event(subscriber, 'provider');
    const publisher = await node.publish({ mode: 'oto', text: 'x' });
    const id = /^[0-9]+/.exec(await daemon.line(/ pub create/))[0];
    daemon.say(keyLine(id, lifeText(publisher.life), sealing, [key]));
    for (let i = 0; i < 2; ++i) daemon.say(consumer(id, provider.address().port, ''));
    if (isConnected) {
      await event(publisher, 'consumer');
      await sendTo(provider, Buffer.from('plain'), subscriber.port);
      assert.equal(String((await subscriber.receive()).payload), 'plain');
      const [, heard] = [publisher.send(Buffer.from('too')), await new Promise((resolve) => provider.once('message', resolve))];
      assert.equal(String(heard), 'too');
      assert.deepEqual(logged, []);
      continue;
    }
    await event(publisher, 'problem');
    const text = (service) => `${service} states no life, so its channel cannot be sealed`;
    assert.deepEqual(logged, [text('0000000b/1/1'), text(`0000000b/1/${provider.address().port}`)]);
    assert.equal(publisher.hasConsumer, false);
  }
});

test('keys that cannot be used open no channel, and that is told; no key is shown anywhere', async (t) => {
  const { daemon, node, logged } = await lab(t, { sealing: 'encrypted' });
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const told = [];
  for (const name of ['provider', 'problem']) subscriber.on(name, (one) => told.push(one));
  await subscriber.ready();
  daemon.say(`1 pub keys life=${life} mode=newest ring=${hex(key)}`);
  daemon.say(added(1, 9));
  await event(subscriber, 'provider');
  assert.deepEqual(logged, ['the daemon names a mode of sealing that this library does not know']);
  const met = await meet(t, { mode: 'oto', protocol: 'udp', sealing: 'encrypted' });
  await exchange(met, 1);
  const shown = [node, subscriber, met.node, met.publisher, met.subscriber, told, logged, met.logged, met.publisher.statistics, met.node.hello,
    met.publisher.consumers].map((one) => inspect(one, { depth: 20, showHidden: true })).join('\n');
  for (const secret of ['4141', '41 41', '65, 65', '4242', '42 42', 'AAAA', 'BBBB']) assert.equal(shown.includes(secret), false, secret);
});
