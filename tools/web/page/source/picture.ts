// The picture of the team: robots as boxes in places that stay, and a line for the matches of two of them.
import { forceCollide, forceManyBody, forceSimulation, forceX, forceY, type SimulationNodeDatum } from 'd3-force';
import { participantOf, wayOf, type Participant } from './answers.js';
import { Kept, counted, shortened, svg } from './dom.js';
import type { Degree, Link } from './matches.js';
import type { Moment } from './team.js';

type Named = Pick<Participant, 'id' | 'name' | 'self'>;

interface Place extends SimulationNodeDatum {
  name: string;
}

export interface Choice {
  participant?: string;
  /** Two participants, of whose matches one wants to know. */
  pair?: [string, string];
}

const box = { width: 168, height: 64 };
const storage = 'geminga.places';
const maxPlaces = 500;
/** A box is so many times as large at most, where there is more room than a small team needs. */
const mostScale = 1.25;
export const degrees: Degree[] = ['exact', 'narrower', 'converted', 'refused'];

/** The places of robots by name, so that one that returns is where it was, in this browser also tomorrow. */
class Places {
  private readonly known = new Map<string, Place>();

  constructor() {
    try {
      const kept = JSON.parse(localStorage.getItem(storage) ?? '[]') as [string, number, number][];
      for (const [name, x, y] of kept.slice(-maxPlaces)) this.known.set(name, { name, x, y, fx: x, fy: y });
    } catch {
      // A browser that keeps nothing, or something else by this name: places are found anew.
    }
  }

  of(participants: Participant[]): Map<string, { x: number; y: number }> {
    // Of robots that share a name, each but the first has a place of its own identifier.
    const first = new Map<string, string>();
    for (const one of participants) if (!first.has(one.name)) first.set(one.name, one.id);
    const named = participants.map(({ id, name, self }) => ({ id, name: first.get(name) === id ? name : `${name} ${id}`, self }));
    const missing = named.filter((one) => !this.known.has(one.name)).sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
    if (missing.length > 0) this.find(missing, named);
    return new Map(named.map((one) => [one.id, { x: this.known.get(one.name)?.x ?? 0, y: this.known.get(one.name)?.y ?? 0 }]));
  }

  private find(missing: Named[], all: Named[]): void {
    const others = missing.filter((one) => !one.self);
    // As many rings as give each box room; this host stands in the middle.
    others.forEach((one, at) => {
      const perRing = 7;
      const ring = Math.floor(at / perRing);
      const inRing = Math.min(perRing, others.length - ring * perRing);
      const angle = (2 * Math.PI * (at % perRing)) / inRing - Math.PI / 2 + ring / 2;
      this.known.set(one.name, { name: one.name, x: 265 * (ring + 1) * Math.cos(angle), y: 250 * (ring + 1) * Math.sin(angle) });
    });
    for (const one of missing) if (one.self) this.known.set(one.name, { name: one.name, x: 0, y: 0, fx: 0, fy: 0 });
    const nodes = all.map((one) => this.known.get(one.name)).filter((one) => one !== undefined);
    forceSimulation(nodes)
      .force('apart', forceCollide(box.width * 0.6))
      .force('charge', forceManyBody().strength(-60))
      .force('x', forceX(0).strength(0.02))
      .force('y', forceY(0).strength(0.02))
      .stop()
      .tick(60);
    for (const node of nodes) {
      node.x = Math.round(node.x ?? 0);
      node.y = Math.round(node.y ?? 0);
      node.fx = node.x;
      node.fy = node.y;
    }
    try {
      localStorage.setItem(storage, JSON.stringify([...this.known.values()].map((one) => [one.name, one.x, one.y])));
    } catch {
      // The places hold for this page then.
    }
  }
}

interface Bundle {
  pair: [string, string];
  degree: Degree;
  count: number;
  words: Set<string>;
  steps: Set<string>;
}

/** Matches between two hosts, by degree; those within a host are counted by the host alone. */
function bundled(links: Link[]): { between: Bundle[]; within: Map<string, number> } {
  const between = new Map<string, Bundle>();
  const within = new Map<string, number>();
  for (const link of links) {
    const pair = [participantOf(link.request.consumer), participantOf(link.service.provider)].sort() as [string, string];
    if (pair[0] === pair[1]) {
      if (link.degree !== 'refused') within.set(pair[0], (within.get(pair[0]) ?? 0) + 1);
      continue;
    }
    const key = `${pair.join()} ${link.degree}`;
    const bundle = between.get(key) ?? { pair, degree: link.degree, count: 0, words: new Set<string>(), steps: new Set<string>() };
    bundle.count += 1;
    bundle.words.add(link.word);
    if (link.steps !== undefined) bundle.steps.add(link.steps);
    between.set(key, bundle);
  }
  const inOrder = [...between.values()].sort((a, b) => degrees.indexOf(a.degree) - degrees.indexOf(b.degree));
  return { between: inOrder, within };
}

