// The log hook: one line for each cause that a person should know of (src/client/CHANNELS.md, "The log hook").

/** Writes a line where the application has given no hook. */
function toStandardError(line) {
  process.stderr.write(`geminga: ${line}\n`);
}

/** The function of the application, or one that writes to standard error. Throws TypeError. */
export function logHook(log = toStandardError) {
  if (typeof log !== 'function') throw new TypeError('log is a function that takes a line');
  return log;
}
