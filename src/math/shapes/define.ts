import type { Values } from '../formula/evaluate.ts';
import type { Relation } from '../formula/expr.ts';
import type { Vec3 } from '../vec3.ts';
import type { CurvedFormula } from './axial-quadric.ts';
import type { Body } from './body.ts';
import type { Drawing, Stage } from './drawing.ts';
import type { KernelNumbers } from './numbers.ts';
import type { Param } from './params.ts';
import type { FlatFormula } from './planar.ts';

/** The trees of a shape. */
export type Formula = CurvedFormula | FlatFormula;

/** What a shape is with its present parameters, and how its special places are called. */
export interface Naming {
  /** 'cone', 'sphere'; 'axis' or 'point' where that is all that is left. */
  readonly name: string;
  /** Where its normal is zero: 'the vertex'; null where the normal is zero nowhere. */
  readonly singular: string | null;
  /**
   * What a ray with A = 0 is parallel to: 'the axis'; null where A is never 0, or does not exist.
   */
  readonly straight: string | null;
  /** Where a point of a figure lies when 1, 2, … of its conditions hold with equality. */
  readonly border: readonly string[];
}

/** What is left of a surface of revolution that has no width. */
export const AXIS: Naming = {
  name: 'axis',
  singular: 'the axis',
  straight: 'the axis',
  border: [],
};

/** A cone that has a width, wherever it comes from. */
export const CONE: Naming = {
  name: 'cone',
  singular: 'the vertex',
  straight: 'a generator',
  border: [],
};

/** A cylinder that has a width, wherever it comes from. */
export const CYLINDER: Naming = {
  name: 'cylinder',
  singular: null,
  straight: 'the axis',
  border: [],
};

/** A sphere, wherever it comes from. */
export const SPHERE: Naming = { name: 'sphere', singular: null, straight: null, border: [] };

/** A shape of the registry: name, parameters, formula and picture in one value. */
export interface ShapeDefinition<S extends { readonly kind: string }> {
  readonly kind: S['kind'];
  readonly title: string;
  /** Names that people may look for, and the parameters of this shape that make it one. */
  readonly alsoCalled?: Readonly<Record<string, string>>;
  /** A hyperboloid may be a sphere, and a cone of slope 0 only its axis. */
  named(shape: S): Naming;
  /** Its picture in menus: an SVG path in a box of 24 by 24. */
  readonly icon: string;
  readonly params: readonly Param[];
  /**
   * The equation of the surface (a figure's conditions not counted), in x, y, z and the shape's
   * symbols.
   */
  readonly surface: Relation;
  /** Its trees; the square's depend on which axis its normal is. */
  formula(shape: S): Formula;
  /** What its symbols stand for. */
  values(shape: S): Values<number>;
  /**
   * What the fast kernels need; null: its trees serve every method, slowly and with the same
   * answers.
   */
  readonly numbers: KernelNumbers<S>;
  /** What a picture needs: extent, circles, convexity. */
  body(): Body<S>;
  /** Whether src/math/families has families written for it; if not, they are made from `params`. */
  readonly ownFamilies: boolean;
  /**
   * A sentence on what the shape's numbers mean, with its values put in; '' if there is nothing to
   * add.
   */
  meaning(shape: S): string;
  /**
   * The point that the picture keeps in view, and a length of the shape's own about it (0 if it has
   * none).
   */
  anchor(shape: S): { readonly at: Vec3; readonly size: number };
  /** For exactly tangent rays; a flat shape has none. */
  readonly circleNear?: CircleNear<S>;
  draw(shape: S, stage: Stage): Drawing;
}

/**
 * A shape near this one, in numbers of few bits, with a circle near this height whose radius is a
 * multiple of `hypotenuse`; null where there is no circle.
 */
export type CircleNear<S> = (
  shape: S,
  height: number,
  hypotenuse: number,
  bits: number,
) => ShortCircle<S> | null;

interface ShortCircle<S> {
  readonly shape: S;
  /** Over the shape's point. */
  readonly height: number;
  /** Divided by the hypotenuse. */
  readonly unit: number;
  /** The meridian rises by `up` where the radius grows by `out` hypotenuses. */
  readonly out: number;
  readonly up: number;
}
