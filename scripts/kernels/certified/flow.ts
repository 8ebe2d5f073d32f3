import { handed, INPUTS, type Input } from '../../../src/math/methods/certified/simd.ts';
import { createScope, type Scope } from '../wasm/locals.ts';
import * as op from '../wasm/ops.ts';
import { type Code, codeOf, type Expr, namesIn, renamed } from './expression.ts';
import { type Numbers, numberOf } from './prologue.ts';
import { elementOf, type Loop } from './source.ts';

/*
 * The statements of one or several loops as one sequence for a pair of rays, cut into parts again
 * where that is best for the processor: a part is short enough that it has several pairs under way
 * while each waits for its roots and quotients. What a later part needs of an earlier one goes
 * through memory.
 */

const MAGNITUDE = 'magnitude';

export interface Step {
  readonly target: string;
  readonly formula: Expr;
}

export interface Flow {
  readonly steps: readonly Step[];
  /** The names of constants and the code of their values. */
  readonly constants: ReadonlyMap<string, Code>;
  /** What a name of loop k, or an array's element, is called in the steps. */
  readonly name: (name: string, k?: number) => string;
}

/**
 * Each loop's names get its number; what only renames another value is left out; a constant that
 * two loops share is one.
 */
export function flowOf(loops: readonly Loop[], numbers: readonly Numbers[]): Flow {
  const constants = new Map<string, Code>();
  const called = new Map<string, string>();
  const steps: Step[] = [];
  const name = (plain: string, k = 0): string =>
    called.get(`${plain}_${k}`) ?? called.get(plain) ?? plain;
  loops.forEach(({ constants: own, statements }, k) => {
    for (const { name: plain, array, key } of own) {
      const { id, code } = numberOf(array, key, numbers[k] as Numbers);
      constants.set(id, code);
      called.set(`${plain}_${k}`, id);
    }
    for (const { target, writes, formula } of statements) {
      const found = renamed(formula, (old) => name(old, k));
      const own = writes ? elementOf(target) : `${target}_${k}`;
      if (found.op === 'value') called.set(own, found.name);
      else {
        called.set(own, own);
        steps.push({ target: own, formula: found });
      }
    }
  });
  return { steps, constants, name };
}

/** Which input an element of a loop, by elementOf's name for it, is of. */
export const inputOf = (element: string): Input | undefined =>
  INPUTS.find((one) => elementOf(one) === element);

/** How a part is put into a function. */
export interface Parts {
  /** What part p computes, from loading what it needs to storing what later parts need. */
  readonly code: (p: number) => Code;
  /** A value's code within part p, which must have been asked for by `wanted`. */
  readonly value: (name: string, p: number) => Code;
  /** A step that is in no part, computed within part p. */
  readonly extra: (step: Step, p: number) => Code;
  /** The first place for values handed on that is free. */
  readonly free: number;
}

/**
 * `cuts` are the targets after which a part ends; `wanted[p]` what is asked of part p besides;
 * `input` loads an array's element, in any part or (`again` false) in the first one only.
 */
export function partsOf(
  { steps, constants }: Flow,
  cuts: readonly string[],
  wanted: readonly (readonly string[])[],
  { hand, input, again }: { hand: Code; input: (element: string) => Code | null; again: boolean },
  outer: Scope,
): Parts {
  const ends = [
    ...cuts.map((cut) => 1 + steps.findIndex(({ target }) => target === cut)),
    steps.length,
  ];
  if (ends.includes(0)) throw new ReferenceError(`no ${cuts[ends.indexOf(0)]} to cut after`);
  const partOf = new Map<string, number>();
  const parts = ends.map((end, p) => steps.slice(p === 0 ? 0 : ends[p - 1], end));
  parts.forEach((part, p) => {
    for (const { target } of part) partOf.set(target, p);
  });
  const isInput = (name: string): boolean => !partOf.has(name) && input(name) !== null;
  const needs = parts.map((part, p) => [
    ...new Set([...part.flatMap(({ formula }) => namesIn(formula)), ...(wanted[p] ?? [])]),
  ]);
  // Inputs that are not read again are read by the first part, and handed on like its values.
  for (const name of again ? [] : needs.flat()) {
    if (!isInput(name)) continue;
    partOf.set(name, 0);
    if (!needs[0]?.includes(name)) needs[0]?.push(name);
  }
  const slots = new Map<string, number>();
  needs.forEach((names, p) => {
    for (const name of names) {
      if ((partOf.get(name) ?? p) < p && !slots.has(name)) slots.set(name, slots.size);
    }
  });
  const slot = (name: string): number => handed(slots.get(name) as number);
  const scopes = parts.map(() => outer.inner());
  const valueIn = (p: number) => (name: string) => (scopes[p] ?? outer).value(name);
  const abs = (a: Code): Code => op.and(a, outer.value(MAGNITUDE));
  return {
    free: slots.size,
    value: (name, p) => valueIn(p)(name),
    extra: ({ target, formula }, p) =>
      op.set((scopes[p] ?? outer).declare(target), codeOf(formula, valueIn(p), abs)),
    code(p) {
      const scope = scopes[p] ?? outer;
      const computed = new Set((parts[p] ?? []).map(({ target }) => target));
      const loads = (needs[p] ?? [])
        .filter((name) => !computed.has(name) && !constants.has(name))
        .flatMap((name) => {
          const from = partOf.get(name);
          const read = from !== undefined && from < p ? op.load(hand, slot(name)) : input(name);
          if (!read) throw new ReferenceError(`${name} is read but never written`);
          return op.set(scope.declare(name), read);
        });
      const compute = (parts[p] ?? []).flatMap(({ target, formula }) => {
        const code = codeOf(formula, valueIn(p), abs);
        return op.set(scope.declare(target), code);
      });
      const stores = [...slots.keys()]
        .filter((name) => partOf.get(name) === p)
        .flatMap((name) => op.store(hand, slot(name), scope.value(name)));
      return [...loads, ...compute, ...stores];
    },
  };
}

/** A scope with the constants of a flow, and the code that sets them. */
export function scopeOf({ constants }: Flow, first: number): { scope: Scope; prologue: Code } {
  const scope = createScope(first);
  const all = [...constants, [MAGNITUDE, op.MAGNITUDE] as const];
  const prologue = all.flatMap(([name, code]) => op.set(scope.declare(name), code));
  return { scope, prologue };
}
