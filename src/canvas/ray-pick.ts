import type { TreeLine } from '../state/picture/tree-scene.ts';
import { placeIn } from '../ui/zoom.ts';
import type { Projection } from './projection.ts';
import { along, type Point, type StageUnits } from './stage-units.ts';

/** px from a ray in which a press is meant for it, by pointer type. */
const REACH = { mouse: 9, pen: 12, touch: 20 } as const;
/** px that a press may move and be no drag. */
const STILL = 5;

interface PickTools {
  /** The rays as they are drawn. */
  drawn(): {
    readonly lines: readonly TreeLine[];
    readonly units: StageUnits;
    readonly projection: Projection;
  } | null;
  hover(path: string | null): void;
  /** Null for a press beside all rays. */
  pick(path: string | null): void;
}

/** Rays are picked by a press, and lit under the pointer. */
export function listenToPicks(root: HTMLElement, tools: PickTools, signal: AbortSignal): void {
  let from: { readonly x: number; readonly y: number } | null = null;
  const under = (event: PointerEvent): string | null => {
    const drawn = tools.drawn();
    if (!drawn) return null;
    const { x, y } = placeIn(root, event);
    const reach = REACH[event.pointerType as keyof typeof REACH] ?? REACH.mouse;
    return nearestLine(drawn.lines, drawn.units, drawn.projection, { x, y }, reach);
  };
  const isHandle = ({ target }: Event): boolean =>
    target instanceof Element && target.closest('[data-handle]') !== null;
  root.addEventListener(
    'pointerdown',
    (event) => {
      from =
        event.isPrimary && event.button === 0 && !isHandle(event) ? placeIn(root, event) : null;
    },
    { signal },
  );
  root.addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerType === 'mouse' && event.buttons === 0) tools.hover(under(event));
    },
    { signal },
  );
  root.addEventListener('pointerleave', () => tools.hover(null), { signal });
  root.addEventListener(
    'pointerup',
    (event) => {
      const to = placeIn(root, event);
      const isPress = from !== null && Math.hypot(to.x - from.x, to.y - from.y) < STILL;
      from = null;
      if (isPress) tools.pick(under(event));
    },
    { signal },
  );
}

/** The path of the ray that is nearest on the screen; of equally near ones the last. */
export function nearestLine(
  lines: readonly TreeLine[],
  units: StageUnits,
  projection: Projection,
  { x, y }: { readonly x: number; readonly y: number },
  reach: number,
): string | null {
  let best: { readonly path: string; readonly far: number } | null = null;
  for (const { path, from, to } of lines) {
    const [a, b] = [units.toStage(from), units.toStage(to)];
    const ends = a && b && inFront(a, b, projection);
    if (!ends) continue;
    const far = distanceTo(ends, x, y);
    if (far <= reach && (!best || far <= best.far)) best = { path, far };
  }
  return best?.path ?? null;
}

type Ends = readonly [{ readonly x: number; readonly y: number }, { x: number; y: number }];

/** The ends on the screen, of the part in front of the near plane; null for none. */
function inFront(a: Point, b: Point, projection: Projection): Ends | null {
  // A little more than the near plane, so that rounding keeps it in front.
  const least = projection.near * (1 + 1e-9);
  const [da, db] = [projection.distance(a), projection.distance(b)];
  if (da < least && db < least) return null;
  const way = along(b, a, -1);
  const at = along(a, way, (least - da) / (db - da));
  const p = projection.project(da < least ? at : a);
  const q = projection.project(db < least ? at : b);
  return p && q ? [p, q] : null;
}

function distanceTo([p, q]: Ends, x: number, y: number): number {
  const [wx, wy] = [q.x - p.x, q.y - p.y];
  const length = wx * wx + wy * wy;
  const s = length === 0 ? 0 : ((x - p.x) * wx + (y - p.y) * wy) / length;
  const t = Math.min(Math.max(s, 0), 1);
  return Math.hypot(x - p.x - t * wx, y - p.y - t * wy);
}
