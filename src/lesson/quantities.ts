import { definitionOf } from '../math/shapes.ts';
import type { ExploreModel } from '../state/derive.ts';
import { paramValue } from '../state/state.ts';

/*
 * The numbers that Explore shows, by the names that its elements carry in data-quantity. In prose
 * they are written {t1}, {E.x}; on other pages {textbook.t1} is the t1 of the row of textbook, and
 * {certified.simd ratio} what that row's two words name.
 */

const NAME = /^(?:[\w-]+\.)?[A-Za-z]\w*(?:[. ][A-Za-z]\w*|\.\([^)]*\))?$/;

/** Whether a text can be the name of a quantity. */
export const isQuantity = (name: string): boolean => NAME.test(name);

/**
 * The value of a quantity on Explore; null if it does not exist, as t2 of a tangent. "class" and
 * "name" (the shape's name for these parameters) are words.
 */
export function quantityOf(model: ExploreModel, name: string): number | string | null {
  const { found, title, derivation } = model;
  if (name === 'class') return found.class;
  if (name === 'name') return title;
  const step = derivation.steps.find(({ id }) => id === name);
  if (step) return step.value;
  return (
    hitNumber(model, name) ??
    rayNumber(model, name) ??
    heightNumber(model, name) ??
    shapeNumber(model, name)
  );
}

/** Whether Explore has such a quantity for this shape, though perhaps not for this ray. */
export const isQuantityOf = (model: ExploreModel, name: string): boolean =>
  /^(t[12]|[PN][12]\.[xyz])$/.test(name) || quantityOf(model, name) !== null;

/** The exact sign of a coefficient; null for other quantities. */
export function signOf({ found }: ExploreModel, name: string): number | null {
  const { details } = found;
  if (details.family !== 'curved') return null;
  return name in details.signs ? details.signs[name as keyof typeof details.signs] : null;
}

const axisAt = (name: string): number => ['x', 'y', 'z'].indexOf(name);

function hitNumber({ hits, found }: ExploreModel, name: string): number | null {
  const [, letter = '', index = '', axis = ''] = name.match(/^([tPN])([12])(?:\.([xyz]))?$/) ?? [];
  const words = hits.find((one) => String(one.index) === index && one.role !== 'outside');
  if (!words) return null;
  if (letter === 't') return axis === '' ? words.t : null;
  const hit = found.hits[Number(index) - 1];
  const v = letter === 'P' ? hit?.point : hit?.singular ? undefined : hit?.normal;
  return v?.[axisAt(axis)] ?? null;
}

function rayNumber({ state, ray }: ExploreModel, name: string): number | null {
  const [letter = '', axis = ''] = name.split('.');
  const v = letter === 'E' ? state.E : letter === 'd' ? ray.direction : null;
  return v?.[axisAt(axis)] ?? null;
}

function heightNumber({ state: { between } }: ExploreModel, name: string): number | null {
  const at = ['low', 'high'].indexOf(name);
  return between?.[at] ?? null;
}

function shapeNumber({ shape }: ExploreModel, name: string): number | string | null {
  const [letter = '', axis = ''] = name.split('.');
  const param = definitionOf(shape).params.find(({ symbol }) => symbol === letter);
  if (!param) return null;
  const value = paramValue(shape, param.key);
  if (typeof value === 'object') return value[axisAt(axis)] ?? null;
  return axis === '' ? value : null;
}
