// The live page in Chromium, with a small team of real daemons: `page.test.mjs PROGRAMS ONTOLOGY PAGE_BUILD SHOTS`. Ends with 77 where
// Chromium or the packages of tools/web/page/build are missing. Pictures of each state are left in SHOTS.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [programs, ontology, pageBuild, shots] = process.argv.slice(2);
const chromium = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((path) => existsSync(path));
const packages = join(pageBuild, 'node_modules/puppeteer-core');
function skip(reason) {
  console.log(`NOT TESTED: ${reason}`);
  process.exit(77);
}
if (!chromium) skip('Chromium is not installed: apt-get install chromium');
if (!existsSync(packages)) skip('puppeteer-core is not there: run tools/web/page/build');
const { resolve } = createRequire(join(pageBuild, 'package.json'));
const puppeteer = (await import(pathToFileURL(resolve('puppeteer-core')).href)).default;
const axe = readFileSync(resolve('axe-core/axe.min.js'), 'utf8');
mkdirSync(shots, { recursive: true });

const patience = 60_000;
const started = [];
const hostile = '<img src=x onerror="document.title=1">';

const freePort = () =>
  new Promise((found) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => found(port));
    });
  });

function start(program, ...words) {
  const child = spawn(join(programs, program), words, { stdio: ['ignore', 'ignore', 'pipe'] });
  child.words = '';
  child.stderr.on('data', (data) => (child.words += data));
  started.push(child);
  return child;
}

const ended = (child) => new Promise((done) => (child.exitCode === null && child.signalCode === null ? child.once('exit', done) : done()));

/** A connection, once somebody listens at the port. */
async function connection(port) {
  for (const end = Date.now() + patience; ; ) {
    const socket = await new Promise((done) => {
      const one = connect(port, '127.0.0.1', () => done(one)).on('error', () => done(undefined));
    });
    if (socket) return socket.on('error', () => {}).resume();
    assert.ok(Date.now() < end, `nobody listens at ${port}: ${started.map((child) => child.words).join('')}`);
    await new Promise((soon) => setTimeout(soon, 50));
  }
}

const udp = await freePort();
const folder = mkdtempSync(join(tmpdir(), 'geminga-page-'));
const team = `page-${process.pid}`;
const ports = {};
async function daemon(name, files) {
  ports[name] ??= await freePort();
  return start('gemingad', '--name', name, '--interface', 'lo', '--gcnp', `127.0.0.1:${ports[name]}`, '--port', String(udp), '--group', team,
    '--interval', '0.5', ...files.flatMap((file) => ['--ontology', join(ontology, file)]));
}
async function state(name, peer, ...lines) {
  const socket = await connection(ports[name]);
  socket.write([`0 sys hello name=${JSON.stringify(peer)}`, ...lines, ''].join('\r\n'));
  return socket;
}

