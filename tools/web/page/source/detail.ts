// The details of one robot, two robots or a request, and the answer to what would be if somebody asked.
import {
  ask, identityText, participantOf, wayOf,
  type Check, type PairAnswer, type Request, type RequestAnswer, type Service,
} from './answers.js';
import { bodyOf, byId, h, refill } from './dom.js';
import type { Link } from './matches.js';
import type { Choice } from './picture.js';
import type { Moment } from './team.js';
import type { Finding } from './wrong.js';

const maxRows = 60;

export interface Ground {
  moment: Moment;
  links: Link[];
  /** Whether the daemon can be asked about this moment. */
  isNow: boolean;
  choose(choice: Choice): void;
}

const mark = (ok: boolean): HTMLElement => h('span', { class: ok ? 'mark good' : 'mark bad' }, ok ? '✓ ' : '✕ ');

function checkItem(check: Check): HTMLElement {
  const item = h('li', {}, mark(check.ok), h('b', {}, check.check), ` ${check.text}`);
  if (check.code !== undefined && !check.ok) item.append(' ', h('code', {}, check.code));
  if (check.mend !== undefined && !check.ok) item.append(h('p', { class: 'mend' }, `→ ${check.mend}`));
  if (check.proof !== undefined && check.proof.length > 0) {
    item.append(h('ul', { class: 'proof' }, ...check.proof.map((axiom) => h('li', {}, h('code', {}, axiom)))));
  }
  return item;
}

/** A button that opens what the daemon answers below it. */
function asking(label: string, key: string, question: () => Promise<Node>): HTMLElement {
  const answer = h('div', { class: 'answer', hidden: true });
  const button = h('button', { type: 'button', class: 'small', 'aria-expanded': 'false', 'data-key': key }, label);
  button.addEventListener('click', () => {
    const isOpen = !answer.hidden;
    answer.hidden = isOpen;
    button.setAttribute('aria-expanded', String(!isOpen));
    if (isOpen) return;
    refill(answer, h('p', {}, 'Asking …'));
    question().then(
      (node) => refill(answer, node),
      (error: unknown) => refill(answer, h('p', { class: 'error' }, error instanceof Error ? error.message : String(error))),
    );
  });
  return h('div', { class: 'asking' }, button, answer);
}

async function pairAnswer(subscription: string, service: string): Promise<Node> {
  const answer = await ask<PairAnswer>('why', { subscription, service });
  const steps = answer.convert === undefined ? '' : `, converted ${answer.convert.split('>').join(' → ')}`;
  const degree = answer.degree === undefined ? '' : `: ${answer.degree}, distance ${answer.distance ?? 0}${steps}`;
  return h('div', {}, h('p', {}, mark(answer.matches), answer.matches ? `They meet${degree}` : `They do not meet: ${answer.code ?? ''}`),
    h('ul', { class: 'checks' }, ...answer.checks.map(checkItem)));
}

async function requestAnswer(request: Request): Promise<Node> {
  const answer = await ask<RequestAnswer>('why', { subscription: request.subscription });
  const list = h('ul', { class: 'checks' });
  for (const near of answer.services) {
    list.append(h('li', {}, mark(near.ok), h('b', {}, `${near.participant_name} ${near.name}`), ` offers ${near.offered}`,
      h('br'), near.text, ' ', ...(near.code === undefined ? [] : [h('code', {}, near.code)]),
      ...(near.mend === undefined ? [] : [h('p', { class: 'mend' }, `→ ${near.mend}`)]),
      asking('Why', `why ${request.subscription} ${near.service}`, () => pairAnswer(request.subscription, near.service))));
  }
  const about = h('div', {}, h('p', {}, answer.text ?? `${answer.matching} of ${answer.offers} services meet it.`));
  if (answer.mend !== undefined) about.append(h('p', { class: 'mend' }, `→ ${answer.mend}`));
  about.append(list);
  return about;
}

function linkItem(link: Link, isNow: boolean): HTMLElement {
  const { request, service } = link;
  const item = h('li', {}, h('span', { class: `degree ${link.degree}` }, link.degree === 'refused' ? `refused: ${link.word}` : link.degree),
    h('div', {}, h('b', {}, `${request.participant_name} ${request.name}`), ` asks for ${identityText(request)}`),
    h('div', {}, h('b', {}, `${service.participant_name} ${service.name}`), ` offers ${identityText(service)}`, ...placeOf(service).map((word) => h('small', {}, ` (${word})`))));
  if (link.steps !== undefined) item.append(h('div', { class: 'steps' }, 'converted: ', h('code', {}, link.steps)));
  if (isNow) {
    item.append(asking('Why', `link ${request.subscription} ${service.service}`, () => pairAnswer(request.subscription, service.service)));
  }
  return item;
}

/** Where an offered expression stands among the classes. */
function placeOf(service: Service): string[] {
  if (service.unplaced !== undefined) return [`has no place in the ontology: ${service.unplaced}`];
  return service.placed === undefined ? [] : [`below ${service.placed.split(',').join(' and ')}`];
}

function title(text: string): void {
  byId('detail-title').textContent = text;
}

export function limited(items: HTMLElement[]): HTMLElement[] {
  return items.length <= maxRows ? items : [...items.slice(0, maxRows), h('li', {}, `… and ${items.length - maxRows} more: use the filter`)];
}

