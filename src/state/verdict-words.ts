import type { TypedNumber, Values } from '../math/formula.ts';
import type { Intersection, Ray, Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { rootTexts } from '../text/distinguish.ts';
import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import { curvedVerdict } from './curved-verdict.ts';
import type { Ended } from './ended.ts';
import { distanceKnown, flatVerdict } from './flat-verdict.ts';
import type { HitRole } from './scene-model.ts';
import { sideOfPlane, sidesOf } from './sides.ts';
import type { Comparison, Piece } from './verdict-parts.ts';

/** A relation in symbols, and what it means: "D > 0", "two points: the ray enters, then leaves". */
export interface VerdictWords {
  readonly relations: readonly Comparison[];
  /** The sentence, with its computed numbers apart. */
  readonly pieces: readonly Piece[];
  /** The same as one text. */
  readonly text: string;
}

/** A root's role and words as seen from E along the ray. */
export interface HitWords {
  readonly index: number;
  readonly t: number;
  readonly role: HitRole;
  /** "first hit, enters", "behind E", "0.13 outside" */
  readonly text: string;
}

/**
 * The class in words, true of the line and of the ray from E, from the table in verdict-table.ts.
 * `given`: the numbers that `found` is about, if they are not those stored in shape and ray.
 */
export function verdictWords(
  found: Intersection,
  shape: Shape,
  ray: Ray,
  given?: Values<TypedNumber>,
): VerdictWords {
  const { details } = found;
  if (details.family === 'curved') {
    const naming = definitionOf(shape).named(shape);
    const { relations, text } = curvedVerdict(found, details, naming);
    return { relations, pieces: [text], text };
  }
  const { relations, pieces } = flatVerdict(found, details, shape, ray, given);
  return { relations, pieces, text: textOf(pieces) };
}

export const textOf = (pieces: readonly Piece[]): string =>
  pieces.map((piece) => (typeof piece === 'string' ? piece : display(piece.value))).join('');

/**
 * Every root of the whole surface with its role; also a point of the plane outside of the figure.
 */
export function hitWords(found: Intersection, ended: Ended | null = null): HitWords[] {
  const { details } = found;
  if (details.family === 'flat' && details.plane && details.plane.inside === false) {
    const far = distanceKnown(details.plane);
    const text = far === null ? 'outside' : `outside by ${display(far, 3)}`;
    return [{ index: 1, t: details.plane.t, role: 'outside', text }];
  }
  const sides = sidesOf(found);
  const first = ended ? ended.firstRoot : sides.findIndex((side) => side >= 0);
  return found.hits.map(({ t }, i) => {
    const cut = ended?.cut[i];
    if (cut) return { index: i + 1, t, role: 'cut', text: `cut off: ${cut}` };
    const role: HitRole = sides[i] === -1 ? 'behind' : i === first ? 'first' : 'other';
    return { index: i + 1, t, role, text: hitText(found, i, role, sides[i] === 0) };
  });
}

function hitText(found: Intersection, i: number, role: HitRole, atE: boolean): string {
  if (role === 'behind') return 'behind E';
  const start = atE ? 'E itself' : role === 'first' ? 'first hit' : '';
  return [start, crossing(found, i)].filter(Boolean).join(', ');
}

/** "enters" or "leaves" by the sign of f′ at hit `i`, and words for a double root; '' if flat. */
export function crossing(found: Intersection, i: number): string {
  const { class: verdict, hits, details } = found;
  if (details.family === 'flat') return sideOfPlane(found) === 0 ? 'in the plane' : '';
  if (verdict === 'tangent') return hits[i]?.singular ? 'double, no normal' : 'double, touches';
  const { A, B } = details.signs;
  const rising = verdict === 'one' ? B === 1 : (A === 1) === (i === 1);
  return rising ? 'leaves' : 'enters';
}

/** "t₁ = 2.26918, first hit, enters"; two roots never read alike. */
export function hitSentences(hits: readonly HitWords[]): string[] {
  const texts = rootTexts(hits.map(({ t }) => t));
  return hits.map(({ index, text }, i) => `t${subscript(index)} = ${texts[i]}, ${text}`);
}
