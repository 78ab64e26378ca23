// The list of what is wrong, each of which leads to its place and its reason.
import type { Participant } from './answers.js';
import { bodyOf, byId, h, refill } from './dom.js';
import type { Finding } from './wrong.js';

export class WrongList {
  private told = '';
  private first: string | undefined;

  constructor(private readonly open: (finding: Finding) => void) {}

  /** `participants` gives robots their names. */
  draw(findings: Finding[], participants: Map<string, Participant>): void {
    const told = JSON.stringify([findings, participants.size === 0]);
    if (told === this.told) return;
    this.told = told;
    // A new fault that stands first is seen, unless somebody goes through the list.
    const first = findings[0]?.key;
    if (first !== this.first && !byId('wrong').contains(document.activeElement)) byId('wrong').scrollTop = 0;
    this.first = first;
    byId('wrong-title').textContent = findings.length === 0 ? 'Nothing is wrong' : `What is wrong (${findings.length})`;
    byId('wrong').classList.toggle('fine', findings.length === 0);
    const nothing = participants.size === 0 ? 'Nobody is known yet.' : 'Every request that is known is served, and every host is heard.';
    refill(bodyOf('wrong'), findings.length === 0 ? h('p', {}, nothing)
      : h('ul', { class: 'findings' }, ...findings.map((one) => h('li', { class: one.level },
        h('button', { type: 'button', 'data-key': one.key, click: () => this.open(one) },
          h('b', {}, h('span', { class: 'level' }, one.level === 'error' ? '✕ ' : '! '), one.title),
          ...(one.request === undefined ? [] : [h('span', { class: 'places' }, `${one.request.name} on ${namesOf(one.places, participants)}`)]),
          h('span', { class: 'text' }, one.text))))));
  }
}

const namesOf = (places: string[], participants: Map<string, Participant>): string =>
  places.flatMap((id) => participants.get(id)?.name ?? []).sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).join(', ');