/** The modules of each participant. */
function modulesOf(moment: Moment): Map<string, Set<string>> {
  const modules = new Map<string, Set<string>>();
  const add = (peer: string): void => {
    const participant = participantOf(peer);
    const known = modules.get(participant);
    if (known === undefined) modules.set(participant, new Set([peer]));
    else known.add(peer);
  };
  for (const service of moment.services.values()) add(service.provider);
  for (const request of moment.requests.values()) add(request.consumer);
  return modules;
}

export interface Drawing {
  moment: Moment;
  links: Link[];
  choice: Choice;
  /** Participants that a finding is about, those that the filter leaves, and requests that nobody serves by participant. */
  wrong: Set<string>;
  shown: (participant: string) => boolean;
  unserved: Map<string, number>;
  gone: { id: string; name: string }[];
}

export class Picture {
  private readonly places = new Places();
  private readonly root = svg('svg', { role: 'group', 'aria-label': 'Robots, and the matches between them', preserveAspectRatio: 'xMidYMid meet' });

  private readonly lineGroup = svg('g', { class: 'lines', 'aria-hidden': 'true' });
  private readonly boxGroup = svg('g');
  private readonly lines = new Kept<SVGElement>();
  private readonly boxes = new Kept<SVGElement>();

  private isCentred = false;

  constructor(
    private readonly parent: Element,
    private readonly choose: (choice: Choice) => void,
  ) {
    parent.append(this.root);
    this.root.append(this.lineGroup, this.boxGroup);
  }

  draw(drawing: Drawing): void {
    const { moment, choice } = drawing;
    const ghosts = drawing.gone.map(({ id, name }) => ({ id, name, self: false }) as Participant);
    const all = [...moment.participants.values(), ...ghosts];
    const places = this.places.of(all);
    const { between, within } = bundled(drawing.links);
    const modules = modulesOf(moment);
    const isChosen = (id: string) => id === choice.participant || choice.pair?.includes(id) === true;
    const hasChoice = choice.participant !== undefined || choice.pair !== undefined;
    for (const bundle of between) {
      const [a, b] = [places.get(bundle.pair[0]), places.get(bundle.pair[1])];
      if (a === undefined || b === undefined) continue;
      const isNear = choice.pair !== undefined ? bundle.pair.every(isChosen) : bundle.pair.some(isChosen);
      const isFaint = (hasChoice && !isNear) || !bundle.pair.every(drawing.shown);
      const of = [a.x, a.y, b.x, b.y, isFaint, isNear, bundle.count, ...bundle.words, ...bundle.steps].join();
      this.lines.take(`${bundle.pair.join()} ${bundle.degree}`, of, () => this.line(bundle, a, b, isFaint, isNear));
    }
    const inOrder = all.sort((a, b) => Number(b.self) - Number(a.self) || a.name.localeCompare(b.name, 'en', { numeric: true }));
    for (const one of inOrder) {
      const at = places.get(one.id) ?? { x: 0, y: 0 };
      const [inside, count, isGone] = [within.get(one.id) ?? 0, modules.get(one.id)?.size ?? 0, !moment.participants.has(one.id)];
      const of = [at.x, at.y, one.id, one.publications, one.subscriptions, inside, count, isGone, isChosen(one.id), drawing.shown(one.id),
        drawing.wrong.has(one.id), wayOf(one), one.reachable, drawing.unserved.get(one.id) ?? 0].join();
      this.boxes.take(one.id, of, () => this.box(one, at, drawing, inside, count, isGone, isChosen(one.id)));
    }
    const xs = [...places.values()].map((place) => place.x);
    const ys = [...places.values()].map((place) => place.y);
    const margin = { x: box.width / 2 + 14, y: box.height / 2 + 14 };
    const [left, top] = [Math.min(0, ...xs) - margin.x, Math.min(0, ...ys) - margin.y];
    const width = Math.max(0, ...xs) + margin.x - left;
    const view = `${left} ${top} ${width} ${Math.max(0, ...ys) + margin.y - top}`;
    if (this.root.getAttribute('viewBox') !== view) {
      this.root.setAttribute('viewBox', view);
      this.root.style.maxWidth = `${width * mostScale}px`;
      this.root.style.setProperty('--own-width', `${width}px`);
    }
    this.lines.put(this.lineGroup);
    this.boxes.put(this.boxGroup);
    if (!this.isCentred && all.length > 0) {
      // On a phone the picture is wider than what is seen of it: this host stands in the middle.
      this.isCentred = true;
      this.parent.scrollLeft = (this.parent.scrollWidth - this.parent.clientWidth) / 2;
    }
  }

