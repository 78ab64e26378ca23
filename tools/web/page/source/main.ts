// The page: what is asked when, and which part shows it.
import { ask, identityText, participantOf, type Hearer, type Match, type Ontology, type Participant, type Request, type Security, type Service, type Status } from './answers.js';
import { Curves, sampleEach } from './curves.js';
import { showPair, showParticipant, showRequest, whatIf, type Ground } from './detail.js';
import { bodyOf, byId, clock, h, refill } from './dom.js';
import { Hearing } from './hearing.js';
import { askHistory } from './history.js';
import { Live } from './live.js';
import { Matches, type Link } from './matches.js';
import { OntologyView } from './ontology.js';
import { Picture, degrees, type Choice } from './picture.js';
import { Team, type Moment } from './team.js';
import { Timeline } from './timeline.js';
import { findings, type Finding } from './wrong.js';

const slowly = 10_000;
const redrawEach = 200;
const hearingEach = 1000;
/** The pause after the last letter before a filter is asked about, in milliseconds, and the words that are offered. */
const typing = 400;
const offered = 20;

class Page {
  private readonly team = new Team();
  private readonly matches = new Matches(this.team.now, () => this.redraw());
  private readonly curves = new Curves(bodyOf('numbers'));
  private readonly timeline = new Timeline(bodyOf('timeline'), (time) => this.lookAt(time));
  private readonly words = h('datalist', { id: 'filter-words' });
  private readonly filter = h('input', { id: 'filter', type: 'search', list: 'filter-words', autocomplete: 'off', spellcheck: false, placeholder: 'robot, module, concept or expression', input: () => this.filterSoon() });
  private readonly hearing = new Hearing(bodyOf('hearing'), (id) => this.choose({ participant: id }));
  private readonly ontologyView = new OntologyView(() => this.team.now);
  private readonly mode = h('select', { id: 'mode', change: () => this.redraw() },
    ...['any mode', 'oto', 'otm/stream', 'otm/pubsub'].map((word, at) => h('option', { value: at === 0 ? '' : word }, word)));
  private readonly whatIf = whatIf((matches) => this.mark(matches));
  private readonly picture: Picture;
  private choice: Choice = {};
  private chosenRequest: Request | undefined;
  private candidates = new Set<string>();
  /** The services that match what the filter says, where it is a concept or an expression. */
  private matching: Set<string> | undefined;
  private filtering: number | undefined;
  private hearers: Hearer[] = [];
  private recording: { name: string; end: number } | undefined;
  private past: { time: number; moment: Moment } | undefined;
  private absence = '';
  private heardDrawn = 0;
  private foundLast = '';
  private lastHeard = Date.now();
  private unmatched: Request[] = [];
  private ontology: Ontology | undefined;
  private security: Security | undefined;
  private status: Status | undefined;
  private drawing: number | undefined;
  private askingSoon: number | undefined;

