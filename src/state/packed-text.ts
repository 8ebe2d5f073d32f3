import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { InvalidInput } from '../math/index.ts';
import { quote } from '../math/shapes.ts';

/* Texts compressed for links: deflate, then base64url (RFC 4648). */

const LONGEST = 30_000;
/** Bytes that are inflated at a time: a text that is too long is refused within one portion. */
const PORTION = 1024;

export function packed(text: string): string {
  const bytes = deflateSync(strToU8(text), { level: 9 });
  return btoa(strFromU8(bytes, true)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/**
 * The text of a packed one.
 *
 * @param what is packed, for messages: 'scene'.
 * @param longest bytes of the text, at most.
 * @throws InvalidInput with what is wrong with it.
 */
export function unpacked(text: string, what: string, longest: number): string {
  if (text.length > LONGEST) {
    throw new InvalidInput(
      `a ${what} in a link has at most ${LONGEST} letters, got ${text.length}`,
    );
  }
  try {
    const bytes = strToU8(atob(text.replace(/-/g, '+').replace(/_/g, '/')), true);
    return inflated(bytes, what, longest);
  } catch (error) {
    if (error instanceof InvalidInput) throw error;
    throw new InvalidInput(`${quote(`~${text.slice(0, 20)}`)} is not a packed ${what}`);
  }
}

/** Deflate may make 1032 bytes of one, so inflating stops at `longest`. */
function inflated(bytes: Uint8Array, what: string, longest: number): string {
  const parts: Uint8Array[] = [];
  let length = 0;
  let ended = false;
  const stream = new Inflate((part, isLast) => {
    parts.push(part);
    length += part.length;
    ended = isLast;
  });
  for (let at = 0; at < bytes.length; at += PORTION) {
    stream.push(bytes.subarray(at, at + PORTION), at + PORTION >= bytes.length);
    if (length > longest) {
      throw new InvalidInput(`a packed ${what} has at most ${longest} characters`);
    }
  }
  if (!ended) throw new RangeError('it ends too early');
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return strFromU8(whole);
}
