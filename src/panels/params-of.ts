import type { Vec3 } from '../math/index.ts';
import { definitionOf, type Param } from '../math/shapes.ts';
import type { Dispatch, Edit, ParamValue } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { paramValue, RAY_PARAMS } from '../state/state.ts';
import type { TypedTexts } from '../state/typed-texts.ts';

/** A parameter with its value, and the actions that set and reset it. */
export interface Handle<P extends Param = Param> {
  readonly param: P;
  readonly value: ParamValue;
  /** `texts`: typed texts of its numbers, under 'E.x', 'c'. */
  readonly send: (value: Edit<ParamValue>, texts?: TypedTexts) => void;
  /** The typed text of one of its numbers; '' if none is kept. */
  readonly typed: (label: string) => string;
  readonly reset: () => void;
  /** Whether its boxes have `data-quantity`; not so for d if the kernel gets d / |d|. */
  readonly quantities: boolean;
  /** Whether the link lets it be as it is. */
  readonly locked: boolean;
}

export function rayHandles({ state }: ExploreModel, dispatch: Dispatch): [Handle, Handle] {
  return [
    {
      param: RAY_PARAMS.E,
      value: state.E,
      send: (value, texts) => dispatch({ type: 'origin', value: value as Edit<Vec3>, texts }),
      typed: (label) => state.typed[label] ?? '',
      reset: () => dispatch({ type: 'reset', what: 'E' }),
      quantities: true,
      locked: state.lock.includes('E'),
    },
    {
      param: RAY_PARAMS.d,
      value: state.d,
      send: (value, texts) => dispatch({ type: 'direction', value: value as Edit<Vec3>, texts }),
      typed: (label) => state.typed[label] ?? '',
      reset: () => dispatch({ type: 'reset', what: 'd' }),
      quantities: !state.unit,
      locked: state.lock.includes('d'),
    },
  ];
}

export function shapeHandles({ state, shape }: ExploreModel, dispatch: Dispatch): Handle[] {
  return definitionOf(shape).params.map((param) => ({
    param,
    value: paramValue(shape, param.key),
    send: (value, texts = {}) =>
      dispatch({ type: 'param', key: param.key, value, texts: ownedBy(shape.kind, texts) }),
    typed: (label) => state.typed[`${shape.kind}.${label}`] ?? '',
    reset: () => dispatch({ type: 'reset', what: { param: param.key } }),
    quantities: true,
    locked: state.lock.includes(param.symbol),
  }));
}

const ownedBy = (kind: string, texts: TypedTexts): TypedTexts =>
  Object.fromEntries(Object.entries(texts).map(([label, text]) => [`${kind}.${label}`, text]));
