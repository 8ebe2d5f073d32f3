/* Numbers and tables as languages and spreadsheets write them. */

const NOTHING = /^(?:|none|null|nil|na|n\/a|[-–—])$/i;
const NOT_A_NUMBER = /^[-+]?(?:nan(?:\(\w*\))?|1\.#(?:ind|qnan)\d*)$/i;
const INFINITE = /^([-+]?)(?:inf(?:inity)?|1\.#inf\d*|∞)$/i;
const NUMBER = /^[-+−]?(?:\d+\.?\d*|\.\d+)(?:[ed][-+−]?\d+)?$/i;

/**
 * The number in a cell; null for words that mean none; undefined for other text. A comma is read as
 * a decimal point.
 */
export function numberIn(cell: string): number | null | undefined {
  const text = cell.trim();
  if (NOTHING.test(text)) return null;
  if (NOT_A_NUMBER.test(text)) return Number.NaN;
  const infinite = INFINITE.exec(text);
  if (infinite) return infinite[1] === '-' ? Number.NEGATIVE_INFINITY : Number.POSITIVE_INFINITY;
  const plain = text.replace(',', '.').replaceAll('−', '-').replace(/d/i, 'e');
  return NUMBER.test(plain) ? Number(plain) : undefined;
}

export interface CsvLine {
  /** Line number in the text, from 1. */
  readonly number: number;
  readonly cells: readonly string[];
}

/**
 * Splits a table into lines and cells. `separator` is a character, or ' ' for any white space; a
 * quoted cell may contain it.
 */
export function linesOf(text: string, separator: string): CsvLine[] {
  const lines: CsvLine[] = [];
  let cells: string[] = [];
  let cell = '';
  let quoted = false;
  let number = 1;
  let begun = 1;
  const endCell = (): void => {
    cells.push(cell.trim());
    cell = '';
  };
  const endLine = (): void => {
    endCell();
    const kept = separator === ' ' ? cells.filter((one) => one !== '') : cells;
    if (kept.some((one) => one !== '')) lines.push({ number: begun, cells: kept });
    cells = [];
    begun = number + 1;
  };
  for (let i = 0; i < text.length; i++) {
    const c = text[i] as string;
    if (quoted && c === '"' && text[i + 1] === '"') {
      cell += c;
      i++;
    } else if (c === '"' && (quoted || cell.trim() === '')) quoted = !quoted;
    else if (quoted) cell += c;
    else if (c === separator || (separator === ' ' && c === '\t')) endCell();
    else if (c === '\n') endLine();
    else cell += c;
    if (c === '\n') number++;
  }
  endLine();
  return lines;
}
