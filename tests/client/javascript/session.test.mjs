// Requests over several connections to daemons, and counterparts: without sockets, by a clock of the test.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Timers } from '../../../src/client/javascript/lib/channels/clock.js';
import { readEvent } from '../../../src/client/javascript/lib/protocol/event.js';
import * as limits from '../../../src/client/javascript/lib/protocol/limits.js';
import { Counterparts } from '../../../src/client/javascript/lib/protocol/counterparts.js';
import { merged, Session } from '../../../src/client/javascript/lib/protocol/session.js';
import { parseStatement } from '../../../src/client/javascript/lib/protocol/statement.js';
import { ManualClock } from './support.mjs';

/** A session whose lines are kept; `take()` gives those since the last call. */
function session() {
  const lines = [];
  const problems = [];
  const connected = [];
  const modes = [];
  const logged = [];
  const made = new Session('me', {
    write: (line) => lines.push(line),
    onConnected: (hello) => connected.push(hello),
    onSealing: (mode) => modes.push(mode),
    onProblem: (error) => problems.push(error),
    log: (line) => logged.push(line),
  });
  const create = (command, parameters, onEvent, onProblem, onKeys = () => {}) => {
    const created = made.create(command, parameters, { onEvent, onProblem, onKeys });
    followed(created.taken);
    return created;
  };
  return { made, create, problems, connected, modes, logged, take: () => lines.splice(0), say: (line) => made.receive(Buffer.from(line)) };
}

const offer = [['mode', 'oto'], ['text', 'x'], ['port', '5000']];
const ping = '0 sys ping';

const states = new WeakMap();

/** Keeps what becomes of a promise, from now on. */
function followed(promise) {
  states.set(promise, 'open');
  promise.then(() => states.set(promise, 'taken'), (error) => states.set(promise, error.message));
  return promise;
}

/** The state of a promise after the present turn. */
async function stateOf(promise) {
  await new Promise((resolve) => setImmediate(resolve));
  return states.get(promise);
}

test('a request is stated when there is a connection, and again with the next', async () => {
  const { made, create, take, say, connected } = session();
  const { taken } = create('pub', offer, () => {}, () => {});
  assert.deepEqual(take(), []);
  made.start();
  assert.deepEqual(take(), ['0 sys hello name=me keys=yes', '1 pub create mode=oto text=x port=5000', ping]);
  say('0 msg hello version=1 participant=0000000a peer=3');
  assert.equal(connected[0].peer, '3');
  assert.equal(await stateOf(taken), 'open');
  say('0 msg pong');
  assert.equal(await stateOf(taken), 'taken');
  made.lose();
  made.start();
  assert.deepEqual(take(), ['0 sys hello name=me keys=yes', '1 pub create mode=oto text=x port=5000', ping]);
});

test('what was not answered when the connection went is answered by the next one', async () => {
  const { made, create, say } = session();
  made.start();
  const { taken } = create('pub', offer, () => {}, () => {});
  made.lose();
  assert.equal(await stateOf(taken), 'open');
  made.start();
  say('0 msg pong');
  assert.equal(await stateOf(taken), 'taken');
});

test('what was refused is not stated again', async () => {
  const { made, create, take, say } = session();
  made.start();
  const { request, taken } = create('pub', offer, () => {}, () => assert.fail('told twice'));
  say('1 422 text=x: no');
  say('0 msg pong');
  assert.equal(await stateOf(taken), 'text=x: no');
  made.lose();
  take();
  made.start();
  assert.deepEqual(take(), ['0 sys hello name=me keys=yes']);
  assert.throws(() => made.modify(request, [['port', '1']]), { code: 'GEMINGA_REFUSED' });
  await made.remove(request);
});

test('503 is no refusal: it is stated again', async () => {
  const { made, create, take, say } = session();
  made.start();
  const { taken } = create('pub', offer, () => {}, () => {});
  say('1 503 the daemon is stopping');
  say('0 msg pong');
  assert.equal(await stateOf(taken), 'open');
  made.lose();
  take();
  made.start();
  assert.equal(take().length, 3);
});

test('what is taken back is a problem, and is not stated again', async () => {
  const { made, create, take, say } = session();
  const told = [];
  made.start();
  const { request } = create('pub', offer, () => {}, (error) => told.push(`${error.status} ${request.isRefused}`));
  say('0 msg pong');
  say('1 429 taken back: there is no room');
  say('1 429 taken back: there is no room');
  assert.deepEqual(told, ['429 true']);
  made.lose();
  take();
  made.start();
  assert.equal(take().length, 1);
});

