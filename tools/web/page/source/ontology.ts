// The ontology as a tree that opens node by node, with what is offered and asked below each class, and what is amiss with it.
import { ask, participantOf, type ClassNode, type Explanation, type Ontology, type Taxonomy } from './answers.js';
import { bodyOf, h, refill } from './dom.js';
import type { Moment } from './team.js';

const atOnce = 200;
const maxRefreshed = 20;
const maxNames = 200;
const nothing = '<http://www.w3.org/2002/07/owl#Nothing>';
/** The pause after the last letter before the names are looked through, in milliseconds. */
const typing = 300;

const errorOf = (error: unknown): HTMLElement => h('p', { class: 'error' }, error instanceof Error ? error.message : String(error));

const countsOf = (node: ClassNode): string =>
  [node.offers > 0 ? `${node.offers} offered` : '', node.requests > 0 ? `${node.requests} asked for` : ''].filter((word) => word !== '').join(', ');

/** A button that shows the axioms by which a class is below another. */
function whyButton(sub: string, sup: string, label: string): HTMLElement {
  const answer = h('div', { class: 'answer', hidden: true });
  const button = h('button', { type: 'button', class: 'small', 'aria-expanded': 'false' }, label);
  button.addEventListener('click', () => {
    answer.hidden = !answer.hidden;
    button.setAttribute('aria-expanded', String(!answer.hidden));
    if (answer.hidden) return;
    refill(answer, h('p', {}, 'Asking …'));
    ask<Explanation>('explain', { sub, super: sup }).then(
      ({ subsumed, axioms, text }) => refill(answer, h('p', {}, subsumed ? `${sub} is below ${sup}, since` : `${sub} is not below ${sup}. ${text ?? ''}`),
        h('ul', { class: 'proof' }, ...axioms.map((one) => h('li', {}, h('code', {}, one.axiom), ' ',
          h('small', {}, one.file === undefined ? '' : `${one.file}${one.line === undefined ? '' : `:${one.line}`}`))))),
      (error: unknown) => refill(answer, errorOf(error)),
    );
  });
  return h('span', { class: 'asking' }, button, answer);
}

export class OntologyView {
  private readonly tree = h('div', { class: 'tree' });
  private readonly about = h('div', {});
  private readonly search = h('input', { id: 'class-search', type: 'search', autocomplete: 'off', spellcheck: false, placeholder: 'a part of a name', input: () => this.soon() });
  private digest: string | undefined;
  private timer: number | undefined;
  private told = '';
  /** The counts that are shown of each class, by the class that was opened for them. */
  private counts = new Map<string, Map<string, HTMLElement>>();

  constructor(private readonly moment: () => Moment) {
    bodyOf('ontology').append(h('div', { class: 'filters' }, h('label', { for: 'class-search' }, 'Find a class'), this.search),
      h('div', { class: 'columns' }, this.tree, this.about));
  }

  /** Takes what the daemon says of its ontology, from time to time. */
  show(ontology: Ontology | undefined): void {
    if (ontology === undefined) return;
    const told = JSON.stringify({ ...ontology });
    if (told !== this.told) {
      this.told = told;
      this.showAbout(ontology);
    }
    if (ontology.digest !== this.digest) {
      this.digest = ontology.digest;
      if (ontology.loaded) void this.find();
      else refill(this.tree, h('p', {}, 'No ontology is loaded: start gemingad with --ontology FILE-OR-FOLDER.'));
    } else if (ontology.loaded && !document.hidden) {
      void this.refresh();
    }
  }