  constructor() {
    const body = bodyOf('picture');
    body.append(h('div', { class: 'filters' }, h('label', { for: 'filter' }, 'Show'), this.filter, this.words, h('label', { for: 'mode', class: 'hidden' }, 'Mode'), this.mode,
      h('ul', { class: 'legend', 'aria-label': 'Lines' }, ...degrees.map((word) => h('li', { class: word }, word === 'refused' ? 'refused, outranked' : word)))));
    const drawing = h('div', { class: 'drawing' });
    body.append(drawing);
    this.picture = new Picture(drawing, (choice) => this.choose(choice));
    refill(bodyOf('detail'), this.whatIf);
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.choose({});
    });
    void this.start();
  }

  /** Takes the hour that geminga-web has kept, and then follows the team. */
  private async start(): Promise<void> {
    const history = await askHistory();
    this.team.recall(history);
    this.curves.recall(history.samples);
    if (history.recording !== undefined && history.end !== undefined) {
      this.recording = { name: history.recording, end: Date.parse(history.end) };
      this.timeline.beRecording();
      for (const id of ['ontology', 'numbers']) byId(id).hidden = true;
      this.detail();
      setInterval(() => this.redraw(), hearingEach);
      return this.redraw();
    }
    new Live(this.team, {
      changed: (kind) => {
        if (kind !== 'participants') this.askSoon();
        this.redraw();
      },
      absent: (reason) => this.absent(reason),
    });
    void this.sample();
    void this.look();
    setInterval(() => void this.sample(), sampleEach);
    setInterval(() => void this.look(), slowly);
  }

  /** Asks what a filter matches that is a concept or an expression, and offers the names that begin so. */
  private filterSoon(): void {
    this.matching = undefined;
    this.redraw();
    clearTimeout(this.filtering);
    this.filtering = window.setTimeout(() => void this.askFilter(this.filter.value.trim()), typing);
  }

  private async askFilter(word: string): Promise<void> {
    if (this.recording !== undefined || !/[:<(]| and | or | some | not /.test(word)) return;
    const [names, matches] = await Promise.allSettled([
      ask<{ concept: string }[]>('concepts', { begin: word, limit: String(offered) }), ask<Match[]>('match', { concept: word })]);
    if (word !== this.filter.value.trim()) return;
    if (names.status === 'fulfilled') refill(this.words, ...names.value.map((one) => h('option', { value: one.concept })));
    this.matching = matches.status === 'fulfilled' ? new Set(matches.value.map((one) => one.service)) : undefined;
    this.redraw();
  }

  /** Asks for matches and reasons, when entries have changed. */
  private askSoon(): void {
    this.matches.invalidate();
    this.askingSoon ??= window.setTimeout(() => {
      this.askingSoon = undefined;
      void this.reasons();
    }, 500);
  }

  private async reasons(): Promise<void> {
    try {
      this.unmatched = await ask<Request[]>('requests', { unmatched: '1' });
    } catch {
      return; // the stream says that the daemon is away
    }
    this.redraw();
  }

  /** Asks for what changes with each announcement, which no stream tells: loss and age, and the daemon's counts. */
  private async sample(): Promise<void> {
    if (document.hidden) return;
    try {
      const [status, participants, hearers] = await Promise.all([ask<Status>('status'), ask<Participant[]>('participants'), ask<Hearer[]>('hearing').catch(() => [])]);
      this.hearers = hearers;
      this.status = status;
      this.lastHeard = Date.now();
      for (const one of participants) if (this.team.now.participants.has(one.id)) this.team.now.participants.set(one.id, one);
    } catch {
      this.status = undefined;
    }
    this.curves.add(Date.now(), this.status, [...this.team.now.participants.values()], this.unmatched.length);
    this.redraw();
  }

  private async look(): Promise<void> {
    if (document.hidden) return;
    try {
      [this.ontology, this.security] = await Promise.all([ask<Ontology>('ontology'), ask<Security>('security')]);
    } catch {
      return; // the stream says that the daemon is away
    }
    this.ontologyView.show(this.ontology);
    await this.reasons();
    this.redraw();
  }

  private absent(reason: string): void {
    this.absence = reason;
    if (reason === '') this.askSoon();
    this.redraw();
  }

  private lookAt(time: number | undefined): void {
    this.past = time === undefined ? undefined : { time, moment: this.team.at(time) };
    this.redraw();
  }

  private choose(choice: Choice): void {
    this.choice = choice;
    this.chosenRequest = undefined;
    this.candidates.clear();
    this.redraw();
    this.detail();
  }

  private mark(matches: Match[]): void {
    this.candidates = new Set(matches.map((match) => participantOf(match.provider)));
    this.redraw();
  }

  private open(finding: Finding): void {
    this.choice = finding.places[0] === undefined ? {} : { participant: finding.places[0] };
    this.chosenRequest = finding.request;
    this.redraw();
    this.detail();
    byId('detail').focus({ preventScroll: matchMedia('(min-width: 68rem)').matches });
  }

  private end(): number {
    return this.recording?.end ?? Date.now();
  }

  private moment(): Moment {
    return this.past?.moment ?? this.team.now;
  }

  private ground(): Ground {
    return { moment: this.moment(), links: this.links(), unmatched: this.unmatched, isNow: this.past === undefined && this.absence === '' && this.recording === undefined, choose: (choice) => this.choose(choice) };
  }

  private detail(): void {
    if (this.chosenRequest !== undefined) void showRequest(this.chosenRequest, this.ground());
    else if (this.choice.pair !== undefined) showPair(this.choice.pair, this.ground());
    else if (this.choice.participant !== undefined) showParticipant(this.choice.participant, this.ground());
    else {
      byId('detail-title').textContent = this.recording === undefined ? 'What if' : 'A recording';
      refill(bodyOf('detail'), this.recording === undefined ? this.whatIf
        : h('p', {}, 'It has no ontology: a line joins what states the same names. geminga-query replay says why a request was not served.'));
    }
  }

  /** The matches whose two sides are there at the moment that is looked at, and which the filter leaves. */
  private links(): Link[] {
    const moment = this.moment();
    const mode = this.mode.value;
    const links = this.recording === undefined ? this.matches.links : this.sameNames(moment);
    return links.filter((link) =>
      moment.participants.has(participantOf(link.request.consumer)) && moment.participants.has(participantOf(link.service.provider)) &&
      moment.requests.has(link.request.subscription) && moment.services.has(link.service.service) &&
      (mode === '' || link.request.mode === mode) && (this.matching !== undefined ? this.matching.has(link.service.service) : this.hasWord(link.request) || this.hasWord(link.service)));
  }

  /** Links of what states the same names: a recording has no ontology by which more could be said. */
  private sameNames(moment: Moment): Link[] {
    const services = new Map<string, Service[]>();
    const keyOf = (entry: Request | Service): string => `${identityText(entry)} ${entry.mode}`;
    for (const service of moment.services.values()) services.set(keyOf(service), [...(services.get(keyOf(service)) ?? []), service]);
    return [...moment.requests.values()].filter((request) => request.served).flatMap((request) =>
      (services.get(keyOf(request)) ?? []).map((service): Link => ({ request, service, degree: 'exact', word: 'the same name' })));
  }

  private hasWord(entry: { name: string; participant_name: string; concept?: string; text?: string; id?: number | string }): boolean {
    const word = this.filter.value.trim().toLowerCase();
    return word === '' || `${entry.participant_name} ${entry.name} ${identityText(entry)}`.toLowerCase().includes(word);
  }

  private redraw(): void {
    this.drawing ??= window.setTimeout(() => {
      this.drawing = undefined;
      this.draw();
    }, redrawEach);
  }

  private draw(): void {
    const moment = this.moment();
    const unmatched = this.recording !== undefined ? [...moment.requests.values()].filter((one) => !one.served)
      : this.unmatched.filter((one) => this.team.now.requests.has(one.subscription));
    const until = this.past?.time ?? this.end();
    const list = findings(this.recording !== undefined
      ? { participants: moment.participants, happenings: this.team.happenings.filter((one) => one.time <= until), unmatched, ontology: undefined, security: undefined, status: undefined }
      : { participants: this.team.now.participants, happenings: this.team.happenings, unmatched, ontology: this.ontology, security: this.security, status: this.status });
    this.drawState(moment);
    this.drawFindings(list);
    const filter = this.filter.value.trim();
    const links = this.links();
    const kept = new Set(links.flatMap((link) => [participantOf(link.request.consumer), participantOf(link.service.provider)]));
    const unserved = new Map<string, number>();
    for (const request of moment.requests.values()) {
      if (!request.served) unserved.set(participantOf(request.consumer), (unserved.get(participantOf(request.consumer)) ?? 0) + 1);
    }
    const present = new Set([...moment.participants.values()].map((one) => one.name));
    const gone = new Map<string, string>();
    for (const one of this.team.happenings) {
      if (one.kind !== 'participants' || one.event !== 'del' || one.time > until) continue;
      const { name } = one.record as Participant;
      if (!present.has(name)) gone.set(name, one.key);
    }
    this.picture.draw({
      moment, links, choice: this.choice, unserved,
      wrong: this.past === undefined || this.recording !== undefined ? new Set(list.filter((one) => one.level === 'error' && one.request === undefined).flatMap((one) => one.places)) : new Set(),
      shown: (id) => (this.candidates.size > 0 ? this.candidates.has(id) : filter === '' || kept.has(id)),
      gone: [...gone].map(([name, id]) => ({ id, name })),
    });
    byId('picture').classList.toggle('stale', this.absence !== '');
    if (Date.now() - this.heardDrawn > hearingEach) {
      this.heardDrawn = Date.now();
      this.hearing.draw([...(this.recording === undefined ? this.team.now : moment).participants.values()], this.hearers);
    }
    this.timeline.draw(this.team.happenings, this.team.since, this.end());
  }

  private drawState(moment: Moment): void {
    const absence = byId('absence');
    const missing = this.team.absenceAt(this.past?.time ?? this.end());
    const words = this.recording !== undefined ? `You look at the recording ${this.recording.name}, at ${clock(this.past?.time ?? this.recording.end)}.${missing === '' ? '' : ` The daemon was away then: ${missing}.`}`
      : this.absence !== '' ? `${this.absence}. What you see is how it was at ${clock(this.lastHeard)}.`
      : this.past !== undefined ? `You look at ${clock(this.past.time)}; the lists are of now.${missing === '' ? '' : ` The daemon was away then (${missing}): what you see is how it was before.`}` : '';
    absence.hidden = words === '';
    absence.classList.toggle('past', this.absence === '');
    if (absence.textContent !== words) absence.textContent = words;
    const text = `${this.status?.name ?? ''}${this.status === undefined ? '' : ': '}${moment.participants.size} hosts, ${moment.services.size} services, ${moment.requests.size} requests`;
    if (byId('state').textContent !== text) byId('state').textContent = text;
  }

  private drawFindings(list: Finding[]): void {
    const title = byId('wrong-title');
    const words = list.length === 0 ? 'Nothing is wrong' : `What is wrong (${list.length})`;
    if (title.textContent !== words) title.textContent = words;
    byId('wrong').classList.toggle('fine', list.length === 0);
    const told = JSON.stringify(list);
    if (told === this.foundLast) return;
    this.foundLast = told;
    const name = (id: string) => this.team.now.participants.get(id)?.name ?? '';
    refill(bodyOf('wrong'), list.length === 0 ? h('p', {}, this.team.now.participants.size === 0 ? 'Nobody is known yet.' : 'Every request that is known is served, and every host is heard.')
      : h('ul', { class: 'findings' }, ...list.map((one) => h('li', { class: one.level },
        h('button', { type: 'button', 'data-key': one.key, click: () => this.open(one) },
          h('b', {}, h('span', { class: 'level' }, one.level === 'error' ? '✕ ' : '! '), one.title),
          ...(one.request === undefined ? [] : [h('span', { class: 'places' }, `${one.request.name} on ${one.places.map(name).filter((word) => word !== '').sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).join(', ')}`)]),
          h('span', { class: 'text' }, one.text))))));
  }
}

new Page();
