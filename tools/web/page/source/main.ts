// The page: what is asked when, and which part shows it.
import { ask, identityText, participantOf, type Match, type Ontology, type Participant, type Request, type Security, type Status } from './answers.js';
import { Curves, sampleEach } from './curves.js';
import { showPair, showParticipant, showRequest, whatIf, type Ground } from './detail.js';
import { bodyOf, byId, clock, h, refill } from './dom.js';
import { drawHearing } from './hearing.js';
import { Live } from './live.js';
import { Matches, type Link } from './matches.js';
import { Picture, degrees, type Choice } from './picture.js';
import { Team, type Moment } from './team.js';
import { Timeline } from './timeline.js';
import { findings, type Finding } from './wrong.js';

const slowly = 10_000;
const redrawEach = 200;
const hearingEach = 1000;

class Page {
  private readonly team = new Team();
  private readonly opened = Date.now();
  private readonly matches = new Matches(this.team.now, () => this.redraw());
  private readonly curves = new Curves(bodyOf('numbers'));
  private readonly timeline = new Timeline(bodyOf('timeline'), (time) => this.lookAt(time));
  private readonly filter = h('input', { id: 'filter', type: 'search', placeholder: 'module, concept, robot', input: () => this.redraw() });
  private readonly mode = h('select', { id: 'mode', change: () => this.redraw() },
    ...['any mode', 'oto', 'otm/stream', 'otm/pubsub'].map((word, at) => h('option', { value: at === 0 ? '' : word }, word)));
  private readonly whatIf = whatIf((matches) => this.mark(matches));
  private readonly picture: Picture;
  private choice: Choice = {};
  private chosenRequest: Request | undefined;
  private candidates = new Set<string>();
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
    body.append(h('div', { class: 'filters' }, h('label', { for: 'filter' }, 'Show'), this.filter, h('label', { for: 'mode', class: 'hidden' }, 'Mode'), this.mode,
      h('ul', { class: 'legend', 'aria-label': 'Lines' }, ...degrees.map((word) => h('li', { class: word }, word === 'refused' ? 'refused, outranked' : word)))));
    const drawing = h('div', { class: 'drawing' });
    body.append(drawing);
    this.picture = new Picture(drawing, (choice) => this.choose(choice));
    refill(bodyOf('detail'), this.whatIf);
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.choose({});
    });
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

  /** What changes with each announcement, which no stream tells: loss and age, and the daemon's counts. */
  private async sample(): Promise<void> {
    if (document.hidden) return;
    try {
      const [status, participants] = await Promise.all([ask<Status>('status'), ask<Participant[]>('participants')]);
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

  private moment(): Moment {
    return this.past?.moment ?? this.team.now;
  }

  private ground(): Ground {
    return { moment: this.moment(), links: this.links(), unmatched: this.unmatched, isNow: this.past === undefined && this.absence === '', choose: (choice) => this.choose(choice) };
  }

  private detail(): void {
    if (this.chosenRequest !== undefined) void showRequest(this.chosenRequest, this.ground());
    else if (this.choice.pair !== undefined) showPair(this.choice.pair, this.ground());
    else if (this.choice.participant !== undefined) showParticipant(this.choice.participant, this.ground());
    else {
      byId('detail-title').textContent = 'What if';
      refill(bodyOf('detail'), this.whatIf);
    }
  }

  /** The matches whose two sides are there at the moment that is looked at, and which the filter leaves. */
  private links(): Link[] {
    const moment = this.moment();
    const mode = this.mode.value;
    return this.matches.links.filter((link) =>
      moment.participants.has(participantOf(link.request.consumer)) && moment.participants.has(participantOf(link.service.provider)) &&
      moment.requests.has(link.request.subscription) && moment.services.has(link.service.service) &&
      (mode === '' || link.request.mode === mode) && (this.hasWord(link.request) || this.hasWord(link.service)));
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
    const unmatched = this.unmatched.filter((one) => this.team.now.requests.has(one.subscription));
    const list = findings({ participants: this.team.now.participants, happenings: this.team.happenings, unmatched, ontology: this.ontology, security: this.security, status: this.status });
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
      if (one.kind !== 'participants' || one.event !== 'del' || one.time > (this.past?.time ?? Date.now())) continue;
      const { name } = one.record as Participant;
      if (!present.has(name)) gone.set(name, one.key);
    }
    this.picture.draw({
      moment, links, choice: this.choice, unserved,
      wrong: this.past === undefined ? new Set(list.filter((one) => one.level === 'error' && one.request === undefined).flatMap((one) => one.places)) : new Set(),
      shown: (id) => (this.candidates.size > 0 ? this.candidates.has(id) : filter === '' || kept.has(id)),
      gone: [...gone].map(([name, id]) => ({ id, name })),
    });
    byId('picture').classList.toggle('stale', this.absence !== '');
    if (Date.now() - this.heardDrawn > hearingEach) {
      this.heardDrawn = Date.now();
      drawHearing(bodyOf('hearing'), [...this.team.now.participants.values()], (id) => this.choose({ participant: id }));
    }
    this.timeline.draw(this.team.happenings, this.opened);
  }

  private drawState(moment: Moment): void {
    const absence = byId('absence');
    const words = this.absence !== '' ? `${this.absence}. What you see is how it was at ${clock(this.lastHeard)}.`
      : this.past !== undefined ? `You look at ${clock(this.past.time)}; the lists are of now.` : '';
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