  private soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.find(), typing);
  }

  /** Shows the classes that the text of the search occurs in, or the tree from its top. */
  private async find(): Promise<void> {
    const contains = this.search.value.trim();
    this.counts = new Map();
    try {
      const found = await ask<Taxonomy>('taxonomy', contains === '' ? { limit: String(atOnce) } : { contains, limit: String(atOnce) });
      if (contains !== this.search.value.trim()) return;
      if (found.total === 0) refill(this.tree, h('p', {}, `No class has ‘${contains}’ in its name.`));
      else refill(this.tree, this.listOf(found, contains === '' ? {} : { contains }, undefined));
    } catch (error) {
      refill(this.tree, errorOf(error));
    }
  }

  /** The nodes of an answer, and a button for the rest. */
  private listOf(found: Taxonomy, question: Record<string, string>, parent: string | undefined): HTMLElement {
    const list = h('ul', { class: 'classes' });
    const key = JSON.stringify(question);
    const counts = this.counts.get(key) ?? new Map<string, HTMLElement>();
    this.counts.set(key, counts);
    let shown = 0;
    const add = (classes: ClassNode[], total: number): void => {
      shown += classes.length;
      list.append(...classes.map((one) => this.nodeOf(one, counts, parent)));
      if (shown >= total || classes.length === 0) return;
      const more = h('li', {}, h('button', { type: 'button', class: 'small', click: () => {
        void ask<Taxonomy>('taxonomy', { ...question, skip: String(shown), limit: String(atOnce) }).then((rest) => {
          more.remove();
          add(rest.classes, rest.total);
        }, (error: unknown) => more.append(errorOf(error)));
      } }, `… and ${total - shown} more`));
      list.append(more);
    };
    add(found.classes, found.total);
    return list;
  }

  private nodeOf(node: ClassNode, counts: Map<string, HTMLElement>, parent: string | undefined): HTMLElement {
    const count = h('small', { class: 'counts' }, countsOf(node));
    counts.set(node.class, count);
    const equivalents = (node.equivalents ?? []).length === 0 ? [] : [h('small', {}, ` = ${(node.equivalents ?? []).join(' = ')}`)];
    const body = h('div', { class: 'below' });
    const details = h('details', {}, h('summary', {}, h('b', {}, node.class), ...equivalents, ' ', count,
      ...(node.unsatisfiable === true ? [h('span', { class: 'bad' }, ' can have no instance')] : [])), body);
    let isAsked = false;
    details.addEventListener('toggle', () => {
      if (!details.open || isAsked) return;
      isAsked = true;
      void this.open(node, body, parent);
    });
    return h('li', {}, details);
  }

  private async open(node: ClassNode, body: HTMLElement, parent: string | undefined): Promise<void> {
    if (node.unsatisfiable === true) {
      refill(body, whyButton(node.class, nothing, 'Why it can have no instance'));
      return;
    }
    try {
      const found = await ask<Taxonomy>('taxonomy', { class: node.class, limit: String(atOnce) });
      const parents = [...new Set([...(parent === undefined ? [] : [parent]), ...(found.parents ?? [])])];
      refill(body, ...(parents.length === 0 ? [] : [h('div', { class: 'parents' }, ...parents.map((one) => whyButton(node.class, one, `Why below ${one}`)))]),
        found.total === 0 ? h('p', {}, h('small', {}, 'Nothing is below it.')) : this.listOf(found, { class: node.class }, node.class));
    } catch (error) {
      refill(body, errorOf(error));
    }
  }

  /** Asks anew for the counts that are shown, of a few nodes. */
  private async refresh(): Promise<void> {
    for (const [key, counts] of [...this.counts].slice(0, maxRefreshed)) {
      if (![...counts.values()].some((one) => one.checkVisibility())) continue;
      try {
        const found = await ask<Taxonomy>('taxonomy', { ...(JSON.parse(key) as Record<string, string>), limit: String(atOnce) });
        for (const node of found.classes) {
          const element = counts.get(node.class);
          if (element !== undefined && element.textContent !== countsOf(node)) element.textContent = countsOf(node);
        }
      } catch {
        return; // the stream says that the daemon is away
      }
    }
  }

  private showAbout(ontology: Ontology): void {
    const parts: HTMLElement[] = [h('p', {}, ontology.loaded ? `${ontology.classes ?? 0} classes, digest ${ontology.digest ?? ''}` : 'None is loaded.',
      ontology.complete === true ? ' Everything that follows was found.' : '')];
    if (ontology.files.length > 0) parts.push(h('ul', {}, ...ontology.files.map((one) => h('li', {}, h('code', {}, one.file)))));
    const impossible = h('div', {});
    parts.push(impossible);
    if (ontology.loaded) void this.showImpossible(impossible);
    if (ontology.left_out.length > 0) {
      parts.push(h('h3', {}, 'Left out'), h('ul', {}, ...ontology.left_out.map((one) => h('li', {}, `${one.construct}: ${one.count}, first `, h('code', {}, one.first)))));
    }
    if (ontology.gaps.length > 0) parts.push(h('h3', {}, 'Not searched to the end'), h('ul', {}, ...ontology.gaps.map((gap) => h('li', {}, gap))));
    if (ontology.others.length > 0) {
      parts.push(h('h3', {}, 'Robots with another ontology'), h('ul', {}, ...ontology.others.map((one) => {
        const answer = h('div', { class: 'answer', hidden: true });
        return h('li', {}, h('b', {}, one.name), ' ', h('code', {}, one.ontology), ' ', h('button', { type: 'button', class: 'small', click: () => {
          answer.hidden = !answer.hidden;
          if (!answer.hidden) void this.differences(one.participant, answer);
        } }, 'What differs'), answer);
      })));
    }
    refill(this.about, ...parts);
  }

  private async showImpossible(place: HTMLElement): Promise<void> {
    try {
      const found = await ask<Taxonomy>('taxonomy', { class: nothing, limit: String(atOnce) });
      if (found.total > 0) refill(place, h('h3', { class: 'bad' }, `${found.total} classes can have no instance`), this.listOf(found, { class: nothing }, undefined));
    } catch {
      // An ontology that is being read has none to tell of yet.
    }
  }

  /** Shows what can be seen of another ontology from here: names that its robot uses and this host does not know. */
  private async differences(participant: string, answer: HTMLElement): Promise<void> {
    const moment = this.moment();
    const names = new Set<string>();
    for (const one of moment.services.values()) if (participantOf(one.provider) === participant) for (const name of [one.concept, one.representation]) if (name !== undefined) names.add(name);
    for (const one of moment.requests.values()) if (participantOf(one.consumer) === participant) for (const name of [one.concept, one.representation]) if (name !== undefined) names.add(name);
    const simple = [...names].filter((name) => !name.includes(' ')).sort().slice(0, maxNames);
    const unknown: string[] = [];
    for (const name of simple) await ask<Taxonomy>('taxonomy', { class: name, limit: '1' }).catch(() => unknown.push(name));
    refill(answer, h('p', {}, unknown.length > 0 ? `It uses ${unknown.length} of ${simple.length} names that are unknown here:`
      : simple.length > 0 ? `All ${simple.length} names that it uses are known here; what its axioms say of them is not announced.`
        : 'It offers nothing and asks for nothing by a concept, so that nothing is seen of its ontology but the digest.'),
      h('ul', {}, ...unknown.map((name) => h('li', {}, h('code', {}, name)))),
      h('p', {}, h('small', {}, 'geminga-ontology diff compares the files themselves.')));
  }
}
