// The main thread of the page with 100 robots, 2000 services and ten changes a second, beside an empty page: `load.mjs PAGE PAGE_BUILD
// [SECONDS]`. The team is imagined by this script, and so is an hour in which as many changes were kept as may be, so that memory that still
// grows is a leak. Prints milliseconds of script, style and layout a second and a frame, and the heap after a collection, six times on the way.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [file, pageBuild, told = '20'] = process.argv.slice(2);
const { resolve } = createRequire(join(process.cwd(), pageBuild, 'package.json'));
const puppeteer = (await import(pathToFileURL(resolve('puppeteer-core')).href)).default;
const robots = 100;
const perRobot = 20;
const id = (robot) => (0x10000000 + robot).toString(16);
const participants = Array.from({ length: robots }, (_, robot) => ({ id: id(robot), name: `robot${robot}`, addresses: ['192.0.2.1'], heard: 1, interval: 2, loss: 0,
  ontology: '0', publications: perRobot, subscriptions: perRobot, self: robot === 0 }));
const ids = participants.map((one) => one.id);
const entry = (robot, at) => ({ name: `module${at % 5}`, participant_name: `robot${robot}`, concept: `soccer:C${at}`, mode: 'otm/stream', priority: 0, local: false, attributes: {} });
const each = (made) => participants.flatMap((_, robot) => Array.from({ length: perRobot }, (_, at) => made(robot, at)));
const services = each((robot, at) => ({ service: `${id(robot)}/${at % 5}/${at}`, provider: `${id(robot)}/${at % 5}`, used: true, ...entry(robot, at) }));
const requests = each((robot, at) => ({ subscription: `${id(robot)}/${at % 5}/${at}`, consumer: `${id(robot)}/${at % 5}`, match: 'narrower', limit: 0, served: true,
  provider: `robot${(robot + at) % robots}`, ...entry(robot, at) }));
const listings = { participants, services, requests };

/** The hour that geminga-web has kept, full to its limit of changes. */
const kept = 20_000;
const began = Date.now() - 3_500_000;
const at = (share) => new Date(began + share * 3_500_000).toISOString();
const history = JSON.stringify({
  begin: at(0), before: listings,
  changes: Array.from({ length: kept }, (_, turn) => ({ of: 'services', event: 'modify', time: at(turn / kept), reason: '', record: { ...services[(turn * 7) % services.length], priority: turn } })),
  samples: Array.from({ length: 350 }, (_, turn) => [at(turn / 350), 2000, 2000, 0, 0.1, 0.05, turn * 100]),
});

const server = createServer((request, response) => {
  const url = new URL(request.url, 'http://127.0.0.1');
  if (url.pathname === '/') return response.setHeader('content-type', 'text/html').end(readFileSync(file));
  if (url.pathname === '/empty') return response.setHeader('content-type', 'text/html').end('<!doctype html><title>empty</title>');
  if (url.pathname === '/api/history') return response.setHeader('content-type', 'application/json').end(history);
  if (url.pathname !== '/api/events') {
    const kind = url.pathname.slice('/api/'.length);
    const answers = { participants, requests: [], status: { name: 'robot0', datagrams_received: 0 }, ontology: { loaded: true, digest: '0', failed: [], others: [], files: [], left_out: [], gaps: [] },
      taxonomy: url.searchParams.has('class') ? { total: 0, classes: [] } : { total: 20, classes: Array.from({ length: 20 }, (_, at) => ({ class: `soccer:C${at}`, children: 0, offers: robots, requests: robots })) },
      hearing: participants.slice(1).map(({ id: witness, name }) => ({ witness, name, quarter: ids.slice(0, 40), half: ids.slice(40, 70), whole: ids.slice(70) })), security: { participants: [] }, doctor: { findings: [] }, alerts: [],
      match: services.filter((one) => one.concept === url.searchParams.get('concept')).map((one) => ({ ...one, degree: 'exact', distance: 0 })) };
    return response.setHeader('content-type', 'application/json').end(JSON.stringify(answers[kind] ?? {}));
  }
  response.setHeader('content-type', 'text/event-stream');
  const tell = (kind, event, record) => response.write(`event: ${kind}\ndata: ${JSON.stringify({ event, time: new Date().toISOString(), ...record })}\n\n`);
  for (const [kind, listing] of Object.entries(listings)) for (const record of listing) tell(kind, 'add', record);
  response.write('event: whole\ndata: {}\n\n');
  let turn = kept;
  const timer = setInterval(() => tell('services', 'modify', { ...services[(++turn * 7) % services.length], priority: turn }), 100);
  return request.on('close', () => clearInterval(timer));
}).listen(0, '127.0.0.1');
await new Promise((listening) => server.once('listening', listening));

const browser = await puppeteer.launch({ protocolTimeout: 0, executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking'] });
for (const path of ['/empty', '/']) {
  const seconds = path === '/' ? Number(told) : Math.min(20, Number(told));
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.log(error.message));
  await page.setViewport({ width: 1440, height: 1000 });
  await page.goto(`http://127.0.0.1:${server.address().port}${path}`);
  await new Promise((settled) => setTimeout(settled, 8000));
  // Time of the thread by its own clock, so that other programs on the machine do not count.
  const session = await page.createCDPSession();
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  const measured = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return Object.fromEntries((await session.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]));
  };
  const before = await measured();
  const parts = 6;
  const heap = [before.JSHeapUsedSize];
  let frames = 0;
  for (let part = 0; part < parts; ++part) {
    frames += await page.evaluate((span) => new Promise((done) => {
      let count = 0;
      const end = performance.now() + span;
      const next = () => (++count, performance.now() < end ? requestAnimationFrame(next) : done(count));
      next();
    }), (seconds * 1000) / parts);
    heap.push((await measured()).JSHeapUsedSize);
  }
  const after = await measured();
  if (process.env.SHOT) await page.screenshot({ path: process.env.SHOT, fullPage: true });
  const spent = (after.TaskDuration - before.TaskDuration) * 1000;
  console.log(`${path}: ${(spent / seconds).toFixed(0)} ms a second, ${(spent / frames).toFixed(2)} ms a frame (${frames} frames), ` +
    `heap after collections ${heap.map((octets) => (octets / 1e6).toFixed(2)).join(', ')} MB, ${before.Nodes} then ${after.Nodes} nodes`);
  await page.close();
}
await browser.close();
process.exit(0);