let browser;
try {
  const all = ['core.ttl', 'robot-soccer.ttl'];
  let monitor = await daemon('monitor', all);
  let robot1 = await daemon('robot1', all);
  await daemon('robot2', ['core.ttl']);
  await daemon(hostile, all);
  const offer = ['1 pub create mode=otm/stream concept=soccer:BallInfo port=5000', '2 pub create mode=otm/stream concept=soccer:SharedWorldInfo port=5001'];
  await state('robot1', 'Vision', ...offer);
  await state(hostile, hostile, '1 pub create mode=otm/stream concept=soccer:BallInfo port=5002', `2 pub create mode=oto text=${JSON.stringify(hostile)} port=5003`,
    '3 pub create mode=otm/pubsub concept=soccer:BallInfo representation=soccer:PolarFieldFrame port=5004');
  const requests = ['1 sub create mode=otm/stream concept=soccer:BallInfo', '2 sub create mode=otm/stream concept=soccer:TrackedObject',
    '3 sub create mode=otm/stream concept=soccer:GoalInfo', '4 sub create mode=otm/stream concept=soccer:BallInfo limit=1',
    '5 sub create mode=otm/pubsub concept=soccer:BallInfo representation=soccer:CartesianFieldFrame convert=yes'];
  await state('monitor', 'LebtClient', ...requests);

  const recording = join(folder, 'team.jsonl');
  const http = await freePort();
  const rules = join(folder, 'alerts.toml');
  const rule = (name, concept, seconds) => `[[rule]]\nname = ${JSON.stringify(name)}\nconcept = "${concept}"\nat-least = 1\nfor = ${seconds}\n`;
  writeFileSync(rules, rule(hostile, 'soccer:SharedWorldInfo', 1) + rule('goal', 'soccer:GoalInfo', 3600));
  const web = start('geminga-web', '--connect', `127.0.0.1:${ports.monitor}`, '--listen', `127.0.0.1:${http}`, '--rules', rules);
  (await connection(http)).destroy();
  browser = await puppeteer.launch({
    executablePath: chromium,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
  const page = await browser.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error' && !/Failed to load resource|ERR_/.test(message.text())) complaints.push(message.text());
  });
  await page.setViewport({ width: 1440, height: 1000 });
  await page.goto(`http://127.0.0.1:${http}/`);
  const until = (what, ...words) =>
    page.waitForFunction(what, { timeout: patience }, ...words).catch(async (error) => {
      console.log(await page.evaluate(() => document.body.innerText)); // what was seen instead
      throw error;
    });
  const says = (selector, text) => until((where, word) => document.querySelector(where)?.textContent.includes(word), selector, text);
  const saysNot = (selector, text) => until((where, word) => !document.querySelector(where)?.textContent.includes(word), selector, text);
  const shoot = (name) => page.screenshot({ path: join(shots, `${name}.png`), fullPage: true });
  const inOrder = async () => {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html).slice(0, 2)}`), []);
  };

  // A request that nobody serves, another ontology, and a name that would be markup.
  await says('#wrong', 'Nobody serves soccer:GoalInfo');
  await says('#wrong', 'Nobody offers it, nor anything below or above it: start ');
  await says('#wrong', 'robot2: another ontology');
  await says('#picture', hostile.slice(0, 14));
  await until(() => document.querySelectorAll('.line.exact').length >= 2 && document.querySelectorAll('.line.narrower').length >= 1);
  assert.equal(await page.$('img'), null);
  assert.equal(await page.title(), 'Geminga: the team');
  await shoot('team');
  const recorder = start('geminga-query', '--connect', `127.0.0.1:${ports.monitor}`, 'record', recording);
  await inOrder();

  // The doctor sees that the team shares one host; its remedy is shown.
  await says('#wrong', 'More than one gemingad runs on this host');
  await page.click('.findings button[data-key^="doctor two_daemons"]');
  await says('#detail', 'Stop all but one.');
  await page.keyboard.press('Escape');

  // A rule whose count is wrong and not yet for its time waits; one that holds is not told.
  await says('#wrong', 'Alert goal waits: 0 services, wanted at least 1; wrong for ');
  await saysNot('#wrong', `Alert ${hostile}`);

  // The reason of a request leads to the place, by the keyboard alone.
  await page.focus('.findings button[data-key^="request"]');
  await page.keyboard.press('Enter');
  await until(() => document.querySelector('.box.chosen') !== null);
  await page.$eval('[data-key="box robot1"]', (element) => element.focus());
  await page.keyboard.press('Enter');
  await says('#detail', 'Vision');
  await page.click('.chip');
  await says('#detail', 'asks for');
  await page.click('.links button');
  await says('#detail', 'They meet');
  await shoot('why');
  await inOrder();
  await page.keyboard.press('Escape');

  // The steps of a conversion, and the code of what is outranked.
  await until(() => document.querySelector('.line.converted title')?.textContent.includes('soccer:PolarFieldFrame → soccer:CartesianFieldFrame'));
  await until(() => document.querySelector('.line.refused title')?.textContent.includes('incumbent'));

  // A filter that is an expression, with names that begin so; and one by mode.
  await page.type('#filter', 'soccer:SharedW');
  await until(() => [...document.querySelectorAll('#filter-names option')].some((one) => one.value === 'soccer:SharedWorldInfo'));
  await page.$eval('#filter', (input) => {
    input.value = 'soccer:SharedBallInfo or soccer:SharedWorldInfo';
    input.dispatchEvent(new Event('input'));
  });
  await until(() => document.querySelectorAll('.line').length === 0);
  await page.$eval('#filter', (input) => {
    input.value = '';
    input.dispatchEvent(new Event('input'));
  });
  await until(() => document.querySelectorAll('.line').length > 1);

  // The matrix of who hears whom, by what each says; the ontology node by node, with reasons.
  await says('#hearing', 'Each row says whom it hears');
  await page.focus('.matrix');
  await page.keyboard.press('ArrowDown');
  await until(() => / hears .*: [0-9]+ % lost/.test(document.querySelector('output.cell').textContent));
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowLeft');
  await until(() => / hears monitor: (within|longer|not known)/.test(document.querySelector('output.cell').textContent));
  await says('#ontology', 'geminga:Concept');
  await says('#ontology .counts', 'offered');
  await page.$eval('#ontology summary', (element) => element.focus());
  await page.keyboard.press('Enter');
  await until(() => document.querySelectorAll('#ontology .below summary').length > 3);
  await page.type('#class-search', 'sharedball');
  await says('#ontology', 'soccer:SharedBallInfo');
  await until(() => document.querySelectorAll('#ontology .tree summary').length < 6);
  await page.$eval('#ontology summary', (element) => element.focus());
  await page.keyboard.press('Enter');
  await page.waitForSelector('#ontology .parents button');
  await page.click('#ontology .parents button');
  await says('#ontology .parents', 'SubClassOf');
  await page.$$eval('#ontology button', (buttons) => buttons.find((one) => one.textContent === 'What differs').click());
  await says('#ontology', 'nothing is seen of its ontology but the digest');
  await shoot('ontology');
  await inOrder();

  // The question that nobody has stated, its last name completed.
  await page.type('#if-concept', 'soccer:BallInfo or soccer:TrackedOb');
  await until(() => document.querySelector('#if-concept-names option')?.value === 'soccer:BallInfo or soccer:TrackedObject');
  await page.$eval('#if-concept', (input) => {
    input.value = '';
  });
  await page.type('#if-concept', 'soccer:TrackedObject');
  await page.keyboard.press('Enter');
  await says('#detail', 'would serve it');
  await shoot('what-if');
  await page.$eval('#if-concept', (input) => {
    input.value = 'soccer:Nothing at all';
  });
  await page.click('#detail form button');
  await until(() => document.querySelector('#detail .error') !== null);

  // A robot is switched off: it stays in its place as gone, and is there again when it returns.
  const place = () => page.$eval('[data-key="box robot1"]', (element) => element.getAttribute('transform'));
  const before = await place();
  robot1.kill('SIGKILL');
  await ended(robot1);
  await says('#wrong', 'robot1 is gone');
  assert.equal(await place(), before);
  // With it goes the only service that a rule counts: its alert stands first, and is over when the robot is there again.
  await says('.findings li:first-child.error', `Alert ${hostile}: 0 services, wanted at least 1; wrong for `);
  await says('.alerts', `${hostile}: 0 services, wanted at least 1 (soccer:SharedWorldInfo)`);
  await page.click('.findings li:first-child button');
  await says('#detail', 'It counts soccer:SharedWorldInfo.');
  await page.keyboard.press('Escape');
  assert.equal(await page.$('img'), null);
  await shoot('gone');
  robot1 = await daemon('robot1', all);
  await state('robot1', 'Vision', ...offer);
  await saysNot('#wrong', 'robot1 is gone');
  await until(() => document.querySelector('[data-key="box robot1"]:not(.gone)') !== null);
  assert.equal(await place(), before);
  await says('#timeline', 'robot1 came');
  await says('#timeline', 'no more: robot1 is gone');
  await says('#timeline', `no more: ${hostile}: 0 services`);
  await saysNot('#wrong', `Alert ${hostile}`);

  // A page that is opened after that knows it from the hour that geminga-web keeps.
  const later = await browser.newPage();
  await later.goto(`http://127.0.0.1:${http}/`);
  await later.waitForFunction(() => document.querySelector('#timeline').textContent.includes('robot1 went'), { timeout: patience });
  await later.close();
  await page.bringToFront();
  await says('#timeline', 'robot1 came');

  // Back in time: robot1 is gone again, and before this page was opened matches are not known.
  const wasGone = await page.$$eval('.happenings li', (items) => items.some((item) => item.textContent.includes('robot1 went')));
  assert.ok(wasGone);
  await page.focus('#moment');
  await page.keyboard.press('Home');
  await says('#absence', 'You look at');
  await says('.note:not([hidden])', 'not all matches are known');
  await page.keyboard.press('End');
  await until(() => document.querySelector('#absence').hidden);

  // Dark, and on a phone.
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }, { name: 'prefers-reduced-motion', value: 'reduce' }]);
  await inOrder();
  await shoot('dark');
  await page.setViewport({ width: 390, height: 844, isMobile: true });
  await says('#wrong', 'Nobody serves soccer:GoalInfo');
  await until(() => document.querySelectorAll('.line').length > 1);
  await until(() => document.documentElement.scrollWidth <= window.innerWidth);
  await until(() => document.querySelector('#picture svg rect').getBoundingClientRect().width < 1.3 * 168);
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'light' }]);
  await shoot('phone');
  await page.setViewport({ width: 1440, height: 1000 });
  await says('#wrong', 'Nobody serves soccer:GoalInfo');

  // The daemon is away, and back; then geminga-web itself.
  monitor.kill('SIGKILL');
  await ended(monitor);
  await says('#absence', 'The daemon is away');
  await shoot('away');
  monitor = await daemon('monitor', all);
  await state('monitor', 'LebtClient', ...requests);
  await until(() => document.querySelector('#absence').hidden);
  await says('#wrong', 'Nobody serves soccer:GoalInfo');
  web.kill('SIGKILL');
  await says('#absence', 'geminga-web does not answer');

  // A recording of all that: its end, and its beginning, when robot1 had not gone yet.
  recorder.kill('SIGINT');
  await ended(recorder);
  const shown = await freePort();
  start('geminga-web', '--recording', recording, '--listen', `127.0.0.1:${shown}`);
  (await connection(shown)).destroy();
  await page.goto(`http://127.0.0.1:${shown}/`);
  await says('#absence', 'You look at the recording team.jsonl');
  await saysNot('#wrong', 'Alert ');
  await says('#timeline', 'robot1 went');
  await says('#wrong', 'Nobody serves soccer:GoalInfo');
  const lines = () => document.querySelectorAll('.line').length > 0;
  await until(lines);
  await page.focus('#moment');
  await page.keyboard.press('Home');
  await until(() => document.querySelector('#absence').textContent.includes(document.querySelector('output[for=moment]').textContent));
  await until(lines);
  await saysNot('#wrong', 'robot1 is gone');
  await shoot('recording');
  await inOrder();
  assert.deepEqual(complaints, []);
  console.log(`The page did as it says; pictures are in ${shots}`);
} finally {
  await browser?.close();
  for (const child of started) child.kill('SIGKILL');
  rmSync(folder, { recursive: true });
}
process.exit(0);
