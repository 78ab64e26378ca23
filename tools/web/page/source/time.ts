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

/** A time of day, as it is here. */
export const clock = (time: number): string => new Date(time).toLocaleTimeString([], { hour12: false });
