// Comings, goings and changes of the last hour in a lane for each robot, alerts in one above them, and a slider that goes to any moment.
import { alertsOf, type Alert } from './alerts.js';
import type { Participant, Request, Service } from './answers.js';
import { clock, h, refill, svg } from './dom.js';
import type { Happening } from './team.js';

const second = 1000;
const lane = 22;
const left = 100;
const leastWidth = 340;
/** Marks in one lane that lie nearer than this share of the width are one. */
const nearest = 0.008;

export class Timeline {
  private readonly slider: HTMLInputElement;
  private readonly words = h('output', { for: 'moment' }, 'now');
  private readonly back = h('button', { type: 'button', class: 'small', hidden: true, click: () => this.set(0) }, 'Back to now');
  private readonly lanes = svg('svg', { class: 'lanes', role: 'img', 'aria-label': 'Comings and goings by robot', preserveAspectRatio: 'none' });
  private readonly list = h('ol', { class: 'happenings' });
  private readonly alerts = h('ol', { class: 'happenings' });
  private end = Date.now();
  private endWord = 'now';
  private drawn = 0;
  private told = '';

  /** `look` is told the instant to look at, or nothing for the present. */
  constructor(
    private readonly parent: HTMLElement,
    private readonly look: (time: number | undefined) => void,
  ) {
    this.slider = h('input', { id: 'moment', type: 'range', min: -1, max: 0, value: 0, step: 1, input: () => this.set(Number(this.slider.value)) });
    parent.append(h('div', { class: 'scrub' }, h('label', { for: 'moment' }, 'Look at'), this.slider, this.words, this.back),
      this.lanes, h('div', { class: 'columns' }, h('div', {}, h('h3', {}, 'Alerts'), this.alerts), h('div', {}, h('h3', {}, 'Latest'), this.list)));
  }

  /** Says that the end is that of a recording. */
  beRecording(): void {
    this.endWord = 'the end';
    this.words.textContent = this.endWord;
    this.back.textContent = 'To the end';
  }

  /** Draws anew once a second at most. `end` is the present, or where a recording ends. */
  draw(happenings: Happening[], since: number, end: number): void {
    if (Date.now() - this.drawn < second) return;
    this.drawn = Date.now();
    this.end = end;
    this.slider.min = String(-Math.max(1, Math.round((end - since) / 1000)));
    const shown = happenings.filter((one) => one.time >= since);
    const span = Math.max(60_000, end - since);
    // Marks move by less than a pixel within a hundredth of a per cent of the span.
    const width = Math.max(leastWidth, this.parent.clientWidth);
    const told = [width, shown.length, shown.at(-1)?.time ?? 0, Math.round(end / Math.max(1000, span / 1000))].join();
    if (told === this.told) return;
    this.told = told;
    const byName = new Map<string, Happening[]>();
    for (const one of shown) {
      const known = byName.get(nameOf(one));
      if (known === undefined) byName.set(nameOf(one), [one]);
      else known.push(one);
    }
    const names = [...byName.keys()].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).slice(0, 100);
    const alerts = alertsOf(shown, end);
    const first = alerts.length === 0 ? 0 : 1;
    const placeOf = (time: number): number => left + (1 - (end - time) / span) * (width - left - 10);
    const rows = names.map((name, index) => {
      const at = index + first;
      const marks: SVGElement[] = [];
      let last = -1;
      for (const one of byName.get(name) ?? []) {
        const share = 1 - (end - one.time) / span;
        if (one.kind !== 'participants' && share - last < nearest) continue;
        last = share;
        const size = one.kind === 'participants' ? 7 : 3.5;
        marks.push(svg('rect', { x: placeOf(one.time) - size / 2, y: at * lane + lane / 2 - size, width: size, height: size * 2, class: `mark-${one.event}` },
          svg('title', {}, `${clock(one.time)} ${sentence(one)}`)));
      }
      return svg('g', {}, svg('line', { x1: left, x2: width - 10, y1: at * lane + lane / 2, y2: at * lane + lane / 2, class: 'lane' }),
        svg('text', { x: 0, y: at * lane + lane / 2 + 4 }, name.slice(0, 14)), ...marks);
    });
    this.lanes.setAttribute('viewBox', `0 0 ${width} ${Math.max(1, names.length + first) * lane}`);
    this.lanes.toggleAttribute('hidden', names.length === 0);
    refill(this.lanes, ...(first === 0 ? [] : [alertLane(alerts, placeOf, width)]), ...rows);
    refill(this.alerts, ...(alerts.length === 0 ? [h('li', {}, 'None.')] : alerts.slice(-12).reverse().map((one) =>
      h('li', {}, h('time', {}, clock(one.time)), h('span', { class: one.isMended ? 'good' : 'bad' }, one.isMended ? ' ✓ no more: ' : ' ✕ '), one.text))));
    const latest = shown.slice(-12).reverse();
    refill(this.list, ...(latest.length === 0 ? [h('li', {}, 'Nothing has changed.')] : latest.map((one) =>
      h('li', { class: one.event }, h('time', {}, clock(one.time)), ` ${sentence(one)}`))));
  }

  private set(seconds: number): void {
    this.slider.value = String(seconds);
    const time = seconds === 0 ? undefined : this.end + seconds * 1000;
    this.words.textContent = time === undefined ? this.endWord : clock(time);
    this.back.hidden = time === undefined;
    this.look(time);
  }
}

function alertLane(alerts: Alert[], placeOf: (time: number) => number, width: number): SVGElement {
  return svg('g', { class: 'alerts' }, svg('line', { x1: left, x2: width - 10, y1: lane / 2, y2: lane / 2, class: 'lane' }),
    svg('text', { x: 0, y: lane / 2 + 4 }, 'alerts'), ...alerts.map((one) =>
      svg('path', { d: `M${placeOf(one.time).toFixed(1)} ${lane / 2 + (one.isMended ? 7 : -7)} l5 ${one.isMended ? -12 : 12} h-10 z`, class: one.isMended ? 'mark-add' : 'mark-del' },
        svg('title', {}, `${clock(one.time)} ${one.isMended ? 'no more: ' : ''}${one.text}`))));
}

const nameOf = (one: Happening): string =>
  one.kind === 'participants' ? (one.record as Participant).name : (one.record as Service | Request).participant_name;

function sentence(one: Happening): string {
  const word = { add: 'came', modify: 'changed', del: one.reason === '' || one.reason === 'gone' ? 'went' : `went (${one.reason})` }[one.event];
  if (one.kind === 'participants') return `${nameOf(one)} ${word}`;
  const entry = one.record as Service | Request;
  const what = entry.concept ?? entry.text ?? String(entry.id ?? '');
  return `${nameOf(one)} ${entry.name}: the ${one.kind === 'services' ? 'service' : 'request'} ${what} ${word}`;
}
