import { LATEX, latexText } from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import type { ExportLine } from './line.ts';
import { derivationLines } from './lines.ts';

/** The derivation as one display; needs amsmath and nothing else. */
export const latex: Export = {
  id: 'latex',
  title: 'the derivation as LaTeX',
  extension: 'tex',
  mime: 'application/x-tex',
  text: derivationLatex,
};

export function derivationLatex(model: ExploreModel): string {
  const what = `Ray and ${model.title}, by ${model.found.method}`;
  return latexDisplay(what, derivationLines(model, LATEX));
}

/** Lines as one display, aligned at their relations; `what` they are, in a comment above. */
export function latexDisplay(what: string, lines: readonly ExportLine<string>[]): string {
  return [
    `% ${what}: \\usepackage{amsmath}`,
    '\\[',
    '\\begin{aligned}',
    lines.map((line) => `  ${row(line)}`).join(' \\\\\n'),
    '\\end{aligned}',
    '\\]\n',
  ].join('\n');
}

/** A line of the `align` environment, aligned at its relation. */
function row({ left, relation, right, words }: ExportLine<string>): string {
  const sign = relation === null ? '' : LATEX.operator(relation).trimStart();
  const said = words && latexText(words);
  return [left ?? '', ' &', sign, [right, said].filter(Boolean).join(' \\quad ')].join('').trim();
}
