// The time of the team, which is that of the host that geminga-web runs on: a browser's clock may be another one.

/** Differences below this are those of the way, in milliseconds. */
const leastSkew = 2000;
let skew = 0;

/** Takes the time of what geminga-web has told just now, in milliseconds since 1970. */
export function takeTime(told: number): void {
  const difference = told - Date.now();
  skew = Math.abs(difference) < leastSkew ? 0 : difference;
}

/** The present by the clock of the team, in milliseconds since 1970. */
export const teamNow = (): number => Date.now() + skew;

/** A span of seconds, in the unit that tells enough of it: `12 s`, `3 min`, `2 h 5 min`. */
export function spanWords(seconds: number): string {
  if (seconds < 60) return `${Math.floor(seconds)} s`;
  const minutes = Math.floor(seconds / 60);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** A time of day, as it is here. */
export const clock = (time: number): string => new Date(time).toLocaleTimeString([], { hour12: false });
