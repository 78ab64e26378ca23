// Comings, goings and changes of the last hour in a lane for each robot, alerts in one above them, and a slider that goes to any moment.
import { alertsOf, type Alert } from './alerts.js';
import { identityText, type Participant, type Request, type Service } from './answers.js';
import { h, refill, shortened, svg } from './dom.js';
import type { Happening } from './team.js';
import { clock, teamNow } from './time.js';

const second = 1000;
const lane = 22;
const left = 100;
const leastWidth = 340;
const maxListed = 12;
/** Marks in one lane that lie nearer than this share of the width are one. */
const nearest = 0.008;

export class Timeline {
  private readonly slider: HTMLInputElement;
  private readonly words = h('output', { for: 'moment' }, 'now');
  private readonly back = h('button', { type: 'button', class: 'small', hidden: true, click: () => this.set(0) }, 'Back to now');
  private readonly lanes = svg('svg', { class: 'lanes', role: 'img', 'aria-label': 'Comings and goings by robot', preserveAspectRatio: 'none' });
  private readonly laneBox = h('div', { class: 'lane-box', tabindex: 0, role: 'region', 'aria-label': 'Lanes of the robots', hidden: true });
  private readonly list = h('ol', { class: 'happenings' });
  private readonly alerts = h('ol', { class: 'happenings' });
  private end = teamNow();
  private endWord = 'now';
  private drawn = 0;
  private told = '';
  /** The instant at a share of the width of the lanes. */
  private timeAt: (x: number) => number = () => this.end;

  /** `look` is told the instant to look at, or nothing for the present. */
  constructor(
    private readonly parent: HTMLElement,
    private readonly look: (time: number | undefined) => void,
  ) {
    this.slider = h('input', { id: 'moment', type: 'range', min: -1, max: 0, value: 0, step: 1, input: () => this.set(Number(this.slider.value)) });
    this.laneBox.append(this.lanes);
    this.lanes.addEventListener('click', (event) => {
      const { left: from, width } = this.lanes.getBoundingClientRect();
      this.set(Math.max(Number(this.slider.min), Math.min(0, Math.round((this.timeAt((event.clientX - from) / width) - this.end) / second))));
    });
    parent.append(h('div', { class: 'scrub' }, h('label', { for: 'moment' }, 'Look at'), this.slider, this.words, this.back),
      this.laneBox, h('div', { class: 'columns' }, h('div', {}, h('h3', {}, 'Alerts'), this.alerts), h('div', {}, h('h3', {}, 'Latest'), this.list)));
  }

  /** Says that the end is that of a recording. */
  beRecording(): void {
    this.endWord = 'the end';
    this.words.textContent = this.endWord;
    this.back.textContent = 'To the end';
  }

  /** Draws anew once a second at most. `end` is the present, or where a recording ends; `byRules` are alerts beside those that the happenings tell. */
  draw(happenings: Happening[], since: number, end: number, byRules: Alert[]): void {
    if (Date.now() - this.drawn < second) return;
    this.drawn = Date.now();
    this.end = end;
    this.slider.min = String(-Math.max(1, Math.round((end - since) / second)));
    const shown = happenings.filter((one) => one.time >= since);
    const span = Math.max(60_000, end - since);
    // Marks move by less than a pixel within a hundredth of a per cent of the span.
    const width = Math.max(leastWidth, this.laneBox.clientWidth || this.parent.clientWidth);
    const told = [width, shown.length, shown.at(-1)?.time ?? 0, byRules.length, byRules.at(-1)?.time ?? 0, Math.round(end / Math.max(1000, span / 1000))].join();
    if (told === this.told) return;
    this.told = told;
    const byName = new Map<string, Happening[]>();
    for (const one of shown) {
      const known = byName.get(nameOf(one));
      if (known === undefined) byName.set(nameOf(one), [one]);
      else known.push(one);
    }
    const names = [...byName.keys()].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).slice(0, 100);
    const alerts = [...alertsOf(shown, end), ...byRules.filter((one) => one.time >= since)].sort((a, b) => a.time - b.time);
    const first = alerts.length === 0 ? 0 : 1;
    const placeOf = (time: number): number => left + (1 - (end - time) / span) * (width - left - 10);
    const rows = names.map((name, index) => laneOf(name, byName.get(name) ?? [], index + first, (one) => placeOf(one.time), width));
    this.timeAt = (x) => end - (1 - (x * width - left) / (width - left - 10)) * span;
    this.lanes.setAttribute('viewBox', `0 0 ${width} ${Math.max(1, names.length + first) * lane}`);
    this.laneBox.hidden = names.length + first === 0;
    refill(this.lanes, ...(first === 0 ? [] : [alertLane(alerts, placeOf, width)]), ...rows);
    refill(this.alerts, ...(alerts.length === 0 ? [h('li', {}, 'None.')] : alerts.slice(-maxListed).reverse().map((one) =>
      h('li', {}, h('time', {}, clock(one.time)), h('span', { class: one.isMended ? 'good' : 'bad' }, one.isMended ? ' ✓ no more: ' : ' ✕ '), one.text))));
    const latest = groupsOf(shown);
    refill(this.list, ...(latest.length === 0 ? [h('li', {}, 'Nothing has changed.')] : latest.map((group) =>
      h('li', { class: group[0]?.event ?? '' }, h('time', {}, clock(group[0]?.time ?? 0)), ` ${sentence(group)}`))));
  }

  private set(seconds: number): void {
    this.slider.value = String(seconds);
    const time = seconds === 0 ? undefined : this.end + seconds * second;
    this.words.textContent = time === undefined ? this.endWord : clock(time);
    this.back.hidden = time === undefined;
    this.look(time);
  }
}

