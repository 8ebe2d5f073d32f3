import type { Values } from '../formula/evaluate.ts';
import type { Relation } from '../formula/expr.ts';
import type { Vec3 } from '../vec3.ts';
import type { CurvedFormula } from './axial-quadric.ts';
import type { Body } from './body.ts';
import type { Drawing, Stage } from './drawing.ts';
import type { KernelNumbers } from './numbers.ts';
import type { Param } from './params.ts';
import type { FlatFormula } from './planar.ts';

export type Formula = CurvedFormula | FlatFormula;

export interface Places {
  /** Where its normal is zero: 'the vertex'. */
  readonly singular: string;
  /** What a ray with A = 0 is parallel to: 'the axis', 'a generator'. */
  readonly straight: string;
}

/** A shape of the registry: name, parameters, formula and picture in one value. */
export interface ShapeDefinition<S extends { readonly kind: string }> {
  readonly kind: S['kind'];
  readonly title: string;
  /** How its special places are called in words; a flat shape has none. */
  readonly places: Places | null;
  /** Its picture in menus: an SVG path in a box of 24 by 24. */
  readonly icon: string;
  readonly params: readonly Param[];
  /** The equation of the surface (a figure's conditions not counted), in x, y, z and the shape's symbols. */
  readonly surface: Relation;
  /** Its trees; the square's depend on which axis its normal is. */
  formula(shape: S): Formula;
  /** What its symbols stand for. */
  values(shape: S): Values<number>;
  /** What the fast kernels need; null: its trees serve every method, slowly and with the same answers. */
  readonly numbers: KernelNumbers<S>;
  /** What a picture needs: extent, circles, convexity. */
  readonly body: Body<S>;
  /** A sentence on what the shape's numbers mean, with its values put in; '' if there is nothing to add. */
  meaning(shape: S): string;
  /** The point that the picture keeps in view, and a length of the shape's own about it (0 if it has none). */
  anchor(shape: S): { readonly at: Vec3; readonly size: number };
  draw(shape: S, stage: Stage): Drawing;
}
