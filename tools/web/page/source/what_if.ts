// The question who would serve what nobody has stated, degree by degree.
import { ask, identityText, type Match } from './answers.js';
import { completionOf } from './completion.js';
import { limited } from './detail.js';
import { counted, h, refill } from './dom.js';

/** A form that asks who would serve what nobody has stated. `found` marks the providers in the picture. */
export function whatIf(found: (matches: Match[]) => void): HTMLElement {
  const concept = h('input', { id: 'if-concept', type: 'text', autocomplete: 'off', spellcheck: false, placeholder: 'soccer:BallInfo or soccer:GoalInfo' });
  const where = h('input', { id: 'if-where', type: 'text', autocomplete: 'off', spellcheck: false, placeholder: 'range >= 3 m' });
  const select = (id: string, words: string[], labels: string[]) =>
    h('select', { id }, ...words.map((word, at) => h('option', { value: word }, labels[at] ?? word)));
  const degree = select('if-degree', ['narrower', 'exact', 'equivalent', 'broader', 'overlapping'], []);
  const mode = select('if-mode', ['', 'oto', 'otm/stream', 'otm/pubsub'], ['any mode']);
  const answer = h('div', { 'aria-live': 'polite' });
  const submit = async (event: Event): Promise<void> => {
    event.preventDefault();
    const parameters: Record<string, string> = { degree: degree.value };
    for (const [key, input] of [['concept', concept], ['where', where], ['mode', mode]] as const) {
      if (input.value.trim() !== '') parameters[key] = input.value.trim();
    }
    try {
      const matches = await ask<Match[]>('match', parameters);
      found(matches);
      refill(answer, h('p', {}, matches.length === 0 ? 'Nobody would serve it.' : `${counted(matches.length, 'service')} would serve it, best first:`),
        h('ol', { class: 'links' }, ...limited(matches.map((match) =>
          h('li', {}, h('span', { class: `degree ${match.degree === 'exact' ? 'exact' : 'narrower'}` }, match.degree),
            h('div', {}, h('b', {}, `${match.participant_name} ${match.name}`), ` offers ${identityText(match)}, ${match.mode}`))))));
    } catch (error) {
      found([]);
      refill(answer, h('p', { class: 'error' }, error instanceof Error ? error.message : String(error)));
    }
  };
  return h('div', {},
    h('p', {}, 'See who would serve a request before a program states it. Type a concept or a class expression.'),
    h('form', { submit: (event) => void submit(event) },
      h('label', { for: 'if-concept' }, 'Concept'), concept, completionOf(concept),
      h('label', { for: 'if-where' }, 'Condition'), where,
      h('label', { for: 'if-degree' }, 'Weakest degree'), degree,
      h('label', { for: 'if-mode' }, 'Mode'), mode,
      h('button', { type: 'submit' }, 'Who would serve it?')),
    answer);
}
