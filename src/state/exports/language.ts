import {
  type CodeSyntax,
  type Expr,
  type ExprTriple,
  type Names,
  printCode,
} from '../../math/formula.ts';
import type { Verdict } from '../../math/index.ts';
import type { Program, Statement, Test } from './program.ts';

/** How a language writes the statements of a program. */
export interface Language {
  readonly syntax: CodeSyntax;
  comment(text: string): string;
  /** Assigns a scalar. */
  put(name: string, value: string): string;
  vector(parts: readonly string[]): string;
  putVector(name: string, value: string): string;
  test(test: Test): string;
  /** An if statement with these lines as its body. */
  when(test: string, then: readonly string[]): readonly string[];
  answer(verdict: Verdict, ts: readonly string[]): string;
  readonly indent: string;
}

/** An if statement of a language with braces, without them around a single line. */
export function inBraces(test: string, then: readonly string[], indent: string): string[] {
  if (then.length === 1) return [`if (${test}) ${then[0]}`];
  return [`if (${test}) {`, ...then.map((line) => indent + line), '}'];
}

/** The program's statements, indented by one step. */
export function body(program: Program, language: Language, names: Names): string[] {
  const lines = program.statements.flatMap((s) => statement(s, program, language, names));
  return lines.map((line) => language.indent + line);
}

/** A vector whose components are formulas. */
export function vectorCode(exprs: ExprTriple, language: Language, names: Names): string {
  return language.vector(exprs.map((expr) => printCode(expr, language.syntax, names)));
}

function statement(
  s: Statement,
  program: Program,
  language: Language,
  names: Names,
): readonly string[] {
  switch (s.do) {
    case 'put':
      return [language.put(s.name, code(s.expr, s.branch ?? 1, program, language, names))];
    case 'point':
      return [language.putVector(s.name, vectorCode(s.exprs, language, names))];
    case 'remark':
      return [language.comment(s.text)];
    case 'answer':
      return [language.answer(s.class, s.ts)];
    case 'when': {
      const then = s.then.flatMap((inner) => statement(inner, program, language, names));
      return language.when(language.test(s.test), then);
    }
  }
}

function code(
  expr: Expr,
  branch: 1 | -1,
  { known }: Program,
  { syntax }: Language,
  names: Names,
): string {
  // A statement that defines a name writes the subtree out instead of using the name.
  const named = known.has(expr) ? new Map() : known;
  return printCode(expr, syntax, names, { branch, known: named });
}
