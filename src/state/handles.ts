import type { Drawing, Grip, Stage } from '../math/drawing.ts';
import {
  coefficients,
  InvalidInput,
  intersect,
  type Ray,
  type Shape,
  type Vec3,
} from '../math/index.ts';
import {
  checkParam,
  definitionOf,
  type NumberParam,
  unitVector,
  type VectorParam,
} from '../math/shapes.ts';
import { display, displayTriple } from '../text/format.ts';
import type { Action, Edit, ParamValue } from './actions.ts';
import { END_PARAMS, endAction, endsRefusal } from './ends.ts';
import type { Between } from './heights.ts';
import type { Probe, Tangency, Value } from './snap.ts';
import { paramValue, RAY_PARAMS } from './state.ts';

interface HandleBase {
  readonly symbol: string;
  /** "E, eye, where the ray starts" */
  readonly label: string;
  readonly text: string;
  readonly step: number;
  /** Whether the step is a length, which grows with the stage. */
  readonly isLength: boolean;
  /** Why a value is not allowed, in the math module's words; null if it is. */
  refusal(value: Value): string | null;
  /** The action that sets the value: a drag gives the value, a key an edit of it. */
  action(value: Edit<Value>): Action;
  /** For snapping to D = 0; null without a discriminant, or while results are hidden. */
  readonly tangency: Tangency | null;
}

/** A handle for a point or a direction. */
export interface PointHandle extends HandleBase {
  readonly type: 'point';
  readonly at: Vec3;
  readonly value: Vec3;
  /**
   * The value that `at` stands for: for E the place itself, for d the vector from E. With a unit d
   * it has another length than `value`.
   */
  readonly here: Vec3;
  /** Where a direction starts; null for a place. */
  readonly origin: Vec3 | null;
}

/** A handle for a number that is shown as a distance, as a radius. */
export interface ReachHandle extends HandleBase {
  readonly type: 'reach';
  readonly grip: Extract<Grip, { type: 'reach' }>;
  readonly value: number;
}

export type Handle = PointHandle | ReachHandle;

interface HandleInput {
  readonly shape: Shape;
  readonly E: Vec3;
  readonly d: Vec3;
  readonly unit: boolean;
  /** The ray that the kernel gets: with `unit`, its direction has length 1. */
  readonly ray: Ray;
  readonly drawing: Drawing;
}

/** Everything in the scene that can be dragged. */
export function handlesOf({ shape, E, d, unit, ray, drawing }: HandleInput): Handle[] {
  const { origin, direction } = ray;
  const pointed = (to: Vec3): Ray => ({ origin, direction: unit ? unitVector(to) : to });
  const eye: PointHandle = {
    ...pointOf(RAY_PARAMS.E, E, E),
    action: (value) => ({ type: 'origin', value: value as Edit<Vec3> }),
    tangency: tangencyOf((value) => [shape, { origin: value as Vec3, direction }]),
  };
  const tip: PointHandle = {
    ...pointOf(RAY_PARAMS.d, d, sum(origin, direction)),
    here: direction,
    origin,
    action: (value) => ({ type: 'direction', value: value as Edit<Vec3> }),
    tangency: tangencyOf((value) => [shape, pointed(value as Vec3)]),
  };
  return [eye, tip, ...drawing.grips.flatMap((grip) => gripHandle(grip, shape, ray))];
}

/** Handles for the ends of a shape, where its axis is at their heights. */
export function heightHandles(shape: Shape, between: Between, stage: Stage): ReachHandle[] {
  const [x, , z] = definitionOf(shape).anchor(shape).at;
  // A reach may not be negative: it is measured from a point below every height of the stage.
  const base = Math.min(between[0], stage.low) - 16 * stage.radius;
  if (!between.every((y) => Number.isFinite(y - base))) return [];
  return END_PARAMS.map(({ symbol, title, step }, i) => {
    const value = between[i as 0 | 1];
    const put = (y: number): Between => (i === 0 ? [y, between[1]] : [between[0], y]);
    return {
      type: 'reach',
      grip: {
        type: 'reach',
        param: symbol,
        from: [x, base, z],
        direction: { along: [0, 1, 0] },
        reach: value - base,
        isLength: true,
        value: (reach) => base + reach,
      },
      value,
      ...{ symbol, label: `${symbol}, ${title}`, text: display(value), step, isLength: true },
      refusal: (y) => endsRefusal(put(y as number)),
      action: (edit) => endAction(i as 0 | 1, edit as Edit<number>),
      tangency: null,
    };
  });
}

function gripHandle(grip: Grip, shape: Shape, ray: Ray): Handle[] {
  const param = definitionOf(shape).params.find(({ key }) => key === grip.param);
  const value = paramValue(shape, grip.param);
  const rest = {
    action: (to: Edit<Value>): Action => ({
      type: 'param',
      key: grip.param,
      value: to as Edit<ParamValue>,
    }),
    tangency: tangencyOf((to) => [{ ...shape, [grip.param]: to } as Shape, ray]),
  };
  if (param?.type === 'vector' && grip.type === 'point') {
    return [{ ...pointOf(param, value as Vec3, grip.at), ...rest }];
  }
  if (param?.type === 'number' && grip.type === 'reach') {
    const base = baseOf(param, display(value as number), grip.isLength);
    return [{ type: 'reach', grip, value: value as number, ...base, ...rest }];
  }
  return [];
}

function pointOf(param: VectorParam, value: Vec3, at: Vec3): Omit<PointHandle, 'action'> {
  const base = baseOf(param, displayTriple(value), true);
  return { type: 'point', at, value, here: value, origin: null, tangency: null, ...base };
}

function baseOf(param: VectorParam | NumberParam, text: string, isLength: boolean) {
  const { symbol, title, step } = param;
  const refusal = (value: Value) => refusalOf(param, value);
  return { symbol, label: `${symbol}, ${title}`, text, step, isLength, refusal };
}

function refusalOf(param: VectorParam | NumberParam, value: Value): string | null {
  try {
    checkParam(param, value);
    return null;
  } catch (error) {
    if (error instanceof InvalidInput) return error.message;
    throw error;
  }
}

const NO_PROBE: Probe = { sign: null, size: Number.NaN, isTangent: false };

/** D and its sign as functions of a handle's value. */
function tangencyOf(scene: (value: Value) => readonly [Shape, Ray]): Tangency {
  return {
    quick(value) {
      try {
        const [shape, ray] = scene(value);
        const { A, B, C } = coefficients(shape, ray, 'textbook');
        return B * B - 4 * A * C;
      } catch {
        return Number.NaN;
      }
    },
    exact(value) {
      try {
        const found = intersect(...scene(value));
        if (found.details.family !== 'curved') return NO_PROBE;
        const { signs, D } = found.details;
        return { sign: signs.D, size: D, isTangent: found.class === 'tangent' };
      } catch (error) {
        if (error instanceof InvalidInput) return NO_PROBE;
        throw error;
      }
    },
  };
}

function sum(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
