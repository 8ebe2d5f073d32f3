import type { MeasuredRow } from '../lab/session.ts';
import type { SweepPoint } from '../lab/sweep.ts';
import type { RayModel } from '../state/accuracy/ladder.ts';
import { shortest } from '../text/format.ts';

/** Everything that was found, with where it comes from. */
export interface Findings {
  readonly provenance: string;
  readonly settings: unknown;
  readonly ray: RayModel;
  readonly rows: readonly MeasuredRow[];
  readonly sweep: readonly SweepPoint[];
}

const HEAD =
  'method,verdict,judgement,t1,t1 digits,t2,t2 digits,rays,wrong,undecided,digits in 9 rays of 10,digits in the worst ray,most ulps,ns low,ns median,ns high,times textbook low,times textbook median,times textbook high,verdict ns median,verdict times textbook median';

/** One line a method; empty where nothing was measured. */
export function toCsv({ ray, rows }: Findings): string {
  const lines = ray.rows.map(({ method, found, judgement, roots }) => {
    const row = rows.find(({ id }) => id === method.id);
    const [first, second] = roots;
    const { quality, roots: timing, classes } = row ?? {};
    return [
      method.id,
      found.class,
      judgement,
      first?.t,
      first?.digits,
      second?.t,
      second?.digits,
      quality?.rays,
      quality?.wrong,
      quality?.undecided,
      quality?.digits,
      quality?.leastDigits,
      quality?.mostUlps,
      timing?.ns.low,
      timing?.ns.median,
      timing?.ns.high,
      timing?.ratio.low,
      timing?.ratio.median,
      timing?.ratio.high,
      classes?.ns.median,
      classes?.ratio.median,
    ]
      .map(cell)
      .join(',');
  });
  return `${[HEAD, ...lines].join('\n')}\n`;
}

function cell(x: string | number | null | undefined): string {
  if (x === undefined || x === null || Number.isNaN(x)) return '';
  return typeof x === 'number' ? shortest(x) : x;
}

/** JSON has no infinities and no NaN: they are written as strings. */
export function toJson({ ray, ...rest }: Findings): string {
  const thisRay = ray.rows.map(({ method, found, judgement, roots }) => ({
    method: method.id,
    verdict: found.class,
    judgement,
    roots: roots.map(({ t, digits, ulps, pointError }) => ({ t, digits, ulps, pointError })),
  }));
  return `${JSON.stringify({ ...rest, thisRay }, finite, 2)}\n`;
}

const finite = (_: string, value: unknown): unknown =>
  typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;
