// Which hosts this one hears, how well, and whether they hear it; and who hears whom, by what the others say of it.
import { isDeaf, wayOf, type Hearer, type Participant } from './answers.js';
import { h, refill, shortened } from './dom.js';
import { Matrix } from './matrix.js';
import { isLate, isLossy, tooMuchLoss } from './wrong.js';

const isTroubled = (one: Participant): boolean => isDeaf(one) || isLate(one) || isLossy(one);
/** Those of whom something is amiss first, then by name. */
const inOrder = (a: Participant, b: Participant): number => Number(isTroubled(b)) - Number(isTroubled(a)) || a.name.localeCompare(b.name, 'en', { numeric: true });

function drawOwn(parent: HTMLElement, others: Participant[], choose: (id: string) => void): void {
  const rows = others.map((one) => {
    const loss = Math.round((one.loss ?? 0) * 100);
    return h('tr', {},
      h('th', { scope: 'row' }, h('button', { type: 'button', class: 'plain', 'data-key': `hears ${one.id}`, click: () => choose(one.id) }, shortened(one.name, 24))),
      h('td', { class: isLate(one) ? 'bad' : '' }, `${one.heard.toFixed(1)} s ago${wayOf(one) === '' ? '' : ', relayed'}`),
      h('td', { class: isLossy(one) ? 'bad' : '' }, `${loss} % lost `, h('meter', { min: 0, max: 100, value: loss, high: tooMuchLoss * 100, 'aria-label': `loss of ${one.name}` })),
      h('td', { class: isDeaf(one) ? 'bad' : '' }, isDeaf(one) ? '✕ does not hear us' : '✓ no complaint'));
  });
  refill(parent, others.length === 0 ? h('p', {}, 'No other host is heard.') : h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Hosts that are heard' },
    h('table', {}, h('thead', {}, h('tr', {}, ...['host', 'heard', 'our loss', 'the other way'].map((word) => h('th', { scope: 'col' }, word)))), h('tbody', {}, ...rows))));
}

export class Hearing {
  private readonly own = h('div', {});
  private readonly matrix: Matrix;

  constructor(
    parent: HTMLElement,
    private readonly choose: (id: string) => void,
  ) {
    const place = h('div', {});
    parent.append(this.own, place);
    this.matrix = new Matrix(place, choose);
  }

  draw(participants: Participant[], hearers: Hearer[]): void {
    drawOwn(this.own, participants.filter((one) => !one.self).sort(inOrder), this.choose);
    this.matrix.draw(participants, hearers);
  }
}
