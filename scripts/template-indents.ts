import type { Plugin } from 'vite';
import { parseSync } from 'vite';

interface AnyNode {
  readonly type: string;
  readonly [key: string]: unknown;
}

const isNode = (value: unknown): value is AnyNode =>
  typeof value === 'object' && value !== null && 'type' in value;

const within = (node: AnyNode): AnyNode[] => [
  node,
  ...Object.values(node).flat().filter(isNode).flatMap(within),
];

const TAGS = new Set(['html', 'svg', 'mathml']);

/** The texts of lit's templates, as places in the source. */
function textsOf(path: string, source: string): readonly (readonly [start: number, end: number])[] {
  const { program } = parseSync(path, source);
  return within(program as unknown as AnyNode)
    .filter(({ type, tag }) => {
      const { name } = (tag ?? {}) as { name?: string };
      return type === 'TaggedTemplateExpression' && name !== undefined && TAGS.has(name);
    })
    .flatMap(({ quasi }) => (quasi as unknown as { quasis: AnyNode[] }).quasis)
    .map(({ start, end }) => [Number(start), Number(end)] as const);
}

/** The source with templates whose lines are not indented: the page shows any space as one. */
export function withoutIndents(path: string, source: string): string {
  const texts = [...textsOf(path, source)].sort(([a], [b]) => b - a);
  return texts.reduce(
    (code, [start, end]) =>
      code.slice(0, start) + code.slice(start, end).replace(/\n\s+/g, '\n') + code.slice(end),
    source,
  );
}

/** Indents in lit's templates are about 300 of the bytes that the first frame waits for. */
export const templateIndents: Plugin = {
  name: 'template-indents',
  apply: 'build',
  enforce: 'pre',
  transform: (source, id) =>
    /\/src\/.*\.ts$/.test(id) && /\b(?:html|svg|mathml)`/.test(source)
      ? { code: withoutIndents(id, source), map: null }
      : null,
};