test('a change is part of what is stated again once it was taken, and not where it was refused', async () => {
  const { made, create, take, say } = session();
  made.start();
  const { request } = create('pub', [...offer, ['rate', '1']], () => {}, () => {});
  say('0 msg pong');
  take();
  const good = followed(made.modify(request, [['rate', '2'], ['scope', 'host']]));
  const bad = followed(made.modify(request, [['for', 'rate >']]));
  const waiting = followed(made.modify(request, [['priority', '3']]));
  assert.deepEqual(take(), ['1 pub modify scope=host rate=2', ping, '1 pub modify for="rate >"', ping, '1 pub modify priority=3', ping]);
  say('0 msg pong');
  say('1 422 for: no');
  say('0 msg pong');
  assert.equal(await stateOf(good), 'taken');
  assert.equal(await stateOf(bad), 'for: no');
  made.lose();
  assert.equal(await stateOf(waiting), 'open');
  made.start();
  assert.deepEqual(take().slice(1),
    ['1 pub create mode=oto text=x port=5000 scope=host rate=2', ping, '1 pub modify priority=3', ping]);
  say('0 msg pong');
  say('0 msg pong');
  assert.equal(await stateOf(waiting), 'taken');
});

test('changes take the place of what was, and empty ones take it back', () => {
  const stated = [['mode', 'oto'], ['concept', 'a:B'], ['representation', 'a:R'], ['scope', 'host'], ['rate', '1']];
  assert.deepEqual(merged(stated, [['concept', 'a:C']]),
    [['mode', 'oto'], ['representation', 'a:R'], ['scope', 'host'], ['rate', '1'], ['concept', 'a:C']]);
  assert.deepEqual(merged(stated, [['text', 'x']]), [['mode', 'oto'], ['scope', 'host'], ['rate', '1'], ['text', 'x']]);
  assert.deepEqual(merged(stated, [['representation', ''], ['scope', ''], ['rate', '']]),
    [['mode', 'oto'], ['concept', 'a:B'], ['rate', '']]);
});

test('lines that mean nothing are counted and cost nothing else', async () => {
  const { made, create, say, problems } = session();
  made.start();
  const heard = [];
  const { request } = create('sub', offer.slice(0, 2), (event) => heard.push(event), () => {});
  const event = `${request.id} pub add service=0000000a/1/1 provider=0000000a/1 text=x degree=exact distance=0 mode=oto port=1 protocol=udp priority=0`;
  const bad = ['', 'HTTP/1.1 400 Bad Request', `${request.id} pub add`, event.replace('1 pub', '77 pub'), event.replace('pub', 'sub'),
    `${event} x="`, '1 call home', '0 msg', '\u0001'];
  for (const line of bad) say(line);
  made.receive(Buffer.from([0xff, 0xfe]));
  assert.equal(made.dropped, bad.length + 1);
  say('0 msg lagged');
  say('0 msg something new=1');
  say('0 429 closed: too many');
  assert.equal(problems.length, 1);
  say(event);
  assert.equal(heard.length, 1);
});

/** Counterparts, and in words what happened to them. `tcp` holds the keys of the peers that have a live connection. */
function book({ limit = 0, isOfPublisher = false } = {}) {
  const clock = new ManualClock();
  const told = [];
  const tcp = new Set();
  const held = new Set();
  const of = (peer) => peer.event.attributes.channel ?? peer.service;
  const made = new Counterparts(new Timers(clock), {
    added: (peer) => told.push(`added ${of(peer)}`),
    modified: (peer, before, isTold) => isTold && told.push(`modified ${of(peer)}`),
    removed: (peer, reason) => told.push(`removed ${of(peer)} ${reason}`),
    endPatience: () => limits.endPatience,
    orphanPatience: (peer) => (peer.event.protocol === 'udp' ? limits.orphanPatience : tcp.has(peer.key) ? Infinity : 0),
    isHeld: (peer) => held.has(peer.key),
    isOfPublisher,
  });
  made.limit = limit;
  const say = (line) => made.onEvent(readEvent(parseStatement(line)));
  return { made, clock, tcp, held, say, take: () => told.splice(0) };
}

const a = '000000000000000a';
const b = '000000000000000b';
const add = (service, life, { change = 'add', protocol = 'udp', more = '' } = {}) =>
  `1 pub ${change} service=${service} provider=0000000a/1 text=x degree=exact distance=0 mode=oto address=10.0.0.1 port=1 ` +
  `protocol=${protocol} priority=0${life ? ` channel=${life}` : ''}${more}`;
const del = (service, reason) => `1 pub del service=${service} reason=${reason}`;

