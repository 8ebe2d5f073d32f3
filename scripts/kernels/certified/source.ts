import { type ESTree, parseSync } from 'vite';
import type { Expr } from './expression.ts';

/*
 * What a loop over rays computes, read from its syntax tree (by Vite's parser). Only what the
 * stages of certified need is understood; anything else is refused, with file and line.
 *
 *   const { x: xs } = scratch;              an array that a stage hands on, by its field's name
 *   const name = array[AT.key] as number;   a constant of all rays, before the loop
 *   const name = expression;                a value of this ray
 *   array[i] as number                      read from an array
 *   array[i] = expression;                  written to an array
 *   if (verdict) { … } else { … }           both sides are computed; the kernel chooses by the name
 */

export interface Statement {
  /** The value's name, or the array's that is written to. */
  readonly target: string;
  readonly writes: boolean;
  readonly formula: Expr;
  /** `file:line`, for messages. */
  readonly at: string;
}

/** A number that is the same for all rays: `const name = array[key] as number;` before the loop. */
export interface Constant {
  readonly name: string;
  readonly array: string;
  readonly key: string;
}

export interface Loop {
  readonly constants: readonly Constant[];
  readonly statements: readonly Statement[];
}

/** A text and what it is called in messages. */
export interface Source {
  readonly file: string;
  readonly text: string;
}

type Node = ESTree.Node;

/** The name of an array's element in a formula. */
export const elementOf = (array: string): string => `${array}__`;

/** The counts that passes hand on are the kernel's own. */
const COUNTS = 'count';

/**
 * The loop of an exported function, and the constants before it. Of `hasY ? a : b` is taken what
 * `hasY` says. `verdicts` are the names that an `if` may ask. Throws SyntaxError with file and line
 * for what it does not understand.
 */
export function loopOf(
  source: Source,
  name: string,
  hasY: boolean,
  verdicts: readonly string[] = VERDICTS,
): Loop {
  const reader = readerOf(source, hasY, verdicts);
  const { program } = reader;
  for (const statement of program.body) {
    const body = statement.type === 'ExportNamedDeclaration' && functionNamed(statement, name);
    if (body) return reader.loop(body);
  }
  throw new SyntaxError(`${source.file}: no exported function ${name}`);
}

/** What the certified stages decide by. */
const VERDICTS = ['clear', 'missed', 'beside', 'remote', 'settled'] as const;

/** An expression alone, as loops have it. */
export function expressionOf(text: string): Expr {
  const reader = readerOf({ file: 'formula', text: `(${text}\n);` }, true, []);
  const [only, more] = reader.program.body;
  if (only?.type !== 'ExpressionStatement' || more) throw new SyntaxError(`formula: ${text}`);
  return reader.expression(only.expression);
}

function functionNamed(declared: ESTree.ExportNamedDeclaration, name: string): Node | null {
  const { declaration } = declared;
  if (declaration?.type === 'FunctionDeclaration') {
    return declaration.id?.name === name ? declaration.body : null;
  }
  if (declaration?.type !== 'VariableDeclaration') return null;
  const [only] = declaration.declarations;
  if (only?.id.type !== 'Identifier' || only.id.name !== name) return null;
  return only.init?.type === 'ArrowFunctionExpression' ? only.init.body : null;
}

interface Reader {
  readonly program: ESTree.Program;
  readonly loop: (body: Node) => Loop;
  readonly expression: (node: Node) => Expr;
}

