import type { Vec3 } from '../math/index.ts';
import {
  arrowMove,
  type CameraFrame,
  type DragPlane,
  dragged,
  projectedPoint,
} from '../state/picture/drag.ts';
import type { TreeLight, TreeScene } from '../state/picture/tree-scene.ts';
import { watchDrags } from '../ui/drags.ts';
import { placeIn } from '../ui/zoom.ts';
import { Layer, type Part } from './layer.ts';
import type { Projection } from './projection.ts';
import { along, type StageUnits } from './stage-units.ts';
import type { Theme } from './theme.ts';

export interface LightTools {
  /** A light is taken hold of; until it is dropped the view stays where it is. */
  hold(): void;
  /** It is so far from where it was taken. */
  drag(id: string, by: Vec3): void;
  drop(isCancelled: boolean): void;
  /** A key moves it by a step, along these ways. */
  press(id: string, way: (step: number) => Vec3, isFine: boolean): void;
}

const LAMP: readonly Part[] = [
  ['circle', { class: 'tree-light-room', r: 18 }],
  ['circle', { class: 'tree-light-mark', r: 6 }],
  ['path', { class: 'tree-light-rays', d: 'M0-12v3M0 9v3M-12 0h3M9 0h3' }],
];

/** Handles of the lights. */
export class TreeLights {
  readonly #layer: Layer;

  constructor(svg: Element) {
    this.#layer = new Layer(svg, 'tree-lights');
  }

  draw(
    lights: readonly TreeLight[],
    units: StageUnits,
    projection: Projection,
    { scale }: Pick<Theme, 'scale'>,
  ): void {
    this.#layer.begin();
    for (const { id, name, at } of lights) {
      const place = units.toStage(at);
      const spot = place && projection.project(place);
      if (!spot) continue;
      const attributes = {
        class: 'tree-light',
        'data-handle': id,
        tabindex: 0,
        role: 'button',
        'aria-roledescription': 'handle',
        'aria-label': `${name}: arrow keys, Page Up and Page Down move it`,
        transform: `translate(${spot.x.toFixed(2)} ${spot.y.toFixed(2)}) scale(${scale})`,
      };
      this.#layer.show(id, 'g', attributes, LAMP);
    }
    this.#layer.end();
  }
}

interface Drawn {
  readonly units: StageUnits;
  readonly projection: Projection;
  readonly model: { readonly scene: TreeScene; readonly along: DragPlane };
}

/** Lights are dragged, and moved by arrow keys. */
export function listenToLights(
  root: HTMLElement,
  drawn: () => Drawn | null,
  tools: LightTools,
  signal: AbortSignal,
): void {
  let held: {
    readonly light: TreeLight;
    readonly frame: CameraFrame;
    readonly along: DragPlane;
  } | null = null;
  let pressed: string | null = null;
  const idOf = ({ target }: Event): string | null =>
    target instanceof Element
      ? (target.closest('[data-handle]')?.getAttribute('data-handle') ?? null)
      : null;
  const find = (id: string | null): typeof held => {
    const now = drawn();
    const light = now?.model.scene.lights.find((one) => one.id === id);
    return now && light
      ? { light, frame: cameraFrameOf(now.units, now.projection), along: now.model.along }
      : null;
  };
  const drop = (isCancelled: boolean): void => {
    if (held) tools.drop(isCancelled);
    held = null;
  };
  const spotIn = ({ x, y }: { readonly x: number; readonly y: number }) =>
    placeIn(root, { clientX: x, clientY: y });

  watchDrags(
    root,
    {
      everyWay: true,
      takes(event) {
        pressed = idOf(event);
        return pressed !== null && event.button === 0 && event.isPrimary;
      },
      drags() {
        held = find(pressed);
        if (held) tools.hold();
      },
      move(now, from) {
        if (!held) return;
        const { light, frame } = held;
        const spot = projectedPoint(frame, light.at);
        const [start, to] = [spotIn(from), spotIn(now)];
        const end = [spot.x + to.x - start.x, spot.y + to.y - start.y] as const;
        const by = dragged(frame, light.at, [spot.x, spot.y], end, held.along);
        tools.drag(light.id, light.per === 1 ? by : short(times(by, light.per)));
      },
      end: drop,
    },
    signal,
  );
  root.addEventListener(
    'keydown',
    (event) => {
      const found = find(idOf(event));
      if (!found || event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.key === 'Escape') return drop(true);
      const { light, frame } = found;
      if (!arrowMove(frame, event.key, 1, found.along)) return;
      event.preventDefault();
      event.stopPropagation();
      const way = (step: number): Vec3 =>
        arrowMove(frame, event.key, step, found.along) ?? [0, 0, 0];
      tools.press(light.id, way, event.shiftKey);
    },
    { signal },
  );
}

/** The view's camera in the world. */
function cameraFrameOf({ stage }: StageUnits, projection: Projection): CameraFrame {
  const { width, height, focal, eye, forward, right, up } = projection;
  return {
    eye: along(stage.center, eye, stage.radius),
    ahead: forward,
    right: times(right, width / 2 / focal),
    up: times(up, height / 2 / focal),
    width,
    height,
  };
}

const times = (v: Vec3, s: number): Vec3 => [s * v[0] + 0, s * v[1] + 0, s * v[2] + 0];

/** Short, since a far light moves by many units a pixel. */
const short = (v: Vec3): Vec3 => {
  const put = (x: number): number => Number(x.toPrecision(3));
  return [put(v[0]), put(v[1]), put(v[2])];
};
