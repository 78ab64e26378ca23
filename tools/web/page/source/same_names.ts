// The matches that follow from names alone, for moments of which no ontology can be asked.
import { identityText, type Request, type Service } from './answers.js';
import type { Link } from './matches.js';
import type { Moment } from './team.js';

const keyOf = (entry: Request | Service): string => `${identityText(entry)} ${entry.mode}`;

/** Whether nothing but the identity and the mode decides which services this request is given: all of those. */
const isPlain = (one: Request): boolean =>
  one.served && one.limit === 0 && [one.provider, one.where, one.protocol, one.scope, one.rank].every((word) => word === undefined);

const isOpen = (one: Service): boolean => one.for === undefined && one.scope === undefined;

/** A link for each request without conditions and each service that states the very same: those were so for certain. */
export function sameNames(moment: Moment): Link[] {
  const services = new Map<string, Service[]>();
  for (const service of moment.services.values()) if (isOpen(service)) services.set(keyOf(service), [...(services.get(keyOf(service)) ?? []), service]);
  return [...moment.requests.values()].filter(isPlain).flatMap((request) =>
    (services.get(keyOf(request)) ?? []).map((service): Link => ({ request, service, degree: 'exact', word: 'the same name' })));
}
