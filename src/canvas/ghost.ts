import type { SceneModel } from '../state/scene-model.ts';
import { type Caption, seen } from './figures.ts';
import { CLEAR, type Mark } from './marks.ts';
import type { Projection, ScreenPoint } from './projection.ts';
import { pointAt } from './ray.ts';
import type { StageUnits } from './stage-units.ts';
import { type Dash, type Stroke, straight } from './stroke.ts';

const LINE = { ink: 'ink3', width: 1.5, alpha: 0.85, dash: [6, 5] as Dash } as const;
const BELOW = Math.PI / 2;

/** The strokes of the ghost, painted behind the ray. */
export function ghostStrokes({ ghost }: SceneModel, units: StageUnits): Stroke[] {
  const from = ghost && pointAt(ghost, ghost.from, units);
  const to = ghost && pointAt(ghost, ghost.to, units);
  return from && to ? [straight(from, to, LINE)] : [];
}

/** The marks of the ghost's E and hits, and its word. */
export function ghostFigures(
  { ghost }: SceneModel,
  units: StageUnits,
  projection: Projection,
  scale: number,
): { marks: Mark[]; captions: Caption[] } {
  if (!ghost) return { marks: [], captions: [] };
  const E = seen(ghost.origin, units, projection);
  const spots = [E, ...ghost.hits.map((hit) => seen(hit, units, projection))];
  const marks = spots.flatMap((spot: ScreenPoint | null, k): Mark[] =>
    spot ? [{ key: `ghost ${k}`, kind: 'ghost', symbols: [], spot }] : [],
  );
  const start = pointAt(ghost, ghost.from, units);
  const named =
    (ghost.beside && seen(ghost.beside, units, projection)) ??
    E ??
    (start && projection.project(start));
  if (!named) return { marks, captions: [] };
  const caption: Caption = {
    ...{ key: 'ghost', symbol: '', letter: ghost.title, sub: '', tone: 'ghost' },
    ...{ x: named.x, y: named.y, clear: (CLEAR.ghost + 2) * scale, angle: BELOW },
  };
  return { marks, captions: [caption] };
}
