import { InvalidInput } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import type { ExploreModel } from '../state/derive.ts';
import { parseNumber } from '../text/parse.ts';
import { isQuantity, quantityOf, signOf } from './quantities.ts';

/** "D > 0", "class two", "t1 < 0": when a paragraph is shown. */
export type Condition =
  | { readonly type: 'class'; readonly name: string }
  | {
      readonly type: 'number';
      readonly quantity: string;
      readonly relation: keyof typeof RELATIONS;
      readonly than: number;
    };

const RELATIONS = {
  '=': (x: number, y: number) => x === y,
  '≠': (x: number, y: number) => x !== y,
  '<': (x: number, y: number) => x < y,
  '>': (x: number, y: number) => x > y,
  '≤': (x: number, y: number) => x <= y,
  '≥': (x: number, y: number) => x >= y,
} as const;

const CLASSES = ['two', 'tangent', 'one', 'none', 'contained'];
const ASCII: Readonly<Record<string, string>> = { '<=': '≤', '>=': '≥', '!=': '≠' };

/** Conditions with "and" between them. Throws InvalidInput with what is wrong with one. */
export function readConditions(text: string): Condition[] {
  return text.split(/\band\b/).map((one) => readCondition(one.trim()));
}

function readCondition(text: string): Condition {
  const [, name] = text.match(/^class (\w+)$/) ?? [];
  if (name !== undefined) {
    if (!CLASSES.includes(name)) throw new InvalidInput(`${quote(name)} is not a class`);
    return { type: 'class', name };
  }
  const [, quantity = '', sign = '', than = ''] =
    text.match(/^(\S+) (<=|>=|!=|[=≠<>≤≥]) (.+)$/) ?? [];
  const relation = (ASCII[sign] ?? sign) as keyof typeof RELATIONS;
  const parsed = parseNumber(than);
  if (!isQuantity(quantity) || !(relation in RELATIONS) || !parsed.ok) {
    throw new InvalidInput(`${quote(text)} is no condition such as "D > 0" or "class two"`);
  }
  return { type: 'number', quantity, relation, than: parsed.value };
}

/** Whether a condition holds; comparisons with 0 use the exact sign. */
function holdsNow(condition: Condition, model: ExploreModel): boolean {
  if (condition.type === 'class') return model.found.class === condition.name;
  const { quantity, relation, than } = condition;
  const sign = than === 0 ? signOf(model, quantity) : null;
  const value = sign ?? quantityOf(model, quantity);
  return typeof value === 'number' && RELATIONS[relation](value, than);
}

export const allHold = (conditions: readonly Condition[], model: ExploreModel): boolean =>
  conditions.every((condition) => holdsNow(condition, model));
