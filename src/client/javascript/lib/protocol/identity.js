// The 32-bit form of an identity (src/identity/IDENTITY.md).
import { StatementError } from './errors.js';
import { xxh32 } from './xxh32.js';

const hashed = (text) => xxh32(new TextEncoder().encode(text));

/**
 * The 32-bit identity of `{id}`, `{text}`, `{concept, representation}` or `{expression, representation}`. Concepts and
 * representations are full IRIs; an expression is canonical.
 */
export function identity({ id, text, concept, expression, representation }) {
  const kinds = [id, text, concept, expression].filter((kind) => kind !== undefined);
  if (kinds.length !== 1) throw new StatementError('an identity is one of id, text, concept and expression');
  if (id !== undefined) {
    if (!Number.isInteger(id) || id < 0 || id > 0xffffffff) throw new StatementError(`no identity: ${id}`);
    return id;
  }
  if (text !== undefined) return hashed(text);
  const behind = representation ? `<${representation}>` : '';
  return hashed((concept !== undefined ? `<${concept}>` : `(${expression})`) + behind);
}
