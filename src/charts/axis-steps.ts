/** 1, 2 or 5 times a power of ten, as text parts, so that multiples are exact decimals. */
export interface AxisStep {
  readonly digit: 1 | 2 | 5;
  readonly power: number;
}

/** Largest multiple of a step: beyond it not every integer is a double. */
const LARGEST_WHOLE = Number.MAX_SAFE_INTEGER;
/** Geometric means of neighbours in 1 2 5 10: the nearest step by ratio. */
const [TO_TWO, TO_FIVE, TO_TEN] = [Math.SQRT2, Math.sqrt(10), Math.sqrt(50)];

/** The step nearest to a positive length. */
export function niceStep(length: number): AxisStep {
  const [mantissa = '1', exponent = '0'] = length.toExponential().split('e');
  const [m, power] = [Number(mantissa), Number(exponent)];
  if (m >= TO_TEN) return { digit: 1, power: power + 1 };
  return { digit: m < TO_TWO ? 1 : m < TO_FIVE ? 2 : 5, power };
}

export function stepSize({ digit, power }: AxisStep): number {
  return Number(`${digit}e${power}`);
}

/**
 * The multiple of the step nearest to t, as short as decimals get: 3.4, never 3.4000000000000004.
 */
export function snap(t: number, step: AxisStep): number {
  const multiple = Math.round(t / stepSize(step)) * step.digit;
  if (!(Math.abs(multiple) <= LARGEST_WHOLE)) return t;
  return Number(`${multiple}e${step.power}`) + 0;
}

/** Steps from 0 to a tick at most: fifteen digits, which a double keeps, tell ticks apart. */
const MOST_STEPS = 1e14;

/** The multiples of a nice step from `from` to `to`, about `count` of them; fewer far from 0. */
export function niceTicks(from: number, to: number, count: number): number[] {
  const step = niceStep(Math.max((to - from) / count, Math.max(-from, to) / MOST_STEPS));
  const size = stepSize(step);
  const first = Math.floor(from / size);
  const about = Array.from({ length: 2 * count + 2 }, (_, k) => snap((first + k) * size, step));
  return about.filter((tick) => from <= tick && tick <= to);
}

export function clamp(x: number, low: number, high: number): number {
  return Math.min(Math.max(x, low), high);
}
