import { type Marks, numberTriple } from '../../math/formula.ts';
import type { Hit } from '../../math/index.ts';
import type { PlaneHit } from '../../math/shapes.ts';
import type { ExploreModel } from '../derive.ts';
import type { CapHit } from '../ended.ts';
import { CAP_NAMES } from '../ends.ts';
import type { HitWords } from '../verdict-words.ts';
import { DIGITS, type ExportLine, equation, number } from './line.ts';

/** Lines for every root on the page, with its point and normal; also for a rejected one. */
export function hitLines<M>(
  { hits, found, ended }: ExploreModel,
  marks: Marks<M>,
): ExportLine<M>[] {
  const { details } = found;
  const plane = details.family === 'flat' ? details.plane : null;
  const roots = hits.flatMap((words, i) =>
    words.role === 'outside'
      ? rejectedLines(words, plane, marks)
      : rootLines(words, found.hits[i], marks),
  );
  return [...roots, ...(ended?.capHits ?? []).flatMap((cap) => capLines(cap, marks))];
}

/** Lines for a way through a cap. */
function capLines<M>({ end, hit, text }: CapHit, marks: Marks<M>): ExportLine<M>[] {
  return [
    equation(
      marks.symbol('t', 'scalar'),
      number(hit.t, marks),
      `on the ${CAP_NAMES[end]}: ${text}`,
    ),
    equation(marks.symbol('P', 'vector'), numberTriple(hit.point, marks, DIGITS)),
    equation(marks.symbol('N', 'vector'), numberTriple(hit.normal, marks, DIGITS)),
  ];
}

function rootLines<M>(
  { index, t, text }: HitWords,
  hit: Hit | undefined,
  marks: Marks<M>,
): ExportLine<M>[] {
  const root = marks.indexed('t', index);
  const lines = [equation(root, number(t, marks), text)];
  if (!hit) return lines;
  const along = marks.join([
    marks.symbol('E', 'vector'),
    marks.operator('+'),
    root,
    marks.symbol('d', 'vector'),
  ]);
  const point = marks.join([along, marks.operator('='), numberTriple(hit.point, marks, DIGITS)]);
  const normal = hit.singular
    ? equation(marks.indexed('N', index), number(0, marks), 'no normal at this point')
    : equation(marks.indexed('N', index), numberTriple(hit.normal, marks, DIGITS));
  return [...lines, equation(marks.indexed('P', index), point), normal];
}

/** Lines for a point X of the plane outside of the figure, which is no hit. */
function rejectedLines<M>(
  { t, text }: HitWords,
  hit: PlaneHit | null,
  marks: Marks<M>,
): ExportLine<M>[] {
  return [
    equation(marks.symbol('t', 'scalar'), number(t, marks), text),
    ...(hit ? [equation(marks.symbol('X', 'vector'), numberTriple(hit.point, marks, DIGITS))] : []),
  ];
}
