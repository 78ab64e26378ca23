// The page: what is asked when, and which part shows it.
import { ask, participantOf, type Hearer, type Ontology, type Participant, type Request, type Security, type Status } from './answers.js';
import { Curves, sampleEach } from './curves.js';
import { showFinding, showPair, showParticipant, showRequest, type Ground } from './detail.js';
import { Doctor } from './doctor.js';
import { bodyOf, byId, counted, h, refill } from './dom.js';
import { Filter } from './filter.js';
import { Hearing } from './hearing.js';
import { askHistory } from './history.js';
import { Live } from './live.js';
import { Matches, type Link } from './matches.js';
import { OntologyView } from './ontology.js';
import { Picture, degrees, type Choice } from './picture.js';
import { Rules } from './rules.js';
import { sameNames } from './same_names.js';
import { Team, type Moment } from './team.js';
import { clock, teamNow } from './time.js';
import { Timeline } from './timeline.js';
import { whatIf } from './what_if.js';
import { findings, type Finding } from './wrong.js';
import { WrongList } from './wrong_list.js';

/** The pauses between two readings of what no stream tells and seldom changes, two drawings, and two of who is heard, in milliseconds. */
const slowly = 10_000;
const redrawEach = 200;
const hearingEach = 1000;
/** The time after a change in which further ones may come before reasons are asked for, in milliseconds. */
const reasonsAfter = 500;

class Page {
  private readonly team = new Team();
  private readonly matches = new Matches(this.team.now, () => this.redraw());
  private readonly curves = new Curves(bodyOf('numbers'));
  private readonly timeline = new Timeline(bodyOf('timeline'), (time) => this.lookAt(time));
  private readonly hearing = new Hearing(bodyOf('hearing'), (id) => this.choose({ participant: id }));
  private readonly ontologyView = new OntologyView(() => this.team.now);
  private readonly wrongList = new WrongList((finding) => this.open(finding));
  private readonly whatIf = whatIf((matches) => this.mark(new Set(matches.map((match) => participantOf(match.provider)))));
  private readonly note = h('p', { class: 'note', hidden: true });
  private readonly filter: Filter;
  private readonly picture: Picture;
  private doctor: Doctor | undefined;
  private rules: Rules | undefined;
  private choice: Choice = {};
  /** The finding that was chosen, of which the details are shown. */
  private chosen: Finding | undefined;
  /** The participants that would serve what was asked in the form. */
  private candidates = new Set<string>();
  private hearers: Hearer[] = [];
  private recording: { name: string; end: number } | undefined;
  private past: { time: number; moment: Moment } | undefined;
  private absence = '';
  private heardDrawn = 0;
  private lastHeard = teamNow();
  private unmatched: Request[] = [];
  private ontology: Ontology | undefined;
  private security: Security | undefined;
  private status: Status | undefined;
  private drawing: number | undefined;
  private askingSoon: number | undefined;

