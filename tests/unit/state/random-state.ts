import * as fc from 'fast-check';
import { walkLength } from '../../../src/math/formula.ts';
import { METHODS, SHAPES } from '../../../src/math/index.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Param } from '../../../src/math/shapes/params.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import type { Action } from '../../../src/state/actions.ts';
import { NAMED_VIEWS, ZOOM_RANGE } from '../../../src/state/camera-view.ts';
import { LINK_THEMES, PARTS } from '../../../src/state/embed.ts';
import type { Between } from '../../../src/state/heights.ts';
import { ASKS } from '../../../src/state/prediction-ask.ts';
import { type AppState, INITIAL, PAGES } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { parseNumber } from '../../../src/text/parse.ts';

/** Every finite double: −0, subnormals and MAX_VALUE come up often, ordinary numbers too. */
const double = fc.oneof(
  fc.double({ noNaN: true, noDefaultInfinity: true }),
  fc.constantFrom(0, -0, 0.1, 1e21, -1e-7, 5e-324, 2 ** -1022, Number.MAX_VALUE, 1 / 3),
);
const vector: fc.Arbitrary<Vec3> = fc.tuple(double, double, double);
const nonZero = vector.filter((v) => v.some((c) => c !== 0));

function arbitraryOf(param: Param): fc.Arbitrary<unknown> {
  if (param.type === 'axis') return fc.constantFrom('x', 'y', 'z');
  if (param.type === 'vector') return param.nonZero ? nonZero : vector;
  return param.least === undefined ? double : double.filter((x) => x >= (param.least ?? 0));
}

const anyShape: fc.Arbitrary<Shape> = fc.oneof(
  ...SHAPES.map(({ kind, params }) =>
    fc.tuple(...(params as readonly Param[]).map(arbitraryOf)).map((values) => {
      const own = params.map(({ key }, i) => [key, values[i]] as const);
      return { kind, ...Object.fromEntries(own) } as unknown as Shape;
    }),
  ),
);

const view = fc.oneof(
  fc.constantFrom(...NAMED_VIEWS.map(({ id }) => id)),
  fc.record({
    azimuth: double,
    elevation: fc.double({ min: -90, max: 90, noNaN: true }),
    zoom: fc.option(fc.double({ min: ZOOM_RANGE.least, max: ZOOM_RANGE.most, noNaN: true })),
  }),
);

/** Two heights, the lower one first. */
const heights = fc
  .tuple(double, double)
  .filter(([a, b]) => a < b || a > b)
  .map(([a, b]): Between => (a < b ? [a, b] : [b, a]));

/** What people type; each as it is kept. */
const text = fc.constantFrom(
  ...['1/3', 'sqrt(2)', '√2/2', '1e7', '.5', '2·10⁻³', '2^-40', '1/3 + 1', 'tan(30 deg)', '0.30'],
  ...['pi', '6 / 2', 'sqrt 2', '1e+2 * 3', '30°'],
);

/** The state with some of its numbers typed: the first of E and of d, and one of the shape's. */
function typedIn(state: AppState, [E, d, own]: readonly (string | null)[]): AppState {
  const value = (typed: string): number => {
    const parsed = parseNumber(typed);
    return parsed.ok ? parsed.value : Number.NaN;
  };
  let next = state;
  const put = (action: Action): void => {
    next = update(next, action);
  };
  if (E) {
    const [, y, z] = state.E;
    put({ type: 'origin', value: [value(E), y, z], texts: { 'E.x': E } });
  }
  if (d) {
    const [x, y] = state.d;
    put({ type: 'direction', value: [x, y, value(d)], texts: { 'd.z': d } });
  }
  const { kind } = state;
  const param = SHAPES.find((shape) => shape.kind === kind)?.params.at(-1);
  if (own && param?.type === 'number') {
    const texts = { [`${kind}.${param.symbol}`]: own };
    put({ type: 'param', key: param.key, value: value(own), texts });
  }
  return next;
}

/** Any state that a link can carry in full. */
export const anyState: fc.Arbitrary<AppState> = fc
  .record({
    page: fc.constantFrom(...PAGES.filter(({ ray }) => ray).map(({ id }) => id)),
    shape: anyShape,
    E: vector,
    d: nonZero,
    unit: fc.boolean(),
    method: fc.constantFrom(...METHODS.map(({ id }) => id as string)),
    view,
    bead: fc.option(double, { nil: null }),
    texts: fc.array(fc.option(text), { minLength: 3, maxLength: 3 }),
    between: fc.option(heights, { nil: null }),
    caps: fc.boolean(),
    revealed: fc.constantFrom(null, 0),
    ask: fc.option(fc.constantFrom(...ASKS), { nil: null }),
    step: fc.option(fc.integer({ min: 1, max: 9 }), { nil: null }),
    embed: fc.option(fc.subarray([...PARTS]), { nil: null }),
    theme: fc.option(fc.constantFrom(...LINK_THEMES), { nil: null }),
    locks: fc.array(fc.nat(), { maxLength: 3 }),
  })
  .map(({ shape, texts, step, locks, ...rest }) => {
    const params = SHAPES.find(({ kind }) => kind === shape.kind)?.params ?? [];
    const symbols = ['E', 'd', ...params.map(({ symbol }) => symbol)];
    const state: AppState = {
      ...INITIAL,
      ...rest,
      caps: rest.caps && rest.between !== null,
      derive: step && Math.min(step, walkLength(shape)),
      // The look is Explore's own.
      ...(rest.page !== 'explore' && {
        view: INITIAL.view,
        bead: null,
        revealed: null,
        ask: null,
        derive: null,
      }),
      // Pages that are about no ray do not carry its shape's ends.
      ...(!PAGES.some(({ id, ray }) => id === rest.page && ray) && { between: null, caps: false }),
      kind: shape.kind,
      shapes: { ...INITIAL.shapes, [shape.kind]: shape },
    };
    const lock = [...new Set(locks.map((i) => symbols[i % symbols.length] ?? 'E'))];
    return { ...typedIn(state, texts), lock };
  });

/**
 * A picture has to add a few lengths to one another: numbers with that much room below the largest
 * double.
 */
export const PICTURED = 1e300;

/** States whose numbers can be drawn. */
export const anyPicture = anyState.filter(({ kind, shapes, E, d }) =>
  [E, d, ...Object.values(shapes[kind])]
    .flat()
    .every((x) => typeof x !== 'number' || Math.abs(x) <= PICTURED),
);
