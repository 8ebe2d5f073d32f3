/* Numbers and tables as languages and spreadsheets write them. */

const NOTHING = /^(?:|none|null|nil|na|n\/a|[-–—])$/i;
const NOT_A_NUMBER = /^[-+]?(?:nan(?:\(\w*\))?|1\.#(?:ind|qnan)\d*)$/i;
const INFINITE = /^([-+]?)(?:inf(?:inity)?|1\.#inf\d*|∞)$/i;
const NUMBER = /^[-+−]?(?:\d+\.?\d*|\.\d+)(?:[ed][-+−]?\d+)?$/i;

/**
 * A number; null for none; undefined for what is neither. A comma is read as a point: it cannot
 * separate within a cell.
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

export interface Line {
  /** Where it begins, from 1. */
  readonly number: number;
  readonly cells: readonly string[];
}

/**
 * Lines of cells between separators (a character, or ' ' for any white space); a cell in quotes may
 * hold anything.
 */
export function linesOf(text: string, separator: string): Line[] {
  const lines: Line[] = [];
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
