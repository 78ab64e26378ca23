// Which hosts this one hears, how well, and whether they hear it; and who hears whom, by what the others say of it.
import type { Hearer, Participant } from './answers.js';
import { h, refill, shortened } from './dom.js';

/** The matrix has so many robots at most, those first of which most is missed. */
const maxRobots = 24;

const inOrder = (a: Participant, b: Participant): number => a.name.localeCompare(b.name, 'en', { numeric: true });

function drawOwn(parent: HTMLElement, others: Participant[], choose: (id: string) => void): void {
  const rows = others.map((one) => {
    const loss = Math.round((one.loss ?? 0) * 100);
    const isDeaf = one.hears_us === false || one.hears_us === 0;
    const isLate = one.heard > 2.5 * one.interval;
    return h('tr', {},
      h('th', { scope: 'row' }, h('button', { type: 'button', class: 'plain', 'data-key': `hears ${one.id}`, click: () => choose(one.id) }, shortened(one.name, 24))),
      h('td', { class: isLate ? 'bad' : '' }, `${one.heard.toFixed(1)} s ago`),
      h('td', { class: loss > 40 ? 'bad' : '' }, `${loss} % lost `, h('meter', { min: 0, max: 100, value: loss, high: 40, 'aria-label': `loss of ${one.name}` })),
      h('td', { class: isDeaf ? 'bad' : '' }, isDeaf ? '✕ does not hear us' : '✓ no complaint'));
  });
  refill(parent, others.length === 0 ? h('p', {}, 'No other host is heard.') : h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Hosts that are heard' },
    h('table', {}, h('thead', {}, h('tr', {}, ...['host', 'heard', 'our loss', 'the other way'].map((word) => h('th', { scope: 'col' }, word)))), h('tbody', {}, ...rows))));
}

interface Cell {
  sign: string;
  words: string;
  kind: 'well' | 'fair' | 'missed' | 'none';
}

const unknown: Cell = { sign: '·', words: 'not known', kind: 'none' };
const itself: Cell = { sign: '', words: 'itself', kind: 'none' };

/** Cells by hearer and heard. Our own row has the loss. */
function cellsOf(participants: Participant[], hearers: Hearer[]): Map<string, Map<string, Cell>> {
  const cells = new Map<string, Map<string, Cell>>();
  for (const one of hearers) {
    const row = new Map<string, Cell>();
    for (const id of one.quarter ?? []) row.set(id, { sign: '●', words: 'within a quarter of its interval', kind: 'well' });
    for (const id of one.half ?? []) row.set(id, { sign: '●', words: 'within half its interval', kind: 'well' });
    for (const id of one.whole ?? []) row.set(id, { sign: '◐', words: 'within its interval', kind: 'fair' });
    for (const id of one.longer ?? []) row.set(id, { sign: '✕', words: 'longer ago than its interval', kind: 'missed' });
    cells.set(one.witness, row);
  }
  const self = participants.find((one) => one.self);
  if (self === undefined) return cells;
  const own = new Map<string, Cell>();
  for (const one of participants) {
    const loss = Math.round((one.loss ?? 0) * 100);
    const kind = one.heard > one.interval ? (one.heard > 2.5 * one.interval ? 'missed' : 'fair') : loss > 40 ? 'missed' : 'well';
    own.set(one.id, { sign: `${loss} %`, words: `${loss} % lost, heard ${one.heard.toFixed(1)} s ago`, kind });
  }
  cells.set(self.id, own);
  return cells;
}

function drawMatrix(parent: HTMLElement, participants: Participant[], hearers: Hearer[]): void {
  const cells = cellsOf(participants, hearers);
  const missed = new Map<string, number>();
  for (const [hearer, row] of cells) {
    for (const [heard, cell] of row) {
      if (cell.kind !== 'missed' || hearer === heard) continue;
      for (const id of [hearer, heard]) missed.set(id, (missed.get(id) ?? 0) + 1);
    }
  }
  const worst = [...participants].sort((a, b) => (missed.get(b.id) ?? 0) - (missed.get(a.id) ?? 0) || Number(b.self) - Number(a.self) || inOrder(a, b)).slice(0, maxRobots);
  const shown = worst.sort((a, b) => Number(b.self) - Number(a.self) || inOrder(a, b));
  const cellOf = (hearer: Participant, heard: Participant): Cell => (hearer.id === heard.id ? itself : (cells.get(hearer.id)?.get(heard.id) ?? unknown));
  const of = JSON.stringify([hearers.length === 0, shown.map((one) => [one.name, ...shown.map((other) => cellOf(one, other).words)])]);
  if (parent.dataset['of'] === of) return;
  parent.dataset['of'] = of;
  if (shown.length < 2 || hearers.length === 0) {
    refill(parent);
    return;
  }
  refill(parent, h('h3', {}, 'Who hears whom'),
    h('p', {}, h('small', {}, 'Of each row whom it hears: ● lately, ◐ within the interval, ✕ not, · not known. Our own row has the loss.',
      participants.length > shown.length ? ` Of ${participants.length} robots those ${shown.length} of which most is missed.` : '')),
    h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Who hears whom' }, h('table', { class: 'matrix' },
      h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'hears'), ...shown.map((one) => h('th', { scope: 'col' }, shortened(one.name, 9))))),
      h('tbody', {}, ...shown.map((one) => h('tr', {}, h('th', { scope: 'row' }, shortened(one.name, 16)), ...shown.map((other) => {
        const cell = cellOf(one, other);
        return h('td', { class: cell.kind, title: `${one.name} hears ${other.name}: ${cell.words}` }, h('span', { 'aria-hidden': 'true' }, cell.sign), h('span', { class: 'hidden' }, cell.words));
      })))))));
}

export class Hearing {
  private readonly own = h('div', {});
  private readonly matrix = h('div', {});

  constructor(
    parent: HTMLElement,
    private readonly choose: (id: string) => void,
  ) {
    parent.append(this.own, this.matrix);
  }

  draw(participants: Participant[], hearers: Hearer[]): void {
    drawOwn(this.own, participants.filter((one) => !one.self).sort(inOrder), this.choose);
    drawMatrix(this.matrix, participants, hearers);
  }
}
