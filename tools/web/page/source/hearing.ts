// Which hosts this one hears, how well, and whether they hear it.
import type { Participant } from './answers.js';
import { h, refill, shortened } from './dom.js';

export function drawHearing(parent: HTMLElement, participants: Participant[], choose: (id: string) => void): void {
  const others = participants.filter((one) => !one.self).sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
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