  private line(bundle: Bundle, a: { x: number; y: number }, b: { x: number; y: number }, isFaint: boolean, isNear: boolean): SVGElement {
    // Lines of one pair lie beside each other.
    const apart = (degrees.indexOf(bundle.degree) - 1) * 7;
    const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
    const [dx, dy] = [(-(b.y - a.y) / length) * apart, ((b.x - a.x) / length) * apart];
    const ends = { x1: a.x + dx, y1: a.y + dy, x2: b.x + dx, y2: b.y + dy };
    const text = `${bundle.count} ${bundle.degree}${bundle.degree === 'refused' ? ` (${[...bundle.words].join(', ')})` : ''}${[...bundle.steps].map((steps) => `\n${steps}`).join('')}`;
    const group = svg('g', { class: `line ${bundle.degree}${isFaint ? ' faint' : ''}${isNear ? ' near' : ''}`, click: () => this.choose({ pair: bundle.pair }) },
      svg('line', { ...ends, class: 'wide' }),
      svg('line', { ...ends, class: 'thin', 'stroke-width': (1.2 + Math.min(2.4, Math.log2(bundle.count) * 0.5)).toFixed(2) }),
      svg('title', {}, text));
    const words = bundle.degree === 'refused' ? bundle.words : bundle.steps;
    if (isNear && words.size > 0) {
      group.append(svg('text', { x: (a.x + b.x) / 2 + dx, y: (a.y + b.y) / 2 + dy - 4 + (bundle.degree === 'refused' ? 8 : -8), class: 'code' }, shortened([...words].join(', '), 60)));
    }
    return group;
  }

  private box(one: Participant, at: { x: number; y: number }, drawing: Drawing, within: number, modules: number, isGone: boolean, isChosen: boolean): SVGElement {
    const unserved = drawing.unserved.get(one.id) ?? 0;
    const second = isGone ? 'gone' : `${counted(modules, 'module')}${within > 0 ? `, ${within} inside` : ''}`;
    const third = isGone ? 'was here' : `${one.publications} offered, ${one.subscriptions} asked for`;
    const isWrong = drawing.wrong.has(one.id) || isGone;
    const more = `${one.name}, ${within} matches inside${unserved > 0 ? `, ${unserved} requests not served` : ''}${isWrong ? ', something is wrong' : ''}`;
    const choose = () => this.choose({ participant: one.id });
    const way = isGone ? '' : wayOf(one);
    const isApart = !isGone && one.reachable === false;
    const mark = one.self ? 'this host' : isApart ? 'unreachable' : way === '' ? '' : 'relayed';
    const group = svg('g', {
      class: `box${isWrong ? ' wrong' : ''}${isGone ? ' gone' : ''}${one.self ? ' self' : ''}${drawing.shown(one.id) ? '' : ' faint'}${isChosen ? ' chosen' : ''}`,
      transform: `translate(${at.x - box.width / 2} ${at.y - box.height / 2})`,
      tabindex: 0, role: 'button', 'aria-pressed': String(isChosen), 'aria-description': `${more}${way === '' ? '' : `, heard through ${way}`}${isApart ? ', not reachable from this host' : ''}`, 'data-key': `box ${one.name}`,
      click: choose,
      keydown: (event) => {
        if (event instanceof KeyboardEvent && (event.key === 'Enter' || event.key === ' ')) {
          event.preventDefault();
          choose();
        }
      },
    },
      svg('rect', { width: box.width, height: box.height, rx: 8 }),
      svg('text', { x: 12, y: 21, class: 'name' }, shortened(one.name, mark === '' ? 15 : isApart ? 9 : 11)), ' ',
      svg('text', { x: 12, y: 38 }, second), ', ',
      svg('text', { x: 12, y: 53 }, third), ' ');
    if (mark !== '') group.append(svg('text', { x: box.width - 10, y: 20, class: 'this' }, mark));
    if (way !== '') group.append(svg('title', {}, `heard through ${way}`));
    if (unserved > 0) {
      group.append(svg('circle', { cx: box.width - 3, cy: 4, r: 11, class: 'badge' }), svg('text', { x: box.width - 3, y: 8, class: 'badge-text' }, String(unserved)));
    }
    return group;
  }
}
