// Names of classes that complete what is being typed: the last name of a concept or of an expression.
import { ask } from './answers.js';
import { h, refill } from './dom.js';

/** The pause after the last letter before names are asked for, in milliseconds, and how many are offered. */
const typing = 250;
const offered = 20;
/** Words of an expression that are no beginning of a name. */
const operators = new Set(['and', 'or', 'not', 'some', 'only', 'value', 'min', 'max', 'exactly', 'that', 'inverse']);

/** The names that an input offers, an element to stand beside it. */
export function completionOf(input: HTMLInputElement): HTMLDataListElement {
  const list = h('datalist', { id: `${input.id}-names` });
  input.setAttribute('list', list.id);
  let timer: number | undefined;
  const offer = async (): Promise<void> => {
    const typed = input.value;
    const name = /[^\s(){},]*$/.exec(typed)?.[0] ?? '';
    if (name === '' || operators.has(name)) return refill(list);
    const found = await ask<{ concept: string }[]>('concepts', { begin: name, limit: String(offered) }).catch(() => []);
    if (typed !== input.value) return;
    const before = typed.slice(0, typed.length - name.length);
    refill(list, ...found.map((one) => h('option', { value: before + one.concept })));
  };
  input.addEventListener('input', () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void offer(), typing);
  });
  return list;
}
