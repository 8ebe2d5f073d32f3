import { LATEX, latexText } from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import type { Line } from './line.ts';
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
  const rows = derivationLines(model, LATEX).map(row);
  return [
    `% Ray and ${model.title}, by ${model.found.method}: \\usepackage{amsmath}`,
    '\\[',
    '\\begin{aligned}',
    rows.map((text) => `  ${text}`).join(' \\\\\n'),
    '\\end{aligned}',
    '\\]\n',
  ].join('\n');
}

/** A line of the `align` environment, aligned at its relation. */
function row({ left, relation, right, words }: Line<string>): string {
  const sign = relation === null ? '' : LATEX.operator(relation).trimStart();
  const said = words && latexText(words);
  return [left ?? '', ' &', sign, [right, said].filter(Boolean).join(' \\quad ')].join('').trim();
}
