import { SHAPES, type Shape } from '../math/index.ts';
import { checkedShape, quote } from '../math/shapes.ts';
import { type AppState, INITIAL, PAGES, type Settings } from './state.ts';
import { readTexts, type TypedTexts } from './typed-texts.ts';
import { decode, encode, MAX_KEYS } from './url.ts';

/**
 * A saved state: its link, and the shapes and other pages' settings that the link does not carry.
 */
interface SavedState {
  readonly graze: 1;
  readonly link: string;
  readonly shapes: readonly Shape[];
  readonly settings: Readonly<Record<string, Settings>>;
  /** What was typed for the shapes' numbers. */
  readonly typed: TypedTexts;
}

export function toFile(state: AppState): string {
  const { shapes, settings, typed } = state;
  const link = encode(state);
  const saved: SavedState = { graze: 1, link, shapes: Object.values(shapes), settings, typed };
  // JSON has no minus zero: written as a number it would come back as 0.
  return `${JSON.stringify(saved, (_, x) => (Object.is(x, -0) ? '-0' : x), 2)}\n`;
}

type OpenedState =
  | { readonly ok: true; readonly state: AppState }
  | { readonly ok: false; readonly reason: string };

/** The state in a file of any origin. What cannot be read is left out and reported. */
export function fromFile(text: string): OpenedState {
  let data: unknown;
  try {
    data = JSON.parse(text, (_, x) => (x === '-0' ? -0 : x));
  } catch {
    return { ok: false, reason: `${quote(text.slice(0, 30))} is not a saved state` };
  }
  const { graze, link, shapes, settings, typed } = (data ?? {}) as Partial<SavedState>;
  if (graze !== 1 || typeof link !== 'string') {
    return { ok: false, reason: 'this file holds no state of Graze' };
  }
  const problems: string[] = [];
  const known = Array.isArray(shapes) ? readShapes(shapes, problems) : {};
  const all = { ...INITIAL.shapes, ...known };
  const base: AppState = {
    ...INITIAL,
    shapes: all,
    typed: readTexts(typed, all),
    settings: { ...INITIAL.settings, ...readSettings(settings) },
  };
  const state = decode(link, base);
  return { ok: true, state: { ...state, problems: [...problems, ...state.problems] } };
}

/** Settings by page. Each page checks its own when it is opened; here they only have to be text. */
function readSettings(given: unknown): Record<string, Settings> {
  const pages = (given ?? {}) as Readonly<Record<string, unknown>>;
  return Object.fromEntries(
    PAGES.map(({ id }) => {
      const pairs = Object.entries(pages[id] ?? {}).slice(0, MAX_KEYS);
      return [id, Object.fromEntries(pairs.filter(([, value]) => typeof value === 'string'))];
    }),
  );
}

function readShapes(shapes: readonly unknown[], problems: string[]): Record<string, Shape> {
  const found: Record<string, Shape> = {};
  for (const shape of shapes.slice(0, SHAPES.length)) {
    try {
      const own = checkedShape(shape as Shape);
      found[own.kind] = own;
    } catch (error) {
      problems.push(
        `opened without a shape: ${error instanceof Error ? error.message : 'unreadable'}`,
      );
    }
  }
  return found;
}
