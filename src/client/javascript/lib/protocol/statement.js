// One line of GCNP as a statement, and back (src/discovery/gcnp/GCNP.md, "Lines").
import { StatementError } from './errors.js';
import { maxLine, maxParameters } from './limits.js';

const word = /[A-Za-z0-9_.-]+/y;
const bare = /[^ "\u0000-\u001f\u007f]*/y;
const control = /[\u0000-\u001f\u007f]/;
const escapes = { '"': '"', '\\': '\\', n: '\n', r: '\r', t: '\t' };
const written = { '"': '\\"', '\\': '\\\\', '\n': '\\n', '\r': '\\r', '\t': '\\t' };

/** Reads a line from left to right. `at` counts UTF-16 units; errors name octets. */
class Cursor {
  constructor(line, at, id) {
    this.line = line;
    this.at = at;
    this.id = id;
  }
  get atEnd() {
    return this.at === this.line.length;
  }
  get atWordEnd() {
    return this.atEnd || this.line[this.at] === ' ';
  }
  skipSpaces() {
    while (this.line[this.at] === ' ') ++this.at;
  }
  take(pattern) {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.line)?.[0] ?? '';
    this.at += found.length;
    return found;
  }
  fail(text, at = this.at, status = 400) {
    const octet = Buffer.byteLength(this.line.slice(0, at)) + 1;
    throw new StatementError(status === 400 ? `octet ${octet}: ${text}` : text, status, this.id);
  }
}

function takeWord(cursor, what) {
  cursor.skipSpaces();
  if (cursor.atEnd) cursor.fail(`${what} is missing`);
  const found = cursor.take(word);
  if (found === '' || !cursor.atWordEnd) cursor.fail(`no character of a ${what}`);
  return found;
}

function takeQuoted(cursor) {
  const { line } = cursor;
  const begin = cursor.at++;
  let value = '';
  for (;;) {
    if (cursor.atEnd) cursor.fail('the closing quote is missing', begin);
    const c = line[cursor.at++];
    if (c === '"') break;
    if (c !== '\\') {
      value += c;
      continue;
    }
    const meant = escapes[line[cursor.at]];
    if (meant === undefined || !Object.hasOwn(escapes, line[cursor.at])) {
      cursor.fail('no escape: there are \\" \\\\ \\n \\r \\t', cursor.at - 1);
    }
    value += meant;
    ++cursor.at;
  }
  if (!cursor.atWordEnd) cursor.fail('a space is missing after the closing quote');
  return value;
}

function takeParameter(cursor) {
  const key = cursor.take(word);
  if (key === '') cursor.fail("a key is missing: letters, digits, '_', '.' and '-'");
  if (cursor.atWordEnd) return [key, undefined];
  if (cursor.line[cursor.at] !== '=') cursor.fail("no character of a key: letters, digits, '_', '.' and '-'");
  ++cursor.at;
  if (cursor.line[cursor.at] === '"') return [key, takeQuoted(cursor)];
  const value = cursor.take(bare);
  if (!cursor.atWordEnd) cursor.fail('a quote inside a bare value: put the whole value in quotes');
  return [key, value];
}

/**
 * The statement `{id, command, subcommand, parameters}` of a line without its end, where parameters are pairs of key and
 * value, undefined without `=`. An error of the daemon, `N EEE text`, is `{id, code, text}`. Throws StatementError.
 */
export function parseStatement(line) {
  if (Buffer.byteLength(line) > maxLine) throw new StatementError(`a line has at most ${maxLine} octets`, 413);
  const number = /^[^ ]*/.exec(line)[0];
  const id = /^[0-9]+$/.test(number) && Number(number) <= 0xffffffff ? Number(number) : undefined;
  const cursor = new Cursor(line, number.length, id ?? 0);
  const bad = control.exec(line);
  if (bad) cursor.fail('a control character', bad.index);
  if (id === undefined) cursor.fail('a statement begins with an id, a decimal number from 0 to 4294967295', 0);
  const error = /^ ([0-9]{3}) (.*)$/.exec(line.slice(number.length));
  if (error) return { id, code: Number(error[1]), text: error[2] };
  const command = takeWord(cursor, 'command');
  const subcommand = takeWord(cursor, 'subcommand');
  const parameters = [];
  const keys = new Set();
  for (cursor.skipSpaces(); !cursor.atEnd; cursor.skipSpaces()) {
    if (parameters.length === maxParameters) {
      cursor.fail(`a statement has at most ${maxParameters} parameters`, cursor.at, 413);
    }
    const begin = cursor.at;
    const parameter = takeParameter(cursor);
    if (keys.has(parameter[0])) cursor.fail(`${parameter[0]} is given twice: give each key once`, begin);
    keys.add(parameter[0]);
    parameters.push(parameter);
  }
  return { id, command, subcommand, parameters };
}

const decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });

/** The text of a line's octets. Throws StatementError if they are not UTF-8. */
export function decodeLine(octets) {
  try {
    return decoder.decode(octets);
  } catch {
    throw new StatementError('not UTF-8');
  }
}

/** A value as it is written after `key=`. Control characters without an escape become question marks. */
export function formatValue(text) {
  const clean = text.replace(/[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g, '\ufffd');
    if (/^[^ "\u0000-\u001f\u007f]+$/.test(clean)) return clean;
    return `"${clean.replace(/["\\\u0000-\u001f\u007f]/g, (c) => written[c] ?? '?')}"`;
}

/** The line of a statement, without its end. */
export function formatStatement({ id, command, subcommand, parameters, code, text }) {
  if (code !== undefined) return `${id} ${code} ${text}`;
  let line = `${id} ${command} ${subcommand}`;
  for (const [key, value] of parameters) line += value === undefined ? ` ${key}` : ` ${key}=${formatValue(value)}`;
  return line;
}
