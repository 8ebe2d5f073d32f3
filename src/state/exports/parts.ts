import {
  type CodeSyntax,
  float64,
  type Names,
  printCode,
  type Triple,
  valuesOf,
} from '../../math/formula.ts';
import { intersect } from '../../math/index.ts';
import { AXES, type Axis, definitionOf } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import type { ExploreModel } from '../derive.ts';
import { END_PARAMS } from '../ends.ts';
import { type Program, programOf } from './program.ts';

/** A number or vector of the shape or the ray, by its name in the program. */
export interface Constant {
  readonly name: string;
  readonly value: number | Triple<number>;
  /** What it is: "vertex". */
  readonly title: string;
}

/** The parts of an exported program that do not depend on its language. */
interface Parts {
  readonly program: Program;
  readonly shape: readonly Constant[];
  readonly E: Triple<number>;
  readonly d: Triple<number>;
  /** Null for a shape without ends. */
  readonly ends: Ends | null;
  /** Lines for a comment: what the program is, and what it should answer. */
  readonly about: readonly string[];
  names(component: (vector: string, axis: Axis) => string): Names;
}

/** The ends of a curved shape in a program. */
interface Ends {
  /** low and high. */
  readonly heights: readonly Constant[];
  readonly caps: boolean;
  /** f at a point X, which is C of a ray from there. */
  f(syntax: CodeSyntax): string;
}

function endsOf({ ended, shape }: ExploreModel, own: (id: string) => string): Ends | null {
  const formula = definitionOf(shape).formula(shape);
  if (!ended || formula.family !== 'curved') return null;
  return {
    heights: END_PARAMS.map(({ symbol, title }, i) =>
      constant(symbol, ended.between[i as 0 | 1], title),
    ),
    caps: ended.caps,
    f: (syntax) =>
      printCode(formula.C, syntax, {
        scalar: (id) => id,
        vector: (id) => (id === 'E' ? 'X' : own(id)),
      }),
  };
}

export function partsOf(model: ExploreModel): Parts {
  const definition = definitionOf(model.shape);
  const { scalars, vectors } = definition.values(model.shape);
  const program = programOf(definition.formula(model.shape));
  const taken = program.statements.flatMap((s) => (s.do === 'put' ? [s.name] : []));
  const param = (symbol: string) => definition.params.find((p) => p.symbol === symbol);
  // The coefficient is called C, so a centre C gets its parameter's key as its name.
  const vectorName = (id: string): string => (taken.includes(id) ? (param(id)?.key ?? id) : id);
  const title = (id: string): string => param(id)?.title ?? (id === 'N' ? 'normal' : id);
  const { E, d } = valuesOf(model.shape, model.ray, float64).vectors;
  if (!E || !d) throw new RangeError('a ray without E or d');
  return {
    program,
    shape: [
      ...Object.entries(vectors).map(([id, value]) => constant(vectorName(id), value, title(id))),
      ...Object.entries(scalars).map(([id, value]) => constant(id, value, title(id))),
    ],
    E,
    d,
    ends: endsOf(model, vectorName),
    about: [
      `Where does the ray R(t) = E + t d meet the ${model.title}? By the course's formula, as it ` +
        `is written.`,
      ...(model.ended
        ? [`It is kept between low and high, ${model.ended.caps ? 'closed by discs' : 'open'}.`]
        : []),
      ...expected(model),
    ],
    names: (component) => ({
      scalar: (id) => (isAxis(id) ? component('X', id) : id),
      vector: vectorName,
    }),
  };
}

const constant = (name: string, value: Constant['value'], title: string): Constant => ({
  name,
  value,
  title,
});

/** x, y and z of a formula are the components of the point X. */
function isAxis(id: string): id is Axis {
  return (AXES as readonly string[]).includes(id);
}

/** Comment lines: what the program answers, and what the page says if that differs. */
function expected({ shape, ray, found, ended }: ExploreModel): string[] {
  const solid = ended ? { ...shape, between: ended.between, caps: ended.caps } : shape;
  const textbook = intersect(solid, ray, 'textbook');
  const ts = textbook.hits
    .map(({ t, fate }) => shortest(t) + (fate && fate !== 'hit' ? ` (${fate})` : ''))
    .join(' and ');
  return [
    `Expected in doubles: ${textbook.class}${ts && `, t = ${ts}`}.`,
    ...(found.class === textbook.class
      ? []
      : [`(The page's method, ${found.method}: ${found.class}.)`]),
  ];
}
