import { NONE } from '../../../src/math/batch/batch.ts';
import { ASK, CLASS_BIT } from '../../../src/math/batch/straight-loop.ts';
import { type Format, isPowerOfTwo, type Node } from './graph.ts';
import { INPUTS, type Program } from './program.ts';

/*
 * Loops of TypeScript. A choice by a comparison that is as often true as not would be a branch that
 * no processor foresees: so conditions are numbers, 0 or 1, by which a value is multiplied or
 * fetched. Only what is rare is a branch.
 */

const CALLS: Readonly<Partial<Record<Node['op'], string>>> = {
  abs: 'Math.abs',
  sqrt: 'Math.sqrt',
};
const SIGNS: Readonly<Partial<Record<Node['op'], string>>> = {
  add: '+',
  sub: '-',
  mul: '*',
  div: '/',
};

const isMask = ({ op }: Node): boolean =>
  ['less', 'atMost', 'equal', 'and', 'or', 'not'].includes(op);

/** How many values read each one. */
export function usesOf(roots: readonly Node[]): Map<Node, number> {
  const uses = new Map<Node, number>();
  const walk = (n: Node): void => {
    const before = uses.get(n) ?? 0;
    uses.set(n, before + 1);
    if (before === 0) n.args.forEach(walk);
  };
  roots.forEach(walk);
  return uses;
}

/** Places of the scratch array. */
export interface Scratch {
  count: number;
  /** Values of a block that are handed on. */
  handed: number;
}

/**
 * Writes statements into `lines` and gives the text of each value.
 *
 * @param scratch null where a choice may be a branch.
 */
