// Which service each request is given. Requests that ask for the same share one question to the daemon.
import { Refusal, ask, identityParameters, participantOf, type Match, type Request, type RequestAnswer, type Service } from './answers.js';
import { MatchLog } from './match_log.js';
import type { Moment } from './team.js';
import { teamNow } from './time.js';

/** Requests that nobody serves of which the nearest services are drawn, each with the code of why it does not fit. */
const maxRefused = 40;
const nearestDrawn = 2;
/** Requests with fewer places than services of which each is asked about by itself; of further ones no match is drawn. */
const maxChosen = 100;

export type Degree = 'exact' | 'narrower' | 'converted' | 'refused';

export interface Link {
  request: Request;
  service: Service;
  degree: Degree;
  /** The word of the daemon: its degree, or the code of why not. */
  word: string;
  /** The representations on the way, the cost and the converters, where something is converted. */
  steps?: string;
}

/** The least time between two readings, in milliseconds, and how many questions of one reading wait at a time. */
const pause = 1500;
const atOnce = 3;

/** The pause before a question is asked again that was too much for the daemon, in milliseconds, and how often it is. */
const restPause = 1000;
const mostTries = 10;

/** Asks, and asks again where the daemon has too much to do. */
async function askPatiently<Answer>(kind: string, parameters: Record<string, string>): Promise<Answer> {
  for (let tries = 1; ; ++tries) {
    try {
      return await ask<Answer>(kind, parameters);
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 429 || tries === mostTries) throw error;
      await new Promise((rested) => setTimeout(rested, restPause));
    }
  }
}

/** Whether the providers of a request, `PARTICIPANT[/PEER],...`, admit a service. */
function admits(request: Request, service: Service): boolean {
  if (request.provider === undefined) return true;
  return String(request.provider).split(',').some((word) => {
    const [participant, peer] = word.split('/');
    const isThere = participant === service.participant_name || participant === participantOf(service.provider);
    return isThere && (peer === undefined || peer === service.name || `${participantOf(service.provider)}/${peer}` === service.provider);
  });
}

/** Requests of one module name for the same have the same nearest services. */
const refusal = (request: Request): string => `${request.name} ${JSON.stringify(question(request))}`;

const isPlain = (request: Request): boolean => request.scope === undefined && request.rank === undefined && request.on === undefined;

function question(request: Request): Record<string, string> {
  const parameters: Record<string, string> = { ...identityParameters(request), mode: request.mode, degree: request.match };
  if (request.where !== undefined) parameters['where'] = request.where;
  if (request.convert !== undefined) parameters['convert'] = String(request.convert);
  return parameters;
}

/** `A > B > C, cost 2, by robot2/Camera`. */
function stepsOf(match: Match): { steps?: string } {
  if (match.convert === undefined) return {};
  return { steps: `${match.convert.split('>').join(' → ')}, cost ${match.cost ?? 0}${match.via === undefined ? '' : `, by ${match.via}`}` };
}

const degreeOf = (match: Match): Degree => (match.convert !== undefined ? 'converted' : match.degree === 'exact' ? 'exact' : 'narrower');

export class Matches {
  links: Link[] = [];
  /** The requests that are not drawn, since there are more than maxChosen that would have to be asked about. */
  omitted = 0;
  private asked = 0;
  private readonly log = new MatchLog();
  /** Since when `links` may not hold any more; undefined: they hold. */
  private staleSince: number | undefined;
  private timer: number | undefined;
  private isReading = false;
  private isStale = false;

  constructor(
    private readonly moment: Moment,
    private readonly then: () => void,
  ) {}

  /** The matches at an instant, of which this is the moment; nothing: nobody read them then. */
  at(time: number, moment: Moment): Link[] | undefined {
    return this.log.at(time, moment);
  }

  /** Says that nothing is known from here on, until it is asked anew. */
  lose(): void {
    this.log.lose(teamNow());
  }

  /** Asks anew soon. */
  invalidate(): void {
    this.staleSince ??= teamNow();
    if (this.isReading) {
      this.isStale = true;
      return;
    }
    this.timer ??= window.setTimeout(() => void this.read(), 300);
  }

