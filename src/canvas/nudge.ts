import { roundStep } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import { withComponent } from '../math/shapes.ts';
import type { Handle } from '../state/handles.ts';
import type { Value } from '../state/snap.ts';
import { keyStep } from '../ui/step.ts';

const MOVES: Readonly<Record<string, readonly [axis: 0 | 1 | 2, sign: 1 | -1]>> = {
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
  ArrowUp: [1, 1],
  ArrowDown: [1, -1],
  PageUp: [2, 1],
  PageDown: [2, -1],
};

/** One step on in the direction of a key, with Shift a tenth of one; null for other keys. */
export function nudged(
  handle: Handle,
  event: KeyboardEvent,
  stageRadius: number,
): ((now: Value) => Value) | null {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  const step = handle.step * (handle.isLength ? roundStep(stageRadius / 5) : 1);
  if (handle.type === 'reach') {
    const change = keyStep(event, step);
    return change === null ? null : (now) => plain((now as number) + change);
  }
  const move = MOVES[event.key];
  if (!move) return null;
  const [axis, sign] = move;
  const change = sign * (event.shiftKey ? step / 10 : step);
  return (now) => withComponent(now as Vec3, axis, plain((now as Vec3)[axis] + change));
}

/** x without rounding errors of the addition, as in 0.30000000000000004. */
function plain(x: number): number {
  return Number(x.toPrecision(15)) + 0;
}