export function writer(
  { width, strict }: Format,
  uses: ReadonlyMap<Node, number>,
  scratch: Scratch | null,
) {
  const names = new Map<Node, string>();
  let count = 0;
  /** Where a choice may be a branch. */
  let branches = scratch === null;

  function name(text: string, lines: string[]): string {
    const made = `v${count}`;
    count += 1;
    lines.push(`const ${made} = ${text};`);
    return made;
  }

  function literal(x: number): string {
    if (Number.isNaN(x)) return 'Number.NaN';
    const power = Math.log2(Math.abs(x));
    const isFar = x !== 0 && Math.abs(power) > 30 && 2 ** power === Math.abs(x);
    return isFar ? `${x < 0 ? '-' : ''}2 ** ${power}` : String(x);
  }

  const rounded = (text: string): string => (width === 32 ? `fround(${text})` : text);
  const wrapped = (text: string): string =>
    /^[\w.]+(\([^()]*\))?$/.test(text) ? text : `(${text})`;

  function pairOf(a: string, b: string, lines: string[]): number {
    if (!scratch) throw new RangeError('no scratch array');
    const at = scratch.count;
    scratch.count += 2;
    lines.push(`S[${at}] = ${a};`, `S[${at + 1}] = ${b};`);
    return at;
  }

  /** Text that stands for a value wherever it is read again. */
  const held = (n: Node, lines: string[]): string => {
    const text = value(n, lines);
    return /^[\w.-]+$/.test(text) ? text : name(text, lines);
  };

  /** The same choices by branches. */
  function chosen(n: Node, lines: string[]): string | null {
    const [a, b, c] = n.args as [Node, Node, Node];
    switch (n.op) {
      case 'signed': {
        const y = held(b, lines);
        return `${test(a, lines)} ? -${y} : ${y}`;
      }
      case 'select':
        return `${test(a, lines)} ? ${value(b, lines)} : ${value(c, lines)}`;
      case 'min':
      case 'max': {
        const [x, y] = [held(a, lines), held(b, lines)];
        return n.op === 'min' ? `${y} < ${x} ? ${y} : ${x}` : `${y} < ${x} ? ${x} : ${y}`;
      }
      default:
        return null;
    }
  }

  function textOf(n: Node, lines: string[]): string {
    if (branches) {
      const text = chosen(n, lines);
      if (text !== null) return text;
    }
    const of = (k: number): string => value(n.args[k] as Node, lines);
    const call = CALLS[n.op];
    const sign = SIGNS[n.op];
    if (sign) return rounded(`${wrapped(of(0))} ${sign} ${wrapped(of(1))}`);
    if (n.op === 'abs') return `${call}(${of(0)})`;
    if (call) return rounded(`${call}(${of(0)})`);
    switch (n.op) {
      case 'neg':
        return `-${wrapped(of(0))}`;
      case 'constant':
        return literal(n.value);
      case 'keep':
        return `${wrapped(of(1))} * ${bit(n.args[0] as Node, lines)}`;
      case 'signed': {
        const [m, y] = n.args as [Node, Node];
        const scale = scaleOf(y);
        const x = wrapped(value(scale === 1 ? y : (y.args[0] as Node), lines));
        const twice = 2 * scale === 1 ? '' : `${literal(2 * scale)} * `;
        return m.op === 'not'
          ? `${x} * (${twice}${bit(m.args[0] as Node, lines)} - ${literal(scale)})`
          : `${x} * (${literal(scale)} - ${twice}${bit(m, lines)})`;
      }
      case 'unless':
        return `${wrapped(of(1))} * (ONE_OR_NAN[${bit(n.args[0] as Node, lines)}] as number)`;
      case 'select': {
        if (!strict) {
          const m = bit(n.args[0] as Node, lines);
          const b = /^v\d+$/.test(m) ? m : name(m, lines);
          return `${wrapped(of(1))} * ${b} + ${wrapped(of(2))} * (1 - ${b})`;
        }
        const at = pairOf(of(2), of(1), lines);
        return `S[${at} + ${bit(n.args[0] as Node, lines)}] as number`;
      }
      case 'min':
      case 'max': {
        const [a, b] = n.args as [Node, Node];
        const order = `min ${textKey(a)} ${textKey(b)}`;
        let pair = pairs.get(order);
        if (!pair) {
          const at = pairOf(of(0), of(1), lines);
          pair = { at, later: name(`+(${of(1)} < ${of(0)})`, lines) };
          pairs.set(order, pair);
        }
        const { at, later } = pair;
        return n.op === 'min'
          ? `S[${at} + ${later}] as number`
          : `S[${at + 1} - ${later}] as number`;
      }
      default:
        throw new RangeError(`no text for ${n.op}`);
    }
  }

  /** The power of two by which a value is multiplied that is wanted with a sign only; else 1. */
  function scaleOf(n: Node): number {
    const by = n.args[1];
    const isOnce = n.op === 'mul' && (uses.get(n) ?? 0) < 2 && !names.has(n) && width === 64;
    return isOnce && by?.op === 'constant' && isPowerOfTwo(by.value) ? by.value : 1;
  }

  const pairs = new Map<string, { at: number; later: string }>();
  const keys = new Map<Node, number>();
  function textKey(n: Node): number {
    if (!keys.has(n)) keys.set(n, keys.size);
    return keys.get(n) as number;
  }

  function value(n: Node, lines: string[]): string {
    const known = names.get(n);
    if (known) return known;
    const text = textOf(n, lines);
    const alone = (uses.get(n) ?? 0) < 2 && text.length < 48 && !/ as number$/.test(text);
    if (alone || n.op === 'constant') return text;
    const made = name(text, lines);
    names.set(n, made);
    return made;
  }

  /** Beside a sign of comparison. */
  function side(n: Node, lines: string[]): string {
    const text = value(n, lines);
    return text.includes('?') ? `(${text})` : text;
  }

  /** A condition as 0 or 1. */
  function bit(n: Node, lines: string[]): string {
    const known = names.get(n);
    if (known) return known;
    const text = bitText(n, lines);
    if ((uses.get(n) ?? 0) < 2 && text.length < 40) return text;
    const made = name(text, lines);
    names.set(n, made);
    return made;
  }

  function bitText(n: Node, lines: string[]): string {
    const [a, b] = n.args as [Node, Node];
    if (n.op === 'less') return `+(${side(a, lines)} < ${side(b, lines)})`;
    if (n.op === 'atMost') return `+(${side(a, lines)} <= ${side(b, lines)})`;
    if (n.op === 'equal') return `+(${side(a, lines)} === ${side(b, lines)})`;
    if (n.op === 'not') return `(1 - ${bit(a, lines)})`;
    return `(${bit(a, lines)} ${n.op === 'and' ? '&' : '|'} ${bit(b, lines)})`;
  }

  /** A condition for a branch. */
  function test(n: Node, lines: string[]): string {
    const known = names.get(n);
    if (known) return `${known} !== 0`;
    const [a, b] = n.args as [Node, Node];
    if (n.op === 'less') return `${side(a, lines)} < ${side(b, lines)}`;
    if (n.op === 'atMost') return `${side(a, lines)} <= ${side(b, lines)}`;
    if (n.op === 'equal') return `${side(a, lines)} === ${side(b, lines)}`;
    if (n.op === 'not') return `!(${test(a, lines)})`;
    return `(${test(a, lines)} ${n.op === 'and' ? '&&' : '||'} ${test(b, lines)})`;
  }

  /** For what is the same for all rays: worked out once, whatever it is used for. */
  function named(n: Node, lines: string[]): void {
    const text = isMask(n) ? bit(n, lines) : value(n, lines);
    if (!names.has(n)) names.set(n, name(text, lines));
  }

  /** What is written meanwhile may have branches. */
  function branching(write: () => void): void {
    branches = true;
    write();
    branches = scratch === null;
  }

  return {
    names,
    named,
    branching,
    value: (n: Node, lines: string[]) => (isMask(n) ? bit(n, lines) : value(n, lines)),
    test,
  };
}

