import { readFileSync } from 'node:fs';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

type Written = number | 'Infinity' | '-Infinity';

export interface VectorCase {
  readonly id: string;
  readonly family: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly expect: {
    readonly class: string;
    readonly degree: number;
    readonly coefficients?: readonly Written[];
    readonly discriminantSign?: number;
    readonly roots: readonly Written[];
    readonly faithful: readonly (readonly Written[])[];
    readonly roots40: readonly string[];
    readonly points: readonly (readonly Written[])[];
    readonly normals: readonly (readonly Written[])[];
    readonly singular: readonly boolean[];
    readonly planeRoot?: Written;
    readonly inside?: boolean | null;
  };
}

interface QuadraticCase {
  readonly source: string;
  readonly A: number;
  readonly B: number;
  readonly C: number;
  readonly class: string;
  readonly roots: readonly Written[];
}

const here = (name: string): URL => new URL(`../../vectors/${name}`, import.meta.url);

export const rayCases: readonly VectorCase[] = ['rays.jsonl', 'more-shapes.jsonl'].flatMap((name) =>
  readFileSync(here(name), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line) as VectorCase),
);

export const quadraticCases: readonly QuadraticCase[] = JSON.parse(
  readFileSync(here('quadratics.json'), 'utf8'),
);

/** A number as the files write it: infinities are strings. */
export const read = (x: Written): number => Number(x);
export const readAll = (xs: readonly Written[]): number[] => xs.map(read);
