import type { HandIn } from '../check/class.ts';
import { askedAt, type Progress, readAsked } from '../check/progress.ts';
import { plan, studentSeed } from '../check/session.ts';
import { isSet } from '../check/sets.ts';
import { InvalidInput } from '../math/index.ts';
import { packed, unpacked } from './packed-text.ts';

/*
 * A hand-in as a code, a text that mail, forms and QR codes carry: graze1.PACKED.CHECK, where
 * PACKED is deflated JSON in base64url,
 *
 *   [set, seed, who, [[tries, solvedAt, hints, solution read, texts, misconceptions] or 0, …]]
 *
 * and CHECK seven letters made of it. They find a code that was cut or mistyped, and deter from
 * changing one; whoever reads this file can make them.
 */

const LONGEST_TEXT = 80;
const LONGEST = 20_000;
const CHECK_LENGTH = 7;

/** The session as it is handed in. */
export function handInOf(progress: Progress, seed: number, who: string): HandIn {
  const slots = plan(progress.seed, progress.set);
  return {
    ...{ set: progress.set, seed, who: who.trim() },
    asked: slots.map((_, i) => askedAt(progress, i)),
  };
}

const UNTOUCHED = JSON.stringify([0, 0, 0, 0, {}, []]);

/** The code of a hand-in. */
export function handInCode({ set, seed, who, asked }: HandIn): string {
  const each = asked.map(({ tries, solvedAt, hints, solutionShown, texts, causes }) => {
    const kept = Object.entries(texts).flatMap(([id, text]) =>
      text.trim() === '' ? [] : [[id, text.trim().slice(0, LONGEST_TEXT)] as const],
    );
    const read = solutionShown ? 1 : 0;
    const row = [tries, solvedAt ?? 0, hints, read, Object.fromEntries(kept), causes];
    return JSON.stringify(row) === UNTOUCHED ? 0 : row;
  });
  const body = packed(JSON.stringify([set, seed, who, each]));
  return `graze1.${body}.${checkOf(body)}`;
}

function checkOf(body: string): string {
  let [a, b] = [0x811c9dc5, 0x2545f491];
  for (const c of `graze ${body}`) {
    a = Math.imul(a ^ c.charCodeAt(0), 0x01000193);
    b = Math.imul(b ^ (c.charCodeAt(0) + (a >>> 16)), 0x85ebca6b);
  }
  const letters = ((a >>> 0) * 2 ** 16 + (b >>> 16)).toString(36);
  return letters.padStart(CHECK_LENGTH, '0').slice(-CHECK_LENGTH);
}

/** Characters that mail programs insert into a long line: breaks, blanks, quotation marks. */
const BREAK = '(?:=?\\s[\\s>]*)?';
const CODE = new RegExp(
  `graze1\\.${BREAK}((?:[\\w-]${BREAK})+)\\.${BREAK}` +
    `((?:[\\da-z]${BREAK}){${CHECK_LENGTH}})(?![\\da-z])`,
  'g',
);

/** The codes in a text, each without the characters that mail programs have inserted. */
export function codesIn(text: string): string[] {
  return [...text.matchAll(CODE)].map(([, body = '', check = '']) => {
    const plain = (part: string): string => part.replace(/[=\s>]+/g, '');
    return `graze1.${plain(body)}.${plain(check)}`;
  });
}

/**
 * The hand-in of a code.
 *
 * @throws InvalidInput with what is wrong with it.
 */
export function readHandIn(code: string): HandIn {
  const [, body = '', check = ''] = /^graze1\.([\w-]+)\.([\da-z]+)$/.exec(code.trim()) ?? [];
  if (body === '') throw new InvalidInput('this is no hand-in code: it begins with graze1.');
  if (checkOf(body) !== check) {
    throw new InvalidInput('the check value does not fit: the code was cut, mistyped or changed');
  }
  const read = handInFrom(unpacked(body, 'hand-in', LONGEST));
  if (!read) throw new InvalidInput('the code holds no hand-in of this version');
  return read;
}

function handInFrom(text: string): HandIn | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (!Array.isArray(value)) return null;
  const [set, seed, who, each] = value as readonly unknown[];
  if (typeof set !== 'string' || !isSet(set) || typeof who !== 'string') return null;
  if (!Number.isSafeInteger(seed) || !Array.isArray(each)) return null;
  const count = plan(studentSeed(seed as number, who), set).length;
  const asked = each.slice(0, count).map((one: unknown) => {
    const list: readonly unknown[] = Array.isArray(one) ? one : [0, 0, 0, 0, {}, []];
    const [tries, solvedAt, hints, read, texts, causes] = list;
    return readAsked({
      ...{ tries, hints, texts, causes },
      solvedAt: solvedAt === 0 ? null : solvedAt,
      solutionShown: read === 1,
    });
  });
  const good = asked.flatMap((one) => (one ? [one] : []));
  if (good.length !== asked.length) return null;
  return { set, seed: seed as number, who: who.slice(0, 200), asked: good };
}
