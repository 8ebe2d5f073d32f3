import { transform } from 'sucrase';

type Stripped =
  | { readonly ok: true; readonly text: string }
  | { readonly ok: false; readonly message: string; readonly line: number | null };

/**
 * A program in TypeScript without its types, line by line where it was. `import type` goes away;
 * enums and parameter properties become what they mean.
 */
export function stripTypes(source: string): Stripped {
  try {
    const { code } = transform(source, {
      transforms: ['typescript'],
      disableESTransforms: true,
      keepUnusedImports: false,
    });
    return { ok: true, text: code };
  } catch (error) {
    const words = error instanceof Error ? error.message : String(error);
    const [, line] = /\((\d+):\d+\)/.exec(words) ?? [];
    const message = words.replace(/^Error transforming [^:]*: /, '').replace(/ \(\d+:\d+\)$/, '');
    return {
      ok: false,
      message: `syntax error: ${message}`,
      line: line === undefined ? null : Number(line),
    };
  }
}
