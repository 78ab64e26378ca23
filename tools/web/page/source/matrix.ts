// The matrix of who hears whom, by what each robot says of it: a row for each that hears, a column for each that is heard. It is drawn on a canvas as
// large as what is seen of it, so that ten thousand cells cost no more than a screen; the keys of arrows go from cell to cell, which is told in words.
import type { Hearer, Participant } from './answers.js';
import { h, shortened } from './dom.js';
import { isLate, isLossy } from './wrong.js';

type Kind = 'well' | 'fair' | 'missed' | 'none';

interface Cell {
  words: string;
  kind: Kind;
}

interface Place {
  row: number;
  column: number;
}

/** Pixels of a cell, of the names before the rows and above the columns, and of the most that is seen at once. */
const size = 22;
const left = 112;
const top = 84;
const mostHeight = 560;

const unknown: Cell = { words: 'not known', kind: 'none' };
const itself: Cell = { words: 'itself', kind: 'none' };
const byName = (a: Participant, b: Participant): number => a.name.localeCompare(b.name, 'en', { numeric: true });

function ownRow(participants: Participant[]): Map<string, Cell> {
  return new Map(participants.map((one) => {
    const loss = one.loss ?? 0;
    const kind: Kind = isLate(one) || isLossy(one) ? 'missed' : one.heard > one.interval ? 'fair' : 'well';
    return [one.id, { words: `${Math.round(loss * 100)} % lost, heard ${one.heard.toFixed(0)} s ago`, kind }];
  }));
}

/** Since when a host says again and again that it has not heard another one within the interval, in ms, by both. */
type Silences = Map<string, number>;

/** The intervals after which that is no chance: at 30 % loss one pair in fifteen thousand is silent for so long. */
const silentIntervals = 8;

/** Cells by hearer and heard. */
function cellsOf(participants: Participant[], hearers: Hearer[], silences: Silences, now: number): Map<string, Map<string, Cell>> {
  const cells = new Map<string, Map<string, Cell>>();
  const intervals = new Map(participants.map((one) => [one.id, one.interval]));
  const silent = new Set<string>();
  for (const one of hearers) {
    const row = new Map<string, Cell>();
    for (const id of one.quarter ?? []) row.set(id, { words: 'within a quarter of its interval', kind: 'well' });
    for (const id of one.half ?? []) row.set(id, { words: 'within half its interval', kind: 'well' });
    for (const id of one.whole ?? []) row.set(id, { words: 'within its interval', kind: 'fair' });
    for (const id of one.longer ?? []) {
      const pair = `${one.witness} ${id}`;
      silent.add(pair);
      const since = silences.get(pair) ?? now;
      silences.set(pair, since);
      const isMissed = now - since >= silentIntervals * 1000 * (intervals.get(id) ?? 2);
      row.set(id, isMissed ? { words: 'not for eight of its intervals', kind: 'missed' } : { words: 'longer ago than its interval', kind: 'fair' });
    }
    cells.set(one.witness, row);
  }
  for (const pair of silences.keys()) {
    if (!silent.has(pair)) silences.delete(pair);
  }
  const self = participants.find((one) => one.self);
  if (self !== undefined) cells.set(self.id, ownRow(participants));
  return cells;
}

export class Matrix {
  private readonly about = h('p', {});
  private readonly canvas = h('canvas', {});
  private readonly room = h('div', { class: 'room' }, this.canvas);
  private readonly words = h('output', { class: 'cell' });
  private readonly scroll = h('div', { class: 'matrix', tabindex: 0, role: 'application', 'aria-label': 'Who hears whom, go by the arrow keys' }, this.room);
  private readonly section = h('div', { hidden: true }, h('h3', {}, 'Who hears whom'), this.about, this.words, this.scroll);
  private order: Participant[] = [];
  private troubled = new Set<string>();
  private cells = new Map<string, Map<string, Cell>>();
  private readonly silences: Silences = new Map();
  /** The robots of the cell that is told in words: who hears, and who is heard. */
  private aimed: [string, string] | undefined;
  private frame: number | undefined;

