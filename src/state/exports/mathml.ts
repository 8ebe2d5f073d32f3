import { MATHML, mathmlDocument, mathmlText } from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import type { ExportLine } from './line.ts';
import { derivationLines } from './lines.ts';

/** The derivation as one MathML table, for a web page or a word processor. */
export const mathml: Export = {
  id: 'mathml',
  title: 'the derivation as MathML',
  extension: 'mml',
  mime: 'application/mathml+xml',
  text: derivationMathml,
};

export function derivationMathml(model: ExploreModel): string {
  return mathmlTable(derivationLines(model, MATHML));
}

/** Lines as one table, aligned at their relations. */
export function mathmlTable(lines: readonly ExportLine<string>[]): string {
  const table = '<mtable columnalign="right center left left" displaystyle="true">';
  return `${mathmlDocument(`\n${table}\n${lines.map(row).join('\n')}\n</mtable>\n`)}\n`;
}

function row({ left, relation, right, words }: ExportLine<string>): string {
  const cells = [
    left ?? '',
    relation === null ? '' : MATHML.operator(relation),
    right ?? '',
    words && mathmlText(words),
  ];
  return `<mtr>${cells.map((cell) => `<mtd>${cell}</mtd>`).join('')}</mtr>`;
}
