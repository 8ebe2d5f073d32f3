import { parseSync, transformWithOxc } from 'vite';
import { expect } from 'vitest';
import { ROOT } from './documents.ts';

type Names = Readonly<Record<string, unknown>>;

interface Statement {
  readonly type: string;
  readonly start: number;
  readonly end: number;
}

interface ImportStatement extends Statement {
  readonly source: { readonly value: string };
  readonly specifiers: readonly {
    readonly local: { readonly name: string };
    readonly imported: { readonly name: string };
  }[];
}

const AsyncFunction = (async () => undefined).constructor as new (
  ...parts: string[]
) => (...given: unknown[]) => Promise<void>;

/**
 * What stands behind a statement: `// → value` or `// throws InvalidInput: message`, on its line or
 * the next.
 */
const CLAIM = /^[ \t]*\n?[ \t]*\/\/ (→|throws) (.*)/;

/**
 * Runs an example in TypeScript and compares each statement with the claim behind it. It may import
 * from the repository's root and use the names that are given. Fails if it claims nothing.
 */
export async function runExample(code: string, names: Names = {}): Promise<void> {
  const { program, errors } = parseSync('example.ts', code);
  if (errors.length > 0) throw new SyntaxError(`${errors[0]?.message} in\n${code}`);
  const known: Record<string, unknown> = { ...names };
  const lines: string[] = [];
  let claims = 0;
  for (const statement of program.body as unknown as readonly Statement[]) {
    if (statement.type === 'ImportDeclaration') {
      Object.assign(known, await imported(statement as ImportStatement));
      continue;
    }
    const text = code.slice(statement.start, statement.end);
    const [, kind, claim = ''] = CLAIM.exec(code.slice(statement.end)) ?? [];
    if (kind) claims += 1;
    if (kind === 'throws') lines.push(`$throws(() => { ${text} }, ${JSON.stringify(claim)});`);
    else if (kind) lines.push(compared(statement.type, text, claim));
    else lines.push(text);
  }
  expect(claims, `claims of\n${code}`).toBeGreaterThan(0);
  const given = { ...known, $equal, $throws };
  // In a block, so that an example may give a name of the module to a value of its own.
  const { code: script } = await transformWithOxc(`{\n${lines.join('\n')}\n}`, 'example.ts');
  await new AsyncFunction(...Object.keys(given), script)(...Object.values(given));
}

function compared(type: string, text: string, claim: string): string {
  if (type === 'ExpressionStatement') {
    return `$equal(${text.replace(/;$/, '')}, (${claim}), ${JSON.stringify(text)});`;
  }
  const [, name] = /^const (\w+) =/.exec(text) ?? [];
  if (!name) throw new SyntaxError(`a claim behind what is no value: ${text}`);
  return `${text}\n$equal(${name}, (${claim}), ${JSON.stringify(text)});`;
}

async function imported({ source, specifiers }: ImportStatement): Promise<Names> {
  const module: Names = await import(/* @vite-ignore */ new URL(source.value, ROOT).pathname);
  return Object.fromEntries(
    specifiers.map(({ local, imported: { name } }) => {
      if (!(name in module)) throw new SyntaxError(`${source.value} has no ${name}`);
      return [local.name, module[name]];
    }),
  );
}

function $equal(value: unknown, wanted: unknown, text: string): void {
  expect(value, text).toEqual(wanted);
}

function $throws(run: () => void, wanted: string): void {
  let said = 'nothing is thrown';
  try {
    run();
  } catch (error) {
    said = String(error);
  }
  expect(said).toBe(wanted);
}