/** The nodes that are the same for all rays and read by one that is not. */
function uniformsOf(roots: readonly Node[]): Node[] {
  const found = new Set<Node>();
  const seen = new Set<Node>();
  const walk = (n: Node): void => {
    if (seen.has(n)) return;
    seen.add(n);
    if (n.uniform && n.op !== 'constant') found.add(n);
    else n.args.forEach(walk);
  };
  roots.forEach(walk);
  return [...found];
}

/** A function named `name`, given the shape's numbers in the order of `numbers`. */
export function loopOf(
  name: string,
  numbers: readonly string[],
  program: Program,
  scratch: Scratch,
): string {
  const { format, outputs, rare, special, missed, rareRoots, inBlocks, classes } = program;
  const written = Object.entries(outputs);
  const asked = [rare, missed, ...written.map(([, n]) => n), rareRoots];
  const all = [...asked, classes?.margin, classes?.rare, special.verdict, special.t];
  const roots = all.filter((n): n is Node => n !== null && n !== undefined);
  const uses = usesOf(roots);
  const places = { count: 0, handed: 0 };
  const w = writer(format, uses, places);
  const round = roundedTo(format);

  const before: string[] = [];
  const reading = (n: Node): void => {
    if (n.op === 'number' && !w.names.has(n)) {
      const named = `k${numbers.indexOf(n.name)}`;
      before.push(`const ${named} = ${round(`n[${numbers.indexOf(n.name)}] as number`)};`);
      w.names.set(n, named);
    }
    n.args.forEach(reading);
  };
  for (const n of uniformsOf(roots)) {
    reading(n);
    if (!w.names.has(n)) w.named(n, before);
  }
  const inputs = new Set<string>();
  const seen = new Set<Node>();
  const body: string[] = [];
  const collect = (n: Node): void => {
    if (seen.has(n)) return;
    seen.add(n);
    if (n.op === 'input') {
      inputs.add(n.name);
      w.names.set(n, local(n.name));
    }
    n.args.forEach(collect);
  };
  roots.forEach(collect);
  const used = INPUTS.filter((input) => inputs.has(input));
  for (const input of used) {
    body.push(`const ${local(input)} = ${round(`${input}[i] as number`)};`);
  }

  /** Statements of their own block: what they name is not known outside. */
  const block = (fill: (lines: string[]) => void): string[] => {
    const known = new Map(w.names);
    const lines: string[] = [];
    fill(lines);
    for (const n of [...w.names.keys()]) if (!known.has(n)) w.names.delete(n);
    return lines;
  };
  const write = (lines: string[], values: readonly [string, Node][] = written): void => {
    const texts = values.map(([array, n]): [string, string] => [array, w.value(n, lines)]);
    for (const [array, text] of texts) lines.push(`${array}[i] = ${text};`);
  };
  const leave = (where: Node | null, lines: string[]): void => {
    if (where) lines.push(`if (${w.test(where, lines)}) marked[left++] = i + ${mark(ASK)};`);
  };
  const settle = (): string[] =>
    block((lines) => {
      w.branching(() => {
        lines.push(`const verdict = ${w.value(special.verdict, lines)};`);
        const margin = `margin[i] = verdict === ${NONE} ? -1 : 1;`;
        const roots = (): string[] =>
          Object.keys(outputs).map(
            (array) =>
              `${array}[i] = ${array === 't0' ? w.value(special.t, lines) : 'Number.NaN'};`,
          );
        if (classes) lines.push(`if (!roots) ${margin}`, 'else {', ...roots(), '}');
        else lines.push(...('margin' in outputs ? [margin] : roots()));
        lines.push(`if (verdict !== ${NONE}) marked[left++] = i + verdict * 2 ** ${CLASS_BIT};`);
      });
    });
  const ifRare = (lines: string[]): void => {
    const test = w.test(rare, lines);
    lines.push(`if (${test}) {`, ...settle(), '}');
  };
  /** What the roots are made of is handed on from one loop to the next. */
  const after: string[] = [];
  const handed = (roots: readonly Node[]) => {
    const found = new Set<Node>();
    const walk = (n: Node): void => {
      if (w.names.has(n)) {
        if (!n.uniform) found.add(n);
      } else n.args.forEach(walk);
    };
    roots.forEach(walk);
    const [hand, take]: [string[], string[]] = [[], []];
    for (const n of found) {
      const name = w.names.get(n) as string;
      if (n.op === 'input') {
        take.push(`const ${name} = ${n.name}[i] as number;`);
        continue;
      }
      hand.push(`W[${places.handed * BLOCK} + j] = ${name};`);
      take.push(`const ${name} = W[${places.handed * BLOCK} + j] as number;`);
      places.handed += 1;
    }
    return { hand, take };
  };
  if (!classes && !missed) {
    write(body);
    ifRare(body);
  } else {
    ifRare(body);
    if (classes) {
      const told = block((lines) => {
        write(lines, [['margin', classes.margin]]);
        leave(classes.rare, lines);
      });
      body.push('else if (!roots) {', ...told, '}');
    }
    const hit = (lines: string[]): void => {
      write(lines);
      leave(rareRoots, lines);
    };
    const none = written.map(([array]) => `${array}[i] = Number.NaN;`);
    if (missed && inBlocks) {
      const { hand, take } = handed(written.map(([, n]) => n).concat(rareRoots ?? []));
      const listed = block((lines) => {
        const isHit = `1 - ${w.value(missed, lines)}`;
        lines.push(...hand, ...none, 'H[hits] = j;', `hits += ${isHit};`);
      });
      body.push('else {', ...listed, '}');
      after.push(...take, ...block(hit));
    } else {
      if (missed) body.push(`else if (${w.test(missed, body)}) {`, ...none, '}');
      body.push('else {', ...block(hit), '}');
    }
  }
  scratch.count = Math.max(scratch.count, places.count);
  scratch.handed = Math.max(scratch.handed, places.handed);
  return [
    `const ${name}: Loop = (n, { count, ${used.join(', ')} }, out, ` +
      `marked${classes ? ', roots' : ''}) => {`,
    `const { ${[...Object.keys(outputs), ...(classes ? ['margin'] : [])].join(', ')} } = out;`,
    ...before,
    'let left = 0;',
    ...(after.length > 0
      ? inBlocksOf(body, after)
      : ['for (let i = 0; i < count; i++) {', ...body, '}']),
    'return left;',
    '};',
  ].join('\n');
}

/** Rays in a block. */
export const BLOCK = 64;

/** Whether a line hits is as often true as not: so the hits of a block are listed first. */
const inBlocksOf = (classes: readonly string[], roots: readonly string[]): string[] => [
  `for (let from = 0; from < count; from += ${BLOCK}) {`,
  `const end = Math.min(${BLOCK}, count - from);`,
  'let hits = 0;',
  'for (let j = 0; j < end; j++) {',
  'const i = from + j;',
  ...classes,
  '}',
  'for (let k = 0; k < hits; k++) {',
  'const j = H[k] as number;',
  'const i = from + j;',
  ...roots,
  '}',
  '}',
];

const mark = (verdict: number): string => `${verdict} * 2 ** ${CLASS_BIT}`;

/** An input, or a number of the shape, as it comes into the format. */
export const roundedTo =
  ({ width }: Format) =>
  (text: string): string =>
    width === 32 ? `fround(${text})` : text;

/** Ex as ex, dx as x: what is read from the arrays Ex and dx. */
export const local = (input: string): string =>
  input.startsWith('E') ? `e${input[1]}` : `${input[1]}`;
