// Nodes with their daemon: back-off, what is stated again, refusals, AbortSignals, the end of a program.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { test } from 'node:test';

import { frameOfDatagram, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { lifeOf } from '../../../src/client/javascript/lib/protocol/life.js';
import { ClosedError, connect, limits, Node, RefusedError } from '../../../src/client/javascript/lib/index.js';
import { added, consumer, datagramSocket, lab, life, message, sendTo } from './lab.mjs';
import { event, lib, ManualClock, ScriptedDaemon, until, valueOf } from './support.mjs';

test('connect waits for a daemon that starts later, with back-off', async (t) => {
  const daemon = await new ScriptedDaemon().listen();
  const { port } = daemon;
  await daemon.kill();
  const clock = new ManualClock();
  const logged = [];
  const coming = connect({ daemon: `127.0.0.1:${port}`, clock, random: () => 0, log: (line) => logged.push(line) });
  for (const wait of [100, 200, 400]) {
    await until(() => clock.waits.includes(wait));
    clock.advance(wait);
  }
  // After a second it is said once what the program waits for.
  await until(() => clock.waits.includes(800));
  clock.advance(299);
  assert.deepEqual(logged, []);
  clock.advance(1);
  assert.deepEqual(logged.splice(0), [`no daemon at 127.0.0.1:${port} for 1 s (ECONNREFUSED): start gemingad, or say where it is with GEMINGA_CONNECT`]);
  clock.advance(500);
  for (const wait of [1000, 1000]) {
    await until(() => clock.next === wait);
    clock.advance(wait);
  }
  await until(() => clock.next === 1000);
  await daemon.listen(port);
  clock.advance(1000);
  const node = await coming;
  assert.deepEqual(logged, [`the daemon at 127.0.0.1:${port} answers`]);
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

test('a daemon that does not answer the hello is not waited for', async (t) => {
  const server = createServer((socket) => socket.on('error', () => {}).resume()).listen(0, '127.0.0.1');
  t.after(() => server.close());
  await once(server, 'listening');
  const clock = new ManualClock();
  const logged = [];
  const node = new Node({ daemon: `127.0.0.1:${server.address().port}`, clock, random: () => 0, log: (line) => logged.push(line) });
  await once(server, 'connection');
  await until(() => clock.waits.includes(limits.answerPatience));
  clock.advance(limits.answerPatience);
  await until(() => clock.next === 100);
  clock.advance(100);
  await once(server, 'connection');
  assert.match(logged.join(), /^no daemon at 127.0.0.1:[0-9]+ for 1 s \(no answer\): start gemingad/);
  await node.close();
});

test('a daemon that refuses the hello again and again is one line', async (t) => {
  const server = createServer((socket) => {
    socket.on('error', () => {});
    socket.once('data', () => socket.end('0 400 keys is no key of sys hello\r\n'));
  }).listen(0, '127.0.0.1');
  t.after(() => server.close());
  await once(server, 'listening');
  const clock = new ManualClock();
  const logged = [];
  const node = new Node({ daemon: `127.0.0.1:${server.address().port}`, clock, random: () => 0, log: (line) => logged.push(line) });
  for (const wait of [100, 200, 400]) {
    await until(() => clock.waits.includes(wait));
    clock.advance(wait);
  }
  await until(() => clock.waits.includes(800));
  assert.deepEqual(logged, ['keys is no key of sys hello']);
  await node.close();
});

test('what the application is told as a problem is a line of the log, too; without a hook it goes to standard error', async (t) => {
  const { daemon, node, logged } = await lab(t);
  const subscriber = node.subscribe({ mode: 'oto', text: 'x' });
  const problem = event(subscriber, 'problem');
  for (let i = 0; i < 2; ++i) daemon.say(added(1, 9, { protocol: 'ros', change: i === 0 ? 'add' : 'modify' }));
  const text = '0000000b/1/1 has no channel that can be opened: protocol ros';
  assert.equal((await problem).message, text);
  await subscriber.ready();
  assert.deepEqual(logged, [text]);
  daemon.answers.set('2 pub create', ([id]) => [`${id} 422 no such concept`]);
  await assert.rejects(node.publish({ mode: 'oto', concept: 'a:B' }), RefusedError);
  assert.equal(logged[1], 'the request mode=oto concept=a:B is refused: no such concept');
  const program = `import { connect } from ${JSON.stringify(new URL('index.js', lib).href)};
    const node = await connect({ daemon: '${daemon.endpoint}' });
    await node.publish({ mode: 'oto', concept: 'a:B' }).catch(() => {});
    await node.close();`;
  daemon.answers.set('1 pub create', ([id]) => [`${id} 422 no such thing`]);
  const child = spawn(process.execPath, ['--input-type=module', '-e', program]);
  let said = '';
  child.stderr.on('data', (octets) => {
    said += octets;
  });
  await once(child, 'exit');
  assert.equal(said, 'geminga: the request mode=oto concept=a:B is refused: no such thing\n');
});

test('arguments that cannot be are errors of the call, which name the parameter and its values', async (t) => {
  const { node } = await lab(t);
  for (const port of [99999, -1, 1.5, '40001', NaN, null]) {
    await assert.rejects(node.publish({ mode: 'oto', text: 'x', port }), /^StatementError: port=.*: a port is a number from 0 to 65535/);
    assert.throws(() => node.subscribe({ mode: 'oto', text: 'x', port }), /port=.*: a port is a number from 0 to 65535/);
  }
  const publisher = await node.publish({ mode: 'oto', text: 'x' });
  for (const payload of ['text', 7, undefined, null, [1], { length: 1 }, new ArrayBuffer(1)]) {
    assert.throws(() => publisher.send(payload), /^TypeError: payload is a Uint8Array, for example Buffer.from\(text\)/);
  }
  assert.throws(() => new Node({ name: '' }), /name is empty/);
  assert.throws(() => new Node({ name: 'x'.repeat(65) }), /name is too long: at most 64 octets/);
  assert.throws(() => new Node({ name: 7 }), /name is a text/);
  assert.throws(() => new Node({ log: 'x' }), /log is a function/);
  assert.throws(() => new Node({ nmae: 'x' }), /nmae is no option: there are name, daemon, log/);
  await assert.rejects(connect({ demon: 'x' }), /demon is no option/);
  await assert.rejects(node.publish({ mode: 'oto', text: 'x', queue: 3 }), /queue is no option/);
  assert.throws(() => node.subscribe({ mode: 'oto', text: 'x', rat: 3 }), /rat is no option/);
  await assert.rejects(node.publish({ mode: 'otm', text: 'x' }), /mode=otm cannot be read: it must be oto, otm\/stream, otm\/pubsub/);
  await assert.rejects(node.publish({ mode: 'oto', text: '' }), /text= cannot be read: it must be a text that is not empty/);
  await assert.rejects(node.publish(), /mode is missing/);
  assert.throws(() => node.subscribe(), /mode is missing/);
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

test('closing the node while a service is being made leaves nothing open', async (t) => {
  const { node } = await lab(t);
  const making = ['tcp', 'udp'].map((protocol) => node.publish({ mode: 'oto', text: 'x', protocol }));
  const failed = Promise.all(making.map((one) => assert.rejects(one, ClosedError)));
  await node.close();
  await failed;
  await assert.rejects(node.publish({ mode: 'oto', text: 'x' }), ClosedError);
  assert.throws(() => node.subscribe({ mode: 'oto', text: 'x' }), ClosedError);
});
