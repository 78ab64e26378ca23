// Comings, goings and changes of the last hour in a lane for each robot, and a slider that goes back to any moment of it.
import type { Participant, Request, Service } from './answers.js';
import { clock, h, refill, svg } from './dom.js';
import { hour, type Happening } from './team.js';

const second = 1000;
const lane = 22;
const left = 100;
const width = 600;
/** Marks in one lane that lie nearer than this share of the width are one. */
const nearest = 0.008;

export class Timeline {
  private readonly slider: HTMLInputElement;
  private readonly words = h('output', { for: 'moment' }, 'now');
  private readonly back = h('button', { type: 'button', class: 'small', hidden: true, click: () => this.set(0) }, 'Back to now');
  private readonly lanes = svg('svg', { class: 'lanes', role: 'img', 'aria-label': 'Comings and goings by robot', preserveAspectRatio: 'none' });
  private readonly list = h('ol', { class: 'happenings' });
  private since = Date.now();
  private drawn = 0;

  /** `look` is told the instant to look at, or nothing for the present. */
  constructor(
    parent: HTMLElement,
    private readonly look: (time: number | undefined) => void,
  ) {
    this.slider = h('input', { id: 'moment', type: 'range', min: -1, max: 0, value: 0, step: 1, input: () => this.set(Number(this.slider.value)) });
    parent.append(h('div', { class: 'scrub' }, h('label', { for: 'moment' }, 'Look at'), this.slider, this.words, this.back),
      this.lanes, h('h3', {}, 'Latest'), this.list);
  }

  /** Draws anew once a second at most. */
  draw(happenings: Happening[], opened: number): void {
    const now = Date.now();
    if (now - this.drawn < second) return;
    this.drawn = now;
    this.since = Math.max(opened, now - hour);
    this.slider.min = String(-Math.max(1, Math.round((now - this.since) / 1000)));
    const shown = happenings.filter((one) => one.time >= this.since);
    const byName = new Map<string, Happening[]>();
    for (const one of shown) {
      const known = byName.get(nameOf(one));
      if (known === undefined) byName.set(nameOf(one), [one]);
      else known.push(one);
    }
    const names = [...byName.keys()].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).slice(0, 100);
    const span = Math.max(60_000, now - this.since);
    const rows = names.map((name, at) => {
      const marks: SVGElement[] = [];
      let last = -1;
      for (const one of byName.get(name) ?? []) {
        const share = 1 - (now - one.time) / span;
        if (one.kind !== 'participants' && share - last < nearest) continue;
        last = share;
        const size = one.kind === 'participants' ? 7 : 3.5;
        marks.push(svg('rect', { x: left + share * (width - left - 10) - size / 2, y: at * lane + lane / 2 - size, width: size, height: size * 2, class: `mark-${one.event}` },
          svg('title', {}, `${clock(one.time)} ${sentence(one)}`)));
      }
      return svg('g', {}, svg('line', { x1: left, x2: width - 10, y1: at * lane + lane / 2, y2: at * lane + lane / 2, class: 'lane' }),
        svg('text', { x: 0, y: at * lane + lane / 2 + 4 }, name.slice(0, 14)), ...marks);
    });
    this.lanes.setAttribute('viewBox', `0 0 ${width} ${Math.max(1, names.length) * lane}`);
    this.lanes.toggleAttribute('hidden', names.length === 0);
    refill(this.lanes, ...rows);
    const latest = shown.slice(-12).reverse();
    refill(this.list, ...(latest.length === 0 ? [h('li', {}, 'Nothing has changed since this page was opened.')] : latest.map((one) =>
      h('li', { class: one.event }, h('time', {}, clock(one.time)), ` ${sentence(one)}`))));
  }

  private set(seconds: number): void {
    this.slider.value = String(seconds);
    const time = seconds === 0 ? undefined : Date.now() + seconds * 1000;
    this.words.textContent = time === undefined ? 'now' : clock(time);
    this.back.hidden = time === undefined;
    this.look(time);
  }
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
