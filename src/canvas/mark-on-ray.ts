import type { SceneModel } from '../state/scene-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { placeIn } from '../ui/zoom.ts';
import type { Caption } from './figures.ts';
import { isInside } from './off-screen-pointer.ts';
import type { Projection, ScreenPoint } from './projection.ts';
import { pointAt } from './ray.ts';
import type { StageUnits } from './stage-units.ts';

/** How near a click has to be to the ray, in px: a finger covers more. */
const NEAR = { mouse: 14, touch: 24 };
/** Places on the drawn ray that are looked at first; then as often between the best two. */
const [PLACES, ROUNDS] = [64, 4];
/** From the ray to the bracket beside it, in px at scale 1. */
const BESIDE = 16;
/** A click has not moved farther than this, in px; a drag has. */
const STILL = 4;

type Placed = (t: number) => ScreenPoint | null;

const placedOn =
  (model: SceneModel, units: StageUnits, projection: Projection): Placed =>
  (t) => {
    const place = pointAt(model.ray, t, units);
    return place && projection.project(place);
  };

/**
 * The t whose point is seen nearest to a place of the frame, as short as one pixel allows; null
 * where the drawn ray passes it by.
 */
export function markedAt(
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  { x, y }: { readonly x: number; readonly y: number },
  pointer: string,
): number | null {
  const { segments } = model.ray;
  let [from, to] = [segments[0]?.from ?? 0, segments.at(-1)?.to ?? 0];
  const placed = placedOn(model, units, projection);
  const away = (t: number): number => {
    const spot = placed(t);
    return spot ? Math.hypot(spot.x - x, spot.y - y) : Number.POSITIVE_INFINITY;
  };
  let best = from;
  for (let round = 0; round < ROUNDS; round++) {
    const step = (to - from) / PLACES;
    for (let i = 0; i <= PLACES; i++) {
      const t = from + i * step;
      if (away(t) < away(best)) best = t;
    }
    [from, to] = [Math.max(best - step, from), Math.min(best + step, to)];
  }
  if (away(best) > NEAR[pointer === 'mouse' ? 'mouse' : 'touch']) return null;
  const spot = placed(best);
  const next = placed(best + (to - from));
  const pixels = spot && next ? Math.hypot(next.x - spot.x, next.y - spot.y) : 0;
  const unit = 10 ** Math.floor(Math.log10((to - from) / Math.max(pixels, 1e-3)));
  return Number((Math.round(best / unit) * unit).toPrecision(12)) + 0;
}

/** A click beside the ray puts the mark there, while it can be put: `put` says where it was. */
export function listenToClicks(
  element: HTMLElement,
  put: (at: { readonly x: number; readonly y: number }, pointer: string) => void,
): () => void {
  const controller = new AbortController();
  const { signal } = controller;
  let from: { readonly x: number; readonly y: number } | null = null;
  const down = ({ target, isPrimary, button, clientX, clientY }: PointerEvent) => {
    const isFree = !(target instanceof Element && target.closest('button, a, [data-handle]'));
    from = isFree && isPrimary && button === 0 ? { x: clientX, y: clientY } : null;
  };
  const up = (event: PointerEvent) => {
    const { clientX, clientY, pointerType } = event;
    if (from && Math.hypot(clientX - from.x, clientY - from.y) <= STILL) {
      put(placeIn(element, event), pointerType);
    }
    from = null;
  };
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', () => (from = null), { signal });
  return () => controller.abort();
}

/** The words beside the mark, and the bracket from it to the hit with the gap in numbers. */
export function markFigures(
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  scale: number,
): { readonly path: string; readonly captions: readonly Caption[] } {
  const { mark, bead } = model;
  const captions: Caption[] = [];
  const say = (
    key: string,
    letter: string,
    { x, y }: Pick<ScreenPoint, 'x' | 'y'>,
    angle: number,
  ) =>
    captions.push({
      ...{ key, symbol: '', letter, sub: '', tone: 'words' },
      ...{ x, y, clear: 12 * scale, angle },
    });
  const placed = placedOn(model, units, projection);
  const at = mark && bead ? placed(bead.t) : null;
  if (!mark || !at) return { path: '', captions };
  const [from, to] = mark.gap ? [placed(mark.gap.from), placed(mark.gap.to)] : [null, null];
  const length = from && to ? Math.hypot(to.x - from.x, to.y - from.y) : 0;
  if (isInside(at, projection)) say('mark', mark.title, at, -Math.PI / 2);
  if (!mark.gap || !from || !to || length < 1) return { path: '', captions };
  // At a right angle to the ray, upwards on the screen.
  const turn = to.x >= from.x ? 1 : -1;
  const [nx, ny] = [(turn * (to.y - from.y)) / length, (-turn * (to.x - from.x)) / length];
  const beside = (spot: ScreenPoint, by: number) =>
    `${coordinate(spot.x + by * scale * nx)} ${coordinate(spot.y + by * scale * ny)}`;
  const path =
    `M${beside(from, BESIDE - 5)}L${beside(from, BESIDE + 5)}` +
    `M${beside(from, BESIDE)}L${beside(to, BESIDE)}` +
    `M${beside(to, BESIDE - 5)}L${beside(to, BESIDE + 5)}`;
  const middle = {
    x: (from.x + to.x) / 2 + BESIDE * scale * nx,
    y: (from.y + to.y) / 2 + BESIDE * scale * ny,
  };
  if (isInside({ ...middle }, projection)) say('gap', mark.gap.text, middle, Math.atan2(ny, nx));
  return { path, captions };
}