/** The happenings of one robot: one path for all that came, all that changed and all that went. */
function laneOf(name: string, happenings: Happening[], at: number, placeOf: (one: Happening) => number, width: number): SVGElement {
  const y = at * lane + lane / 2;
  const paths = { add: '', modify: '', del: '' };
  let last = -Infinity;
  for (const one of happenings) {
    const x = placeOf(one);
    const isRobot = one.kind === 'participants' && one.event !== 'modify';
    if (!isRobot && x - last < nearest * width) continue;
    last = x;
    const half = isRobot ? 7 : 3.5;
    paths[one.event] += `M${(x - half / 2).toFixed(1)} ${y - half}h${half}v${2 * half}h${-half}z`;
  }
  return svg('g', {}, svg('line', { x1: left, x2: width - 10, y1: y, y2: y, class: 'lane' }), svg('text', { x: 0, y: y + 4 }, shortened(name, 14)),
    ...(['modify', 'add', 'del'] as const).filter((event) => paths[event] !== '').map((event) => svg('path', { d: paths[event], class: `mark-${event}` })));
}

function alertLane(alerts: Alert[], placeOf: (time: number) => number, width: number): SVGElement {
  return svg('g', { class: 'alerts' }, svg('line', { x1: left, x2: width - 10, y1: lane / 2, y2: lane / 2, class: 'lane' }),
    svg('text', { x: 0, y: lane / 2 + 4 }, 'alerts'), ...alerts.map((one) =>
      svg('path', { d: `M${placeOf(one.time).toFixed(1)} ${lane / 2 + (one.isMended ? 7 : -7)} l5 ${one.isMended ? -12 : 12} h-10 z`, class: one.isMended ? 'mark-add' : 'mark-del' },
        svg('title', {}, `${clock(one.time)} ${one.isMended ? 'no more: ' : ''}${one.text}`))));
}

const nameOf = (one: Happening): string =>
  one.kind === 'participants' ? (one.record as Participant).name : (one.record as Service | Request).participant_name;

/** The latest happenings, those of one module in one second together, the latest first. */
function groupsOf(happenings: Happening[]): Happening[][] {
  const groups: Happening[][] = [];
  const isAlike = (a: Happening, b: Happening): boolean => a.kind !== 'participants' && a.kind === b.kind && a.event === b.event &&
    a.reason === b.reason && clock(a.time) === clock(b.time) && nameOf(a) === nameOf(b) && a.record.name === b.record.name;
  for (const one of happenings.slice(-maxListed * maxListed).reverse()) {
    const last = groups.at(-1);
    if (last?.[0] !== undefined && isAlike(last[0], one)) last.push(one);
    else if (groups.push([one]) > maxListed) break;
  }
  return groups.slice(0, maxListed);
}

function sentence(group: Happening[]): string {
  const [one] = group as [Happening];
  const word = { add: 'came', modify: 'changed', del: one.reason === '' || one.reason === 'gone' ? 'went' : `went (${one.reason})` }[one.event];
  if (one.kind === 'participants') return `${nameOf(one)} ${word}`;
  const names = [...new Set(group.map(({ record }) => identityText(record as Service | Request)))];
  const kind = one.kind === 'services' ? 'service' : 'request';
  return `${nameOf(one)} ${one.record.name}: the ${group.length === 1 ? kind : `${kind}s`} ${shortened(names.join(', '), 120)} ${word}`;
}