  constructor() {
    const filters = h('div', { class: 'filters' });
    const drawing = h('div', { class: 'drawing' });
    this.filter = new Filter(filters, () => this.redraw());
    filters.append(h('ul', { class: 'legend', 'aria-label': 'Lines' }, ...degrees.map((word) => h('li', { class: word }, word === 'refused' ? 'refused, outranked' : word))));
    bodyOf('picture').append(filters, this.note, drawing);
    this.picture = new Picture(drawing, (choice) => this.toggle(choice));
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
      asleep: () => this.matches.lose(),
      awake: (since) => this.recall(since),
    });
    this.doctor = new Doctor(() => this.redraw());
    this.rules = new Rules(() => this.redraw());
    void this.sample();
    void this.look();
    setInterval(() => void this.sample(), sampleEach);
    setInterval(() => void this.look(), slowly);
  }

  /** Takes from geminga-web what has happened since this page was left, if it was there all that time. */
  private async recall(since: number): Promise<void> {
    const history = await askHistory();
    if (history.begin === null || Date.parse(history.begin) > since) return;
    this.team.recall(history);
    this.curves.recall(history.samples);
    this.askSoon();
  }

  /** Asks for matches and reasons, when entries have changed. */
  private askSoon(): void {
    this.matches.invalidate();
    this.askingSoon ??= window.setTimeout(() => {
      this.askingSoon = undefined;
      void this.reasons();
    }, reasonsAfter);
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
      this.lastHeard = teamNow();
      for (const one of participants) if (this.team.now.participants.has(one.id)) this.team.now.participants.set(one.id, one);
    } catch {
      this.status = undefined;
    }
    this.curves.add(teamNow(), this.status, [...this.team.now.participants.values()], this.unmatched.length);
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
    else this.matches.lose();
    this.redraw();
  }

  private lookAt(time: number | undefined): void {
    this.past = time === undefined ? undefined : { time, moment: this.team.at(time) };
    this.redraw();
  }

  private choose(choice: Choice): void {
    this.choice = choice;
    this.chosen = undefined;
    this.candidates.clear();
    this.redraw();
    this.detail();
  }

  /** Chooses, or ends the choice of a robot that is chosen already, unless the details are those of a finding. */
  private toggle(choice: Choice): void {
    const isAgain = choice.participant !== undefined && choice.participant === this.choice.participant;
    this.choose(isAgain && this.chosen === undefined ? {} : choice);
  }

  private mark(candidates: Set<string>): void {
    this.candidates = candidates;
    this.redraw();
  }

  private open(finding: Finding): void {
    this.choice = finding.places[0] === undefined ? {} : { participant: finding.places[0] };
    this.chosen = finding;
    this.redraw();
    this.detail();
    byId('detail').focus({ preventScroll: matchMedia('(min-width: 68rem)').matches });
  }

  /** The present, or the end of a recording. */
  private end(): number {
    return this.recording?.end ?? teamNow();
  }

  private moment(): Moment {
    return this.past?.moment ?? this.team.now;
  }

  private ground(): Ground {
    return { moment: this.moment(), links: this.links().shown, isNow: this.past === undefined && this.absence === '' && this.recording === undefined, choose: (choice) => this.choose(choice) };
  }

  private detail(): void {
    if (this.chosen?.request !== undefined) void showRequest(this.chosen.request, this.ground());
    else if (this.chosen !== undefined) showFinding(this.chosen, this.ground());
    else if (this.choice.pair !== undefined) showPair(this.choice.pair, this.ground());
    else if (this.choice.participant !== undefined) showParticipant(this.choice.participant, this.ground());
    else {
      byId('detail-title').textContent = this.recording === undefined ? 'What if' : 'A recording';
      refill(bodyOf('detail'), this.recording === undefined ? this.whatIf
        : h('p', {}, 'It has no ontology: a line joins a request without conditions and a service that state the same names. geminga-query replay says why a request was not served.'));
    }
  }

  /** The matches of the moment that is looked at which the filter leaves, and whether they are all that there were. */
  private links(): { shown: Link[]; isWhole: boolean } {
    const moment = this.moment();
    const known = this.recording !== undefined ? undefined : this.past === undefined ? this.matches.links : this.matches.at(this.past.time, moment);
    const shown = (known ?? sameNames(moment)).filter((link) =>
      moment.participants.has(participantOf(link.request.consumer)) && moment.participants.has(participantOf(link.service.provider)) &&
      moment.requests.has(link.request.subscription) && moment.services.has(link.service.service) && this.filter.admits(link));
    return { shown, isWhole: known !== undefined };
  }

  private redraw(): void {
    this.drawing ??= window.setTimeout(() => {
      this.drawing = undefined;
      this.draw();
    }, redrawEach);
  }

  private draw(): void {
    const moment = this.moment();
    const list = this.findings(moment);
    this.follow(list);
    this.drawState(moment);
    this.wrongList.draw(list, this.team.now.participants);
    this.drawPicture(moment, list);
    if (Date.now() - this.heardDrawn > hearingEach) {
      this.heardDrawn = Date.now();
      this.hearing.draw([...(this.recording === undefined ? this.team.now : moment).participants.values()], this.hearers);
    }
    this.timeline.draw(this.team.happenings, this.team.since, this.end(), this.rules?.marks ?? []);
  }

  /** Keeps the details of a finding those of the present, since its count and how long it lasts change. Those of a request are asked for once. */
  private follow(list: Finding[]): void {
    const { chosen } = this;
    const now = list.find((one) => one.key === chosen?.key);
    if (now === undefined || now.request !== undefined || JSON.stringify(now) === JSON.stringify(chosen)) return;
    this.chosen = now;
    this.detail();
  }

  /** Faults at present, or at a moment of a recording. */
  private findings(moment: Moment): Finding[] {
    const { happenings, now } = this.team;
    if (this.recording === undefined) {
      return findings({ participants: now.participants, happenings, unmatched: this.unmatched.filter((one) => now.requests.has(one.subscription)),
        ontology: this.ontology, security: this.security, alerted: this.rules?.findings(this.absence === '') ?? [],
        // A replay is not of this host.
        diagnosed: this.status?.recorded === undefined ? (this.doctor?.findings(now.participants) ?? []) : [] });
    }
    const until = this.past?.time ?? this.end();
    return findings({ participants: moment.participants, happenings: happenings.filter((one) => one.time <= until),
      unmatched: [...moment.requests.values()].filter((one) => !one.served), ontology: undefined, security: undefined, diagnosed: [], alerted: [] });
  }

  private drawPicture(moment: Moment, list: Finding[]): void {
    const { shown, isWhole } = this.links();
    const kept = new Set(shown.flatMap((link) => [participantOf(link.request.consumer), participantOf(link.service.provider)]));
    const unserved = new Map<string, number>();
    for (const request of moment.requests.values()) {
      if (!request.served) unserved.set(participantOf(request.consumer), (unserved.get(participantOf(request.consumer)) ?? 0) + 1);
    }
    const isThen = this.past === undefined || this.recording !== undefined;
    this.picture.draw({
      moment, links: shown, choice: this.choice, unserved,
      wrong: isThen ? new Set(list.filter((one) => one.level === 'error' && one.request === undefined).flatMap((one) => one.places)) : new Set(),
      shown: (id) => (this.candidates.size > 0 ? this.candidates.has(id) : this.filter.isEmpty() || kept.has(id)),
      gone: this.team.goneAt(this.past?.time ?? this.end(), moment),
    });
    byId('picture').classList.toggle('stale', this.absence !== '');
    const note = this.noteWords(isWhole);
    this.note.hidden = note === '';
    if (this.note.textContent !== note) this.note.textContent = note;
  }

  /** Words for what the picture does not show; empty: it shows all. */
  private noteWords(isWhole: boolean): string {
    if (this.recording !== undefined) return '';
    if (!isWhole) return 'This page did not look then, so that not all matches are known: a line joins requests without conditions and services that state the same names.';
    if (this.past !== undefined || this.matches.omitted === 0) return '';
    return `${counted(this.matches.omitted, 'request')} with fewer places than services not drawn: a robot tells of each why.`;
  }

  private drawState(moment: Moment): void {
    const absence = byId('absence');
    const words = this.stateWords();
    absence.hidden = words === '';
    absence.classList.toggle('past', this.absence === '');
    if (absence.textContent !== words) absence.textContent = words;
    const whose = this.status === undefined ? '' : `${this.status.name}: `;
    const text = `${whose}${counted(moment.participants.size, 'host')}, ${counted(moment.services.size, 'service')}, ${counted(moment.requests.size, 'request')}`;
    if (byId('state').textContent !== text) byId('state').textContent = text;
  }

  /** Words for the moment that is shown; empty: it is the present. */
  private stateWords(): string {
    const missing = this.team.absenceAt(this.past?.time ?? this.end());
    if (this.recording !== undefined) {
      return `You look at the recording ${this.recording.name}, at ${clock(this.past?.time ?? this.recording.end)}.${missing === '' ? '' : ` The daemon was away then: ${missing}.`}`;
    }
    if (this.absence !== '') return `${this.absence}. What you see is how it was at ${clock(this.lastHeard)}.`;
    if (this.past === undefined) return this.status?.recorded === undefined ? '' : `You look at a replay of a recording, at ${clock(Date.parse(this.status.recorded))}.`;
    return `You look at ${clock(this.past.time)}; the lists are of now.${missing === '' ? '' : ` The daemon was away then (${missing}): what you see is how it was before.`}`;
  }
}

new Page();
