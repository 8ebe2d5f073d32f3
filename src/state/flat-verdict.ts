import type { TypedNumber, Values } from '../math/formula.ts';
import type { Intersection, Ray, Shape } from '../math/index.ts';
import {
  borderConditions,
  definitionOf,
  type FlatDetails,
  type PlaneHit,
  spanInFigure,
} from '../math/shapes.ts';
import { sideOfPlane } from './sides.ts';
import { type Comparison, cannotDecide, type Piece, zero } from './verdict-parts.ts';
import { type Sides, STRETCH, sideKey, WHERE } from './verdict-table.ts';

interface FlatVerdict {
  readonly relations: readonly Comparison[];
  readonly pieces: readonly Piece[];
}

/** The verdict in words for a plane, or for a figure in one. */
export function flatVerdict(
  found: Intersection,
  details: FlatDetails,
  shape: Shape,
  ray: Ray,
  given?: Values<TypedNumber>,
): FlatVerdict {
  const { plane, offset, rate, signs } = details;
  if (found.class === 'undecided') {
    return { relations: [], pieces: [cannotDecide({ offset, rate }, signs, LETTERS)] };
  }
  const { name } = definitionOf(shape).named(shape);
  if (plane) {
    const relations: Comparison[] = [{ left: 'N.d', relation: '≠', right: '0' }];
    return { relations, pieces: planePieces(found, plane, name, shape, ray, given) };
  }
  if (found.class === 'none') {
    return { relations: [zero('N.d')], pieces: ['parallel to the plane, beside it: no point'] };
  }
  return {
    relations: [zero('N.d'), zero('N.(E-P)')],
    pieces: ['the line lies in the plane', ...inPlane(details, name, shape, ray, given)],
  };
}

const LETTERS = { offset: 'N·(E − P)', rate: 'N·d' };

function planePieces(
  found: Intersection,
  plane: PlaneHit,
  name: string,
  shape: Shape,
  ray: Ray,
  given?: Values<TypedNumber>,
): Piece[] {
  const where = WHERE[sideKey(sideOfPlane(found))];
  if (found.class === 'one') {
    if (plane.holds.length === 0) return [`one point${where}`];
    const { border } = definitionOf(shape).named(shape);
    const equalities = border.length === 0 ? 0 : borderConditions(shape, ray, given);
    return [`one point, ${border[equalities - 1] ?? `inside the ${name}`}${where}`];
  }
  const far = distanceKnown(plane);
  const by: Piece[] = far === null ? [] : [{ quantity: 'outside', value: far }, ' '];
  return ['the plane is met ', ...by, `outside the ${name}${where}: no point`];
}

/** Distance of a point from the figure; null if the method does not know it or it overflows. */
export function distanceKnown({ distance }: PlaneHit): number | null {
  return distance > 0 && Number.isFinite(distance) ? distance : null;
}

function inPlane(
  { meetsFigure }: FlatDetails,
  name: string,
  shape: Shape,
  ray: Ray,
  given?: Values<TypedNumber>,
): readonly Piece[] {
  if (meetsFigure === null) return [': no single point'];
  if (!meetsFigure) return [` and passes beside the ${name}: no point of it`];
  const span = spanInFigure(shape, ray, given);
  if (!span) return [` and crosses the ${name}: no single point`];
  const [first, last] = span.sides;
  const stretch = STRETCH[`${sideKey(first)}${sideKey(last)}` as Sides];
  const from: Piece = { quantity: 't.from', value: span.from };
  if (span.touches) return [` and touches the ${name} at t = `, from, WHERE[sideKey(first)]];
  const to: Piece = { quantity: 't.to', value: span.to };
  return [` and in the ${name} from t = `, from, ' to t = ', to, stretch];
}
