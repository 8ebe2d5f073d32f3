/**
 * A line as a person reads it, worked out in whole numbers: n/d, nothing rounded. Written apart
 * from the printer.
 */
interface Rational {
  readonly n: bigint;
  readonly d: bigint;
}

type Read = Rational | readonly Rational[];

const of = (n: bigint, d = 1n): Rational => (d < 0n ? { n: -n, d: -d } : { n, d });
const add = (a: Rational, b: Rational): Rational => of(a.n * b.d + b.n * a.d, a.d * b.d);
const mul = (a: Rational, b: Rational): Rational => of(a.n * b.n, a.d * b.d);
const negative = (a: Rational): Rational => of(-a.n, a.d);
const sub = (a: Rational, b: Rational): Rational => add(a, negative(b));
const size = (a: Rational): Rational => (a.n < 0n ? negative(a) : a);
export const isAtMost = (a: Rational, b: Rational): boolean => a.n * b.d <= b.n * a.d;

function powerOfTen(exponent: number): Rational {
  const scale = 10n ** BigInt(Math.abs(exponent));
  return exponent < 0 ? of(1n, scale) : of(scale);
}

function numberOf(figures: string): Rational {
  const [whole = '', fraction = ''] = figures.split('.');
  return mul(of(BigInt(whole + fraction)), powerOfTen(-fraction.length));
}

/** Reads 2·0.5^2(−0.2)(1−3), (1,0,2)·(3−1,0,1), [1±2]/[3] and 1.5·10^−9. */
export function readLine(text: string, branch: 1 | -1 = 1): Rational {
  const tokens = text.match(/\d+(?:\.\d+)?|[^\s\d]/g) ?? [];
  let at = 0;
  const take = (): string => tokens[at++] ?? '';
  const single = (x: Read): Rational => {
    if (Array.isArray(x)) throw new Error(`a triple where a number should be: ${text}`);
    return x as Rational;
  };
  const base = (): Read => {
    const token = take();
    if (/^\d/.test(token)) return numberOf(token);
    if (token !== '(' && token !== '[') throw new Error(`'${token}' in ${text}`);
    const parts = [sum()];
    while (tokens[at] === ',') {
      at++;
      parts.push(sum());
    }
    at++;
    return parts.length === 1 ? (parts[0] as Read) : parts.map(single);
  };
  const factor = (): Read => {
    const x = base();
    if (tokens[at] !== '^') return x;
    at++;
    const sign = tokens[at] === '−' ? -1 : 1;
    if (sign < 0) at++;
    const exponent = sign * Number(take());
    const b = single(x);
    if (b.n === 10n * b.d) return powerOfTen(exponent);
    if (exponent !== 2) throw new Error(`a power of ${exponent} in ${text}`);
    return mul(b, b);
  };
  const product = (): Read => {
    if (tokens[at] === '−') {
      at++;
      return negative(single(product()));
    }
    let x = factor();
    for (;;) {
      const next = tokens[at];
      if (next === '·') at++;
      else if (next === '/') {
        at++;
        const under = single(factor());
        if (under.n === 0n) throw new Error(`division by zero in ${text}`);
        x = mul(single(x), of(under.d, under.n));
        continue;
      } else if (next === undefined || !/^[\d([]/.test(next)) return x;
      const y = factor();
      x = Array.isArray(x)
        ? (x as readonly Rational[])
            .map((c, i) => mul(c, (y as readonly Rational[])[i] as Rational))
            .reduce(add)
        : mul(single(x), single(y));
    }
  };
  const sum = (): Read => {
    let x = product();
    for (;;) {
      const sign = tokens[at];
      if (sign !== '+' && sign !== '−' && sign !== '±') return x;
      at++;
      const y = single(product());
      const adds = sign === '+' || (sign === '±' && branch === 1);
      x = add(single(x), adds ? y : negative(y));
    }
  };
  const value = single(sum());
  if (at < tokens.length) throw new Error(`left over: ${tokens.slice(at).join(' ')} of ${text}`);
  return value;
}

/** Whether a line that gives `value` may be written with = before the printed result. */
export function rounds(value: Rational, printed: string, digits = 6): boolean {
  const result = readLine(printed.replaceAll(' ', '').replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/, plainPower));
  if (result.n === 0n) return value.n === 0n;
  // The unit of the last of the six digits.
  let exponent = String(size(result).n).length - String(result.d).length + 1;
  while (!isAtMost(powerOfTen(exponent), size(result))) exponent--;
  const half = mul(of(1n, 2n), powerOfTen(exponent - digits + 1));
  return isAtMost(size(sub(value, result)), half);
}

const plainPower = (raised: string): string =>
  `^${[...raised].map((c) => (c === '⁻' ? '−' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c))).join('')}`;