  private async read(): Promise<void> {
    this.isReading = true;
    this.isStale = false;
    this.asked = 0;
    const stale = this.staleSince ?? teamNow();
    this.staleSince = undefined;
    const groups = new Map<string, Request[]>();
    const refused = new Map<string, Request[]>();
    for (const request of this.moment.requests.values()) {
      if (!request.served) {
        if (refused.size < maxRefused || refused.has(refusal(request))) refused.set(refusal(request), [...(refused.get(refusal(request)) ?? []), request]);
        continue;
      }
      const key = isPlain(request) ? JSON.stringify(question(request)) : request.subscription;
      groups.set(key, [...(groups.get(key) ?? []), request]);
    }
    const waiting = [...groups.values(), ...refused.values()];
    const links: Link[] = [];
    let isWhole = true;
    const work = async (): Promise<void> => {
      for (let group = waiting.pop(); group !== undefined; group = waiting.pop()) {
        try {
          links.push(...(await this.linksOf(group)));
        } catch {
          isWhole = false; // the daemon has too much to do, or is away: the next reading asks again
        }
      }
    };
    await Promise.all(Array.from({ length: atOnce }, work));
    if (isWhole) {
      this.links = links;
      this.omitted = Math.max(0, this.asked - maxChosen);
      this.log.take(links, stale, teamNow());
    } else {
      this.staleSince = stale;
    }
    this.then();
    setTimeout(() => {
      this.isReading = false;
      this.timer = undefined;
      if (this.isStale || !isWhole) this.invalidate();
    }, pause);
  }

  private async linksOf(group: Request[]): Promise<Link[]> {
    const [first] = group;
    if (first === undefined) return [];
    if (!first.served) return this.refused(group, first);
    const matches = isPlain(first) ? await askPatiently<Match[]>('match', question(first)) : [];
    const links: Link[] = [];
    for (const request of group) {
      const protocols = request.protocol?.split(',');
      const fitting = matches.filter(
        (match) => admits(request, match) && (protocols === undefined || protocols.includes(match.protocol ?? '')),
      );
      if (isPlain(request) && (request.limit === 0 || fitting.length <= request.limit)) {
        for (const match of fitting) links.push({ request, service: match, degree: degreeOf(match), word: match.degree, ...stepsOf(match) });
      } else {
        links.push(...(await this.chosen(request, matches)));
      }
    }
    return links;
  }

  /** The nearest services of requests that nobody serves, with the code of what stands in the way. */
  private async refused(group: Request[], first: Request): Promise<Link[]> {
    const answer = await askPatiently<RequestAnswer>('why', { subscription: first.subscription });
    const near = answer.services.filter((one) => !one.ok && one.code !== undefined).slice(0, nearestDrawn);
    return near.flatMap((one) => {
      const service = this.moment.services.get(one.service);
      return service === undefined ? [] : group.map((request): Link => ({ request, service, degree: 'refused', word: one.code ?? '' }));
    });
  }

  /** Links of a request whose places are fewer than the services that meet it: the daemon knows, of four and four. */
  private async chosen(request: Request, matches: Match[]): Promise<Link[]> {
    if (++this.asked > maxChosen) return [];
    const answer = await askPatiently<RequestAnswer>('why', { subscription: request.subscription });
    const links: Link[] = [];
    for (const near of answer.services) {
      const service = this.moment.services.get(near.service);
      if (service === undefined) continue;
      const isOutranked = near.code === 'outranked' || near.code === 'incumbent';
      if (near.ok) {
        const match = matches.find((one) => one.service === near.service);
        const degree = match !== undefined ? degreeOf(match) : /: exact/.test(near.text) ? 'exact' : 'narrower';
        links.push({ request, service, degree, word: match?.degree ?? degree, ...(match === undefined ? {} : stepsOf(match)) });
      } else if (isOutranked) {
        links.push({ request, service, degree: 'refused', word: near.code ?? 'outranked' });
      }
    }
    return links;
  }
}
