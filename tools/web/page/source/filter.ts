// The filter of the picture: a robot, a module, a concept or an expression, and a mode.
import { ask, identityText, type Match, type Request, type Service } from './answers.js';
import { completionOf } from './completion.js';
import { h } from './dom.js';
import type { Link } from './matches.js';

/** The pause after the last letter before the daemon is asked, in milliseconds. */
const typing = 400;
/** Signs of a concept or an expression, which the daemon understands. */
const expression = /[:<(]| and | or | some | not /;

export class Filter {
  private readonly input = h('input', { id: 'filter', type: 'search', autocomplete: 'off', spellcheck: false, placeholder: 'robot, module, concept or expression', input: () => this.soon() });
  private readonly mode = h('select', { id: 'mode', change: () => this.then() },
    ...['any mode', 'oto', 'otm/stream', 'otm/pubsub'].map((word, at) => h('option', { value: at === 0 ? '' : word }, word)));
  /** The services that match what is typed, where it is a concept or an expression. */
  private matching: Set<string> | undefined;
  private timer: number | undefined;

  /** `then` is called when something else is to be shown. */
  constructor(
    parent: Element,
    private readonly then: () => void,
  ) {
    parent.append(h('label', { for: 'filter' }, 'Show'), this.input, completionOf(this.input), h('label', { for: 'mode', class: 'hidden' }, 'Mode'), this.mode);
  }

  isEmpty(): boolean {
    return this.input.value.trim() === '';
  }

  admits(link: Link): boolean {
    if (this.mode.value !== '' && link.request.mode !== this.mode.value) return false;
    return this.matching !== undefined ? this.matching.has(link.service.service) : this.hasWord(link.request) || this.hasWord(link.service);
  }

  private hasWord(entry: Request | Service): boolean {
    const word = this.input.value.trim().toLowerCase();
    return word === '' || `${entry.participant_name} ${entry.name} ${identityText(entry)}`.toLowerCase().includes(word);
  }

  private soon(): void {
    this.matching = undefined;
    this.then();
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.askMatching(this.input.value.trim()), typing);
  }

  private async askMatching(word: string): Promise<void> {
    if (!expression.test(word)) return;
    // Text that is no concept, or none yet, is looked for by its letters.
    const matches = await ask<Match[]>('match', { concept: word }).catch(() => undefined);
    if (word !== this.input.value.trim()) return;
    this.matching = matches && new Set(matches.map((one) => one.service));
    this.then();
  }
}