test('a provider is told as it comes, changes and goes', () => {
  const { say, take, clock } = book();
  say(add('s/1/1', a));
  say(add('s/1/1', a, { change: 'modify', more: ' rate=3' }));
  say(add('s/1/1', a, { change: 'modify', more: ' rate=3' }));
  say(del('s/1/1', 'outranked'));
  say(del('s/1/1', 'outranked'));
  say(add('s/1/1', a, { change: 'modify' }));
  assert.deepEqual(take(), [`added ${a}`, `modified ${a}`, `removed ${a} outranked`]);
  say(add('s/2/2'));
  say(del('s/2/2', 'changed'));
  assert.deepEqual(take(), ['added s/2/2', 'removed s/2/2 changed']);
  assert.equal(clock.running, 0);
});

test('another life under the same word is another channel, and the former one is lost sight of', () => {
  const { say, take, clock } = book();
  say(add('s/1/1', a));
  say(add('s/1/1', b, { change: 'modify' }));
  assert.deepEqual(take(), [`added ${a}`, `added ${b}`]);
  clock.advance(limits.orphanPatience - 1);
  assert.deepEqual(take(), []);
  clock.advance(1);
  assert.deepEqual(take(), [`removed ${a} changed`]);
});

test('daemons may give two lives each other\'s words, and nothing has changed', () => {
  const { say, take, clock } = book();
  say(add('s/1/1', a));
  say(add('s/1/2', b));
  say(add('s/1/1', b, { change: 'modify' }));
  say(add('s/1/2', a, { change: 'modify' }));
  clock.advance(1000 * limits.orphanPatience);
  assert.deepEqual(take(), [`added ${a}`, `added ${b}`]);
  say(del('s/1/1', 'outranked'));
  assert.deepEqual(take(), [`removed ${b} outranked`]);
});

test('a life with two words goes on while it has one', () => {
  const { say, take } = book();
  say(add('s/1/1', a));
  say(add('t/1/1', a, { more: ' rate=3' }));
  say(del('t/1/1', 'withdrawn'));
  assert.deepEqual(take(), [`added ${a}`, `modified ${a}`, `modified ${a}`]);
  say(del('s/1/1', 'changed'));
  assert.deepEqual(take(), [`removed ${a} changed`]);
});

test('the time of an orphan does not run while the own daemon is away, too', () => {
  const { made, say, take, clock } = book();
  say(add('s/1/1', a));
  say(del('s/1/1', 'expired'));
  clock.advance(limits.orphanPatience - 1);
  made.onDaemonLost();
  clock.advance(3_600_000);
  assert.deepEqual(take(), [`added ${a}`]);
  made.onDaemonBack();
  clock.advance(limits.confirmPatience - 1);
  say(add('t/1/1', a));
  clock.advance(3_600_000);
  assert.deepEqual(take(), []);
  say(del('t/1/1', 'expired'));
  made.onDaemonLost();
  made.onDaemonBack();
  clock.advance(limits.confirmPatience + limits.orphanPatience);
  assert.deepEqual(take(), [`removed ${a} disconnected`]);
});

test('what was withdrawn and only drains ends while the own daemon is away, and goes on if it is added again', () => {
  for (const isAdded of [false, true]) {
    const { made, say, take, clock } = book();
    say(add('s/1/1', a));
    say(del('s/1/1', 'withdrawn'));
    made.onDaemonLost();
    if (isAdded) say(add('t/1/1', a));
    clock.advance(limits.endPatience);
    assert.deepEqual(take(), isAdded ? [`added ${a}`] : [`added ${a}`, `removed ${a} withdrawn`]);
  }
});

test('a consumer that is outranked when daemons have come back is lost sight of for 10 s, a provider ends', () => {
  for (const isOfPublisher of [true, false]) {
    const { made, say, take, clock } = book({ isOfPublisher });
    say(add('s/1/1', a));
    made.onDaemonLost();
    made.onDaemonBack();
    say(add('t/1/1', a));
    clock.advance(limits.confirmPatience - 1);
    say(del('t/1/1', 'outranked'));
    say(add('t/1/1', a));
    assert.deepEqual(take(), isOfPublisher ? [`added ${a}`] : [`added ${a}`, `removed ${a} outranked`, `added ${a}`]);
    clock.advance(1);
    say(del('t/1/1', 'outranked'));
    assert.deepEqual(take(), [`removed ${a} outranked`]);
  }
});

