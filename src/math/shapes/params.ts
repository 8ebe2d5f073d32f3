import {
  InvalidInput,
  refused,
  requireFinite,
  requireFiniteVector,
  requireNonZero,
} from '../invalid-input.ts';
import { AXES, type Axis, type Vec3 } from '../vec3.ts';

/** What every parameter says of itself; menus, sliders, links and checks follow from it. */
interface ParamBase {
  /** The shape's property: `vertex`. */
  readonly key: string;
  /** The course's symbol, and the key in a link: `V`. */
  readonly symbol: string;
  /** What it is, in a word or two: `vertex`. */
  readonly title: string;
}

/** A point, in units of length, or a normal, of any length but 0. */
export interface VectorParam extends ParamBase {
  readonly type: 'vector';
  readonly initial: Vec3;
  /** What a link without it means, where that is not `initial`: old links keep their ray. */
  readonly linkDefault?: Vec3;
  /** Where the sliders end; typed values may lie beyond. */
  readonly range: readonly [number, number];
  readonly step: number;
  readonly nonZero?: boolean;
}

/** A length or a ratio. */
export interface NumberParam extends ParamBase {
  readonly type: 'number';
  readonly initial: number;
  /** As a vector has it. */
  readonly linkDefault?: number;
  readonly range: readonly [number, number];
  readonly step: number;
  /** What it is measured in; a ratio stays when a whole scene is scaled. */
  readonly unit: 'length' | 'ratio';
  /** Smallest value allowed, if there is one. */
  readonly least?: number;
}

/** One of the three axes. */
export interface AxisParam extends ParamBase {
  readonly type: 'axis';
  readonly initial: Axis;
  /** As a vector has it. */
  readonly linkDefault?: Axis;
}

/** A parameter of a shape, as its entry declares it. */
export type Param = VectorParam | NumberParam | AxisParam;

/** A point in space. */
export const POINT = { type: 'vector', range: [-5, 5], step: 0.1 } as const;

/** The normal of a plane, of any length but zero. */
export const NORMAL = {
  type: 'vector',
  key: 'normal',
  symbol: 'N',
  title: 'normal',
  range: [-2, 2],
  step: 0.1,
  nonZero: true,
} as const;

/** A length, 0 allowed. */
export const LENGTH = {
  type: 'number',
  range: [0, 4],
  step: 0.05,
  unit: 'length',
  least: 0,
} as const;

/**
 * Nothing, if `value` is allowed for the parameter.
 *
 * @param param one of an entry's `params`.
 * @param value what was given for it.
 * @throws InvalidInput with a message that quotes the value.
 * @example
 * const [, radius] = findShape('sphere')!.params;
 * checkParam(radius!, 0); // → undefined
 * checkParam(radius!, '1'); // throws InvalidInput: radius must be a finite number, got '1'
 */
export function checkParam(param: Param, value: unknown): void {
  if (param.type === 'axis') {
    if (!AXES.includes(value as Axis)) {
      throw refused(param.key, 'must be x, y or z', value);
    }
  } else if (param.type === 'number') {
    requireFinite(param.key, value);
    if (param.least !== undefined && value < param.least) {
      throw new InvalidInput(`${param.key} must be ≥ ${param.least}, got ${value}`);
    }
  } else {
    requireFiniteVector(param.key, value);
    if (param.nonZero) requireNonZero(param.key, value);
  }
}