function readerOf({ file, text }: Source, hasY: boolean, verdicts: readonly string[]): Reader {
  const place = (offset: number): string => `${file}:${text.slice(0, offset).split('\n').length}`;
  const parsed = parseSync(file.endsWith('.ts') ? file : `${file}.ts`, text);
  const [error] = parsed.errors;
  if (error) throw new SyntaxError(`${place(error.labels[0]?.start ?? 0)}: ${error.message}`);
  /** The field that a local stands for. */
  const fields = new Map<string, string>();

  function refuse(node: Node, why = 'is not understood'): never {
    const [line] = text.slice(node.start, node.end).split('\n');
    throw new SyntaxError(`${place(node.start)}: ${line} ${why}`);
  }

  const nameOf = (node: Node): string =>
    node.type === 'Identifier' ? node.name : refuse(node, 'is no name');
  const arrayNamed = (node: Node): string => fields.get(nameOf(node)) ?? nameOf(node);

  function expression(node: Node): Expr {
    switch (node.type) {
      case 'ParenthesizedExpression':
        return expression(node.expression);
      case 'Identifier':
        return { op: 'value', name: node.name };
      case 'Literal':
        return typeof node.value === 'number'
          ? { op: 'number', value: node.value }
          : refuse(node, 'is no number');
      case 'UnaryExpression':
        return node.operator === '-' ? { op: 'neg', of: expression(node.argument) } : refuse(node);
      case 'BinaryExpression':
        return two(node, node.operator, node.left, node.right);
      case 'LogicalExpression':
        return two(node, node.operator, node.left, node.right);
      case 'CallExpression':
        return call(node);
      case 'ConditionalExpression':
        if (node.test.type !== 'Identifier' || node.test.name !== 'hasY') return refuse(node);
        return expression(hasY ? node.consequent : node.alternate);
      case 'TSAsExpression':
        return { op: 'value', name: elementOf(elementArray(node)) };
      default:
        return refuse(node);
    }
  }

  /** The array of `array[i] as number`. */
  function elementArray(node: ESTree.TSAsExpression): string {
    const { expression: inner, typeAnnotation } = node;
    const plain = typeAnnotation.type === 'TSNumberKeyword' && inner.type === 'MemberExpression';
    if (!plain || !inner.computed || inner.property.type !== 'Identifier') return refuse(node);
    return arrayNamed(inner.object);
  }

  function two(node: Node, operator: string, left: Node, right: Node): Expr {
    const op = OPERATORS.find((one) => one === operator);
    return op ? { op, a: expression(left), b: expression(right) } : refuse(node);
  }

  function call(node: ESTree.CallExpression): Expr {
    const { callee, arguments: given } = node;
    const [a, b] = given;
    if (callee.type !== 'MemberExpression' || callee.computed) return refuse(node);
    if (callee.object.type !== 'Identifier' || callee.object.name !== 'Math') return refuse(node);
    const { name } = callee.property as ESTree.IdentifierName;
    if ((name === 'abs' || name === 'sqrt') && a && given.length === 1)
      return { op: name, of: expression(a) };
    if ((name === 'min' || name === 'max') && a && b && given.length === 2)
      return { op: name, a: expression(a), b: expression(b) };
    return refuse(node);
  }

  /** What stands before the loop, around it (a closure over arrays) and after it. */
  function loop(body: Node): Loop {
    const constants: Constant[] = [];
    const statements: Statement[] = [];
    let found = false;
    for (const node of block(body)) {
      if (node.type === 'ForStatement') {
        if (found) refuse(node, 'is a second loop');
        found = true;
        inLoop(node.body, statements);
      } else if (node.type === 'VariableDeclaration') {
        if (!found) for (const one of node.declarations) before(node, one, constants);
        else refuse(node);
      } else if (node.type === 'ReturnStatement' && !found) {
        if (node.argument?.type !== 'ArrowFunctionExpression') return refuse(node);
        return loop(node.argument.body);
      } else if (!found || !isAfter(node)) refuse(node);
    }
    if (!found) refuse(body, 'has no loop');
    return { constants, statements };
  }

  /** `count[HITS] = hits;` and `return left;` */
  function isAfter(node: Node): boolean {
    if (node.type === 'ReturnStatement') return node.argument?.type === 'Identifier';
    if (node.type !== 'ExpressionStatement') return false;
    const { expression: set } = node;
    if (set.type !== 'AssignmentExpression' || set.left.type !== 'MemberExpression') return false;
    return set.left.object.type === 'Identifier' && set.left.object.name === COUNTS;
  }

  function before(node: Node, one: ESTree.VariableDeclarator, constants: Constant[]): void {
    const { id, init } = one;
    if (id.type === 'ObjectPattern') {
      for (const property of id.properties) {
        if (property.type !== 'Property' || property.computed) refuse(property);
        else fields.set(nameOf(property.value), nameOf(property.key));
      }
      return;
    }
    if (init?.type === 'Literal' && init.value === 0 && nameOf(id)) return;
    if (init?.type !== 'TSAsExpression' || init.expression.type !== 'MemberExpression')
      refuse(node);
    const { object, property } = init.expression;
    const array = nameOf(object);
    if (array === COUNTS) return;
    if (property.type === 'MemberExpression' && !property.computed) {
      constants.push({ name: nameOf(id), array, key: nameOf(property.property as Node) });
    } else refuse(node);
  }

  const block = (node: Node): readonly Node[] =>
    node.type === 'BlockStatement' ? node.body : [node];

  function inLoop(body: Node, statements: Statement[]): void {
    for (const node of block(body)) {
      if (node.type === 'VariableDeclaration') {
        if (node.kind !== 'const') refuse(node);
        for (const { id, init } of node.declarations) {
          if (!init) refuse(node);
          else if (!isIndex(id, init)) add(statements, node, nameOf(id), false, init);
        }
      } else if (node.type === 'IfStatement') {
        const { test } = node;
        const asked =
          test.type === 'UnaryExpression' && test.operator === '!' ? test.argument : test;
        if (asked.type !== 'Identifier' || !verdicts.includes(asked.name))
          refuse(test, `is none of the verdicts ${verdicts.join(', ')}`);
        inLoop(node.consequent, statements);
        if (node.alternate) inLoop(node.alternate, statements);
      } else if (node.type === 'ExpressionStatement') assigned(node.expression, statements);
      else if (node.type !== 'ContinueStatement') refuse(node);
    }
  }

  /** `const i = places[j] as number`: the ray's own place. */
  const isIndex = (id: Node, init: Node): boolean =>
    id.type === 'Identifier' && id.name === 'i' && init.type === 'TSAsExpression';

  function assigned(node: Node, statements: Statement[]): void {
    if (node.type !== 'AssignmentExpression') refuse(node);
    const { left, right, operator } = node;
    const moved = operator === '+=' && left.type === 'Identifier';
    if (moved && right.type === 'Literal' && right.value === 1) return;
    if (operator !== '=' || left.type !== 'MemberExpression' || !left.computed) refuse(node);
    const array = arrayNamed(left.object);
    if (right.type === 'Identifier' && right.name === 'i') return;
    if (left.property.type !== 'Identifier') refuse(node);
    if (text.slice(right.start, right.end) !== 'Number.NaN')
      add(statements, node, array, true, right);
  }

  function add(to: Statement[], node: Node, target: string, writes: boolean, right: Node): void {
    to.push({ target, writes, formula: expression(right), at: place(node.start) });
  }

  return { program: parsed.program, loop, expression };
}

const OPERATORS = ['+', '-', '*', '/', '<', '>', '<=', '>=', '&&'] as const;