  /** `choose` is told the robot of a row that is clicked on. */
  constructor(
    parent: Element,
    private readonly choose: (id: string) => void,
  ) {
    parent.append(this.section);
    this.scroll.addEventListener('scroll', () => this.paintSoon());
    this.scroll.addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('pointermove', (event) => this.go(this.placeOf(event)));
    this.canvas.addEventListener('click', (event) => {
      const place = this.placeOf(event);
      this.go(place);
      const chosen = place === undefined ? undefined : this.order[place.row];
      if (chosen !== undefined && event.offsetX < left) this.choose(chosen.id);
    });
    new ResizeObserver(() => this.paintSoon()).observe(this.scroll);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.paintSoon());
  }

  draw(participants: Participant[], hearers: Hearer[]): void {
    this.section.hidden = participants.length < 2 || hearers.length === 0;
    if (this.section.hidden) return;
    this.cells = cellsOf(participants, hearers, this.silences, Date.now());
    this.troubled = new Set();
    for (const [hearer, row] of this.cells) for (const [heard, cell] of row) if (cell.kind === 'missed' && hearer !== heard) this.troubled.add(hearer).add(heard);
    const rank = (one: Participant): number => (one.self ? 0 : this.troubled.has(one.id) ? 1 : 2);
    this.order = [...participants].sort((a, b) => rank(a) - rank(b) || byName(a, b));
    const missed = this.order.filter((one) => this.troubled.has(one.id));
    const about = 'Each row says whom it hears: ● lately, ◐ longer ago, ✕ not for eight intervals, · not known. ' +
      (missed.length === 0 ? 'Nobody is missed.' : `These ${missed.length} are missed or miss others, and stand first: ${shortened(missed.map((one) => one.name).join(', '), 200)}.`);
    if (this.about.textContent !== about) this.about.textContent = about;
    this.room.style.width = `${left + this.order.length * size}px`;
    this.room.style.height = `${top + this.order.length * size}px`;
    this.scroll.style.maxHeight = `${mostHeight}px`;
    this.say();
    this.paintSoon();
  }

  /** The place of the cell that is told in words. */
  private at(): Place | undefined {
    const [row, column] = (this.aimed ?? []).map((id) => this.order.findIndex((one) => one.id === id));
    return row === undefined || column === undefined || row < 0 || column < 0 ? undefined : { row, column };
  }

  private cellAt(row: number, column: number): Cell {
    const [hearer, heard] = [this.order[row], this.order[column]];
    if (hearer === undefined || heard === undefined) return unknown;
    return hearer.id === heard.id ? itself : (this.cells.get(hearer.id)?.get(heard.id) ?? unknown);
  }

  /** The cell at a pointer; of the names the first of their row or column. */
  private placeOf(event: MouseEvent): Place | undefined {
    const row = Math.floor((event.offsetY - top + this.scroll.scrollTop) / size);
    const column = Math.floor((event.offsetX - left + this.scroll.scrollLeft) / size);
    const place = { row: event.offsetY < top ? 0 : row, column: event.offsetX < left ? 0 : column };
    return place.row < this.order.length && place.column < this.order.length ? place : undefined;
  }

  private key(event: KeyboardEvent): void {
    const step = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const last = this.order.length - 1;
    const within = (at: number): number => Math.max(0, Math.min(last, at));
    const at = this.at();
    const next = at === undefined ? { row: 0, column: Math.min(1, last) } : { row: within(at.row + (step[0] ?? 0)), column: within(at.column + (step[1] ?? 0)) };
    const seen = (scrolled: number, room: number, head: number, at: number): number => Math.min(at * size, Math.max(scrolled, (at + 1) * size - (room - head)));
    this.scroll.scrollTop = seen(this.scroll.scrollTop, this.scroll.clientHeight, top, next.row);
    this.scroll.scrollLeft = seen(this.scroll.scrollLeft, this.scroll.clientWidth, left, next.column);
    this.go(next);
  }

  private go(place: Place | undefined): void {
    const [hearer, heard] = place === undefined ? [] : [this.order[place.row], this.order[place.column]];
    this.aimed = hearer === undefined || heard === undefined ? undefined : [hearer.id, heard.id];
    this.say();
    this.paintSoon();
  }

  private say(): void {
    const at = this.at();
    const [hearer, heard] = at === undefined ? [] : [this.order[at.row], this.order[at.column]];
    const words = at === undefined || hearer === undefined || heard === undefined ? 'Point at a cell, or go there by the arrow keys.'
      : hearer === heard ? hearer.name : `${hearer.name} hears ${heard.name}: ${this.cellAt(at.row, at.column).words}`;
    if (this.words.textContent !== words) this.words.textContent = words;
  }

  private paintSoon(): void {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      this.paint();
    });
  }

  private paint(): void {
    const [width, height] = [this.scroll.clientWidth, this.scroll.clientHeight];
    const context = this.canvas.getContext('2d');
    if (context === null || width === 0) return;
    const ratio = devicePixelRatio;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
      this.canvas.style.width = `${width}px`;
      this.canvas.style.height = `${height}px`;
    }
    const style = getComputedStyle(this.scroll);
    const colours = new Map(['--line', '--ground', '--bad-ground', '--exact', '--doubt', '--bad', '--quiet', '--ink', '--focus'].map((name) => [name, style.getPropertyValue(name)]));
    const colour = (name: string): string => colours.get(name) ?? '';
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.textBaseline = 'middle';
    context.font = `12px ${style.fontFamily}`;
    const [x, y] = [left - this.scroll.scrollLeft, top - this.scroll.scrollTop];
    const aimed = this.at();
    const first = { row: Math.floor((top - y) / size), column: Math.floor((left - x) / size) };
    const last = { row: Math.min(this.order.length, Math.ceil((height - y) / size)), column: Math.min(this.order.length, Math.ceil((width - x) / size)) };
    context.save();
    context.beginPath();
    context.rect(left, top, width - left, height - top);
    context.clip();
    for (let row = first.row; row < last.row; ++row) {
      for (let column = first.column; column < last.column; ++column) this.paintCell(context, colour, row, column, x + column * size, y + row * size);
    }
    if (aimed !== undefined) {
      context.strokeStyle = colour('--focus');
      context.lineWidth = 2;
      context.strokeRect(x + aimed.column * size + 1.5, y + aimed.row * size + 1.5, size - 2, size - 2);
    }
    context.restore();
    const nameAt = (at: number): string => this.order[at]?.name ?? '';
    const ink = (at: number, isAimed: boolean): string => colour(isAimed || this.troubled.has(this.order[at]?.id ?? '') ? '--ink' : '--quiet');
    const names = (from: number, to: number, marked: number | undefined, clip: [number, number, number, number], place: (at: number) => void, length: number): void => {
      context.save();
      context.beginPath();
      context.rect(...clip);
      context.clip();
      for (let at = from; at < to; ++at) {
        context.save();
        context.fillStyle = ink(at, at === marked);
        place(at);
        context.fillText(shortened(nameAt(at), length), 0, 0);
        context.restore();
      }
      context.restore();
    };
    names(first.row, last.row, aimed?.row, [0, top, left, height - top], (at) => context.translate(2, y + (at + 0.5) * size), 16);
    names(first.column, last.column, aimed?.column, [left, 0, width - left, top], (at) => {
      context.translate(x + (at + 0.5) * size, top - 5);
      context.rotate(-Math.PI / 2.6);
    }, 12);
  }

  private paintCell(context: CanvasRenderingContext2D, colour: (name: string) => string, row: number, column: number, x: number, y: number): void {
    const { kind } = this.cellAt(row, column);
    const isSelf = row === column;
    context.strokeStyle = colour('--line');
    context.lineWidth = 1;
    if (kind === 'missed' || isSelf) {
      context.fillStyle = colour(isSelf ? '--ground' : '--bad-ground');
      context.fillRect(x, y, size, size);
    }
    context.strokeRect(x + 0.5, y + 0.5, size, size);
    const [cx, cy, r] = [x + size / 2 + 0.5, y + size / 2 + 0.5, 5];
    context.fillStyle = context.strokeStyle = colour({ well: '--exact', fair: '--doubt', missed: '--bad', none: '--quiet' }[kind]);
    context.beginPath();
    if (kind === 'missed') {
      context.lineWidth = 2.2;
      context.moveTo(cx - r, cy - r);
      context.lineTo(cx + r, cy + r);
      context.moveTo(cx + r, cy - r);
      context.lineTo(cx - r, cy + r);
      context.stroke();
    } else if (kind === 'fair') {
      context.lineWidth = 1.5;
      context.arc(cx, cy, r, 0, 2 * Math.PI);
      context.stroke();
      context.beginPath();
      context.arc(cx, cy, r, Math.PI / 2, 1.5 * Math.PI);
      context.fill();
    } else if (!isSelf) {
      context.arc(cx, cy, kind === 'well' ? r : 1.3, 0, 2 * Math.PI);
      context.fill();
    }
  }
}