const back = (ground: Ground): HTMLElement =>
  h('button', { type: 'button', class: 'small', 'data-key': 'back', click: () => ground.choose({}) }, '← Back to What if');

export function showPair(pair: [string, string], ground: Ground): void {
  const [a, b] = pair.map((id) => ground.moment.participants.get(id)?.name ?? 'a robot that is gone');
  title(`${a ?? ''} and ${b ?? ''}`);
  const links = ground.links.filter((link) => [participantOf(link.request.consumer), participantOf(link.service.provider)].sort().join() === pair.join());
  refill(bodyOf('detail'), back(ground), h('ul', { class: 'links' }, ...limited(links.map((link) => linkItem(link, ground.isNow)))));
}

export function showParticipant(id: string, ground: Ground): void {
  const one = ground.moment.participants.get(id);
  title(one?.name ?? 'Gone');
  if (one === undefined) {
    refill(bodyOf('detail'), back(ground), h('p', {}, 'This robot is not there.'));
    return;
  }
  const facts = h('dl', {}, ...[
    ['identifier', one.id], ['addresses', `${one.addresses.join(', ')}${one.reachable === false ? ', not reachable from this host' : ''}`], ['ontology', one.ontology],
    ...(one.observed === undefined ? [] : [['words come from', `${one.observed}, which it does not announce`]]),
    ['speaks each', `${one.interval} s`], ...(wayOf(one) === '' ? [] : [['heard through', wayOf(one)]]),
  ].flatMap(([word, text]) => [h('dt', {}, word ?? ''), h('dd', {}, text ?? '')]));
  const neighbours = new Map<string, number>();
  for (const link of ground.links) {
    const ends = [participantOf(link.request.consumer), participantOf(link.service.provider)];
    const other = ends[0] === id ? ends[1] : ends[1] === id ? ends[0] : undefined;
    if (other !== undefined) neighbours.set(other, (neighbours.get(other) ?? 0) + 1);
  }
  const buttons = [...neighbours].map(([other, count]) =>
    h('button', { type: 'button', class: 'chip', 'data-key': `pair ${other}`, click: () => ground.choose({ pair: [id, other].sort() as [string, string] }) },
      `${other === id ? 'inside' : (ground.moment.participants.get(other)?.name ?? other)} ${count}`));
  const modules = new Map<string, { name: string; services: Service[]; requests: Request[] }>();
  const moduleOf = (peer: string, name: string) => {
    const known = modules.get(peer) ?? { name, services: [], requests: [] };
    modules.set(peer, known);
    return known;
  };
  for (const service of ground.moment.services.values()) if (participantOf(service.provider) === id) moduleOf(service.provider, service.name).services.push(service);
  for (const request of ground.moment.requests.values()) if (participantOf(request.consumer) === id) moduleOf(request.consumer, request.name).requests.push(request);
  const folded = [...modules.values()].sort((a, b) => a.name.localeCompare(b.name)).map((module) =>
    h('details', {}, h('summary', { 'data-key': `module ${module.name}` },
      ...(module.requests.some((request) => !request.served) ? [mark(false)] : []), h('b', {}, module.name),
      ` offers ${module.services.length}, asks ${module.requests.length}`),
      h('ul', { class: 'entries' },
        ...module.services.map((service) => h('li', {}, `offers ${identityText(service)} `, h('small', {}, [service.mode, ...placeOf(service), ...(service.reachable === false ? ['not reachable'] : []), ...(service.used ? [] : ['nobody takes it'])].join(', ')))),
        ...module.requests.map((request) => h('li', {}, mark(request.served), `asks for ${identityText(request)} `, h('small', {}, request.mode),
          ...(ground.isNow ? [asking('Why', `request ${request.subscription}`, () => requestAnswer(request))] : []))))));
  refill(bodyOf('detail'), back(ground), facts, h('h3', {}, 'Matches with'), h('div', { class: 'chips' }, ...buttons), h('h3', {}, 'Modules'), ...folded);
}

/** A finding whole: how it was seen, and the remedy. */
export function showFinding(finding: Finding, ground: Ground): void {
  title('What to do');
  refill(bodyOf('detail'), back(ground), h('p', {}, h('b', {}, finding.title)), h('p', { class: 'mend' }, `→ ${finding.text}`),
    ...(finding.command === undefined ? [] : [h('pre', {}, h('code', {}, finding.command))]),
    ...(finding.seen === undefined ? [] : [h('p', {}, h('small', {}, `Seen by: ${finding.seen}`))]),
    ...finding.places.flatMap((id) => {
      const name = ground.moment.participants.get(id)?.name;
      return name === undefined ? [] : [h('button', { type: 'button', class: 'chip', 'data-key': `place ${id}`, click: () => ground.choose({ participant: id }) }, name)];
    }));
}

export async function showRequest(request: Request, ground: Ground): Promise<void> {
  title(`${request.participant_name} ${request.name}`);
  const body = bodyOf('detail');
  const head = h('p', {}, 'asks for ', h('b', {}, identityText(request)), ` (${request.mode}, ${request.match})`);
  refill(body, back(ground), head, h('p', {}, 'Asking why …'));
  try {
    const answer = await requestAnswer(request);
    refill(body, back(ground), head, answer);
  } catch (error) {
    refill(body, back(ground), head, h('p', { class: 'error' }, error instanceof Error ? error.message : String(error)));
  }
}