test('keys go to their request and nowhere else, and a line that is wrong shows nothing of them', () => {
  const { made, create, say, problems, modes, logged } = session();
  const key = '0123456789abcdef'.repeat(4);
  made.start();
  const heard = [];
  const events = [];
  create('sub', offer.slice(0, 2), (event) => events.push(event), () => {}, (...all) => heard.push(all));
  say('0 msg pong');
  say(`1 pub keys life=${a} mode=encrypted ring=6208:${key}:${key}`);
  say(`1 pub keys life=${a} mode=encrypted ring=6208:${key}:${key}x`);
  say(`1 pub keys life=${a} mode=encrypted ring=6208:${key}:${key} "`);
  say(`2 pub keys life=${a} mode=encrypted ring=6208:${key}:${key}`);
  say('0 msg sealing mode=mixed');
  assert.deepEqual([heard.length, events, problems, modes, made.dropped], [2, [], [], ['mixed'], 1]);
  assert.deepEqual([heard[0][0], heard[0][1].mode, heard[1][0], heard[1][1]], [10n, 'encrypted', 10n, undefined]);
  assert.match(heard[1][2].message, /^the daemon gives a key that cannot be read$/);
  assert.equal(JSON.stringify([logged, String(heard[1][2].stack)]).includes('0123'), false);
});

test('a refusal is said with the mode and the identity of its request', () => {
  const { made, create, say, logged } = session();
  made.start();
  create('pub', [['mode', 'oto'], ['text', 'two words'], ['port', '5000'], ['rate', '3']], () => {}, () => {});
  say('1 422 no such thing');
  say('0 msg pong');
  assert.deepEqual(logged, ['the request mode=oto text="two words" is refused: no such thing']);
});

test('a withdrawn one is read until nothing comes for 2 s, but for the time in which nobody reads', () => {
  const { made, say, take, clock, held } = book();
  say(add('s/1/1', a));
  say(del('s/1/1', 'withdrawn'));
  clock.advance(limits.endPatience - 1);
  made.touch(made.find(10n));
  clock.advance(limits.endPatience - 1);
  held.add(a);
  clock.advance(10 * limits.endPatience);
  held.clear();
  assert.deepEqual(take(), [`added ${a}`]);
  clock.advance(limits.endPatience);
  assert.deepEqual(take(), [`removed ${a} withdrawn`]);
});

test('whom the daemons lost sight of goes on over UDP for 10 s, or until it is back', () => {
  const { say, take, clock } = book();
  say(add('s/1/1', a));
  say(del('s/1/1', 'expired'));
  clock.advance(limits.orphanPatience - 1);
  say(add('t/9/9', a));
  clock.advance(limits.orphanPatience);
  assert.deepEqual(take(), [`added ${a}`]);
  say(del('t/9/9', 'left'));
  clock.advance(limits.orphanPatience);
  assert.deepEqual(take(), [`removed ${a} left`]);
});

test('over TCP it goes on as long as its connection', () => {
  const { made, say, take, clock, tcp } = book();
  say(add('s/1/1', a, { protocol: 'tcp' }));
  say(add('s/1/2', b, { protocol: 'tcp' }));
  tcp.add(a);
  say(del('s/1/1', 'expired'));
  say(del('s/1/2', 'expired'));
  clock.advance(1000 * limits.orphanPatience);
  assert.deepEqual(take(), [`added ${a}`, `added ${b}`, `removed ${b} expired`]);
  made.remove(made.find(10n), 'expired');
  assert.deepEqual(take(), [`removed ${a} expired`]);
});

test('an orphan is closed where the request has its limit of others', () => {
  const { say, take } = book({ limit: 1 });
  say(add('s/1/1', a));
  say(del('s/1/1', 'expired'));
  assert.deepEqual(take(), [`added ${a}`]);
  say(add('s/1/2', b));
  assert.deepEqual(take(), [`added ${b}`, `removed ${a} expired`]);
});

test('while the own daemon is away nothing is removed; 10 s behind its return what it did not confirm is an orphan', () => {
  const { made, say, take, clock } = book();
  say(add('s/1/1', a));
  say(add('s/1/2', b));
  take();
  made.onDaemonLost();
  clock.advance(3_600_000);
  made.onDaemonBack();
  say(add('u/7/1', a));
  clock.advance(limits.confirmPatience - 1);
  made.onDaemonLost();
  clock.advance(3_600_000);
  made.onDaemonBack();
  say(add('v/8/1', a));
  clock.advance(limits.confirmPatience + limits.orphanPatience - 1);
  assert.deepEqual(take(), []);
  clock.advance(1);
  assert.deepEqual(take(), [`removed ${b} disconnected`]);
  clock.advance(3_600_000);
  assert.deepEqual(take(), []);
});
