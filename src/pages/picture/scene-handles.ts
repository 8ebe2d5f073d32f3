import { html, nothing, render, type TemplateResult } from 'lit';
import type { Vec3 } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import { nameIn } from '../../scene/names.ts';
import type { Scene } from '../../scene/types.ts';
import { arrowMove, arrowStep, projectedPoint } from '../../state/picture/drag.ts';
import type { PictureSettings } from '../../state/picture/settings.ts';
import { display } from '../../text/format.ts';
import { watchDrags } from '../../ui/drags.ts';
import { cameraFrameOf, type DraggedThing, dragTo } from './dragged-thing.ts';
import './scene-handles.css';

interface HandleTools {
  scene(edit: (now: Scene) => Scene): void;
  /** Opens the form of what is taken hold of. */
  edit(id: string): void;
  move(id: string, by: Vec3): void;
}

interface SceneHandles {
  /** `id`: the thing or light whose form is open. Null removes the handles. */
  render(picture: PictureSettings | null, id: string | null): void;
}

/** px from the picture's edge of a handle whose light is not in the picture. */
const EDGE = 20;

/**
 * Over the picture: a handle for each light, at the edge if it is not in the picture, and one for
 * the thing whose form is open. They are dragged, and moved by arrow keys.
 */
export function createSceneHandles(host: HTMLElement, tools: HandleTools): SceneHandles {
  let picture: PictureSettings | null = null;
  let held: DraggedThing | null = null;

  const frame = ({ scene, width, height }: PictureSettings) => cameraFrameOf(scene, width, height);
  const idOf = (target: EventTarget | null): string | null =>
    target instanceof Element
      ? (target.closest<HTMLElement>('[data-handle]')?.dataset.handle ?? null)
      : null;
  const inPicture = (at: { readonly x: number; readonly y: number }): readonly [number, number] => {
    const box = host.getBoundingClientRect();
    const { width, height } = picture ?? { width: 1, height: 1 };
    return [((at.x - box.left) / box.width) * width, ((at.y - box.top) / box.height) * height];
  };
  const drop = (isCancelled: boolean): void => {
    const taken = held;
    held = null;
    if (taken && isCancelled) tools.scene(() => taken.scene);
  };

  let pressed: string | null = null;
  watchDrags(host, {
    everyWay: true,
    takes(event) {
      pressed = idOf(event.target);
      return event.button === 0 && event.isPrimary && pressed !== null;
    },
    drags() {
      const at = picture && pressed !== null && placeOf(picture.scene, pressed);
      if (!picture || pressed === null || !at) return;
      tools.edit(pressed);
      held = { scene: picture.scene, id: pressed, at, from: [0, 0], frame: frame(picture) };
    },
    move(now, from) {
      if (!held || !picture) return;
      const [x, y] = inPicture(now);
      const pressed = inPicture(from);
      // A point in the picture follows the pointer; one outside moves by the pointer's distance.
      const spot = projectedPoint(held.frame, held.at);
      const start = isInside(spot, held.frame) ? ([spot.x, spot.y] as const) : pressed;
      const [dx, dy] = [x - pressed[0], y - pressed[1]];
      const edit = dragTo({ ...held, from: start }, start[0] + dx, start[1] + dy, picture.along);
      tools.scene(edit);
    },
    end: drop,
  });
  host.addEventListener('keydown', (event) => {
    const id = idOf(event.target);
    if (!picture || id === null || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === 'Escape' && held) {
      event.preventDefault();
      return drop(true);
    }
    const { scene, along } = picture;
    const by = arrowMove(frame(picture), event.key, arrowStep(scene, id, event.shiftKey), along);
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    tools.move(id, by);
  });

  const handle = (scene: Scene, id: string, at: Vec3): TemplateResult => {
    const { x, y, isAway } = shownAt(picture as PictureSettings, at, host);
    const name = nameIn(scene, id);
    const way = picture?.along === 'wall' ? 'a wall' : 'the floor';
    return html`<button type="button" class="scene-grip ${isAway ? 'away' : ''}"
      data-handle=${id} .style=${`left: ${x}%; top: ${y}%`} title=${name}
      aria-roledescription="handle" aria-label=${
        `${name} ${placeWords(scene, id)}; arrow keys, ` +
        `Page Up and Page Down move it, by arrows along ${way}`
      }
      @click=${() => tools.edit(id)}>${
        scene.lights.some((light) => light.id === id) ? LAMP : CROSS
      }</button>`;
  };

  return {
    render(next, id) {
      picture = next;
      if (!picture) {
        render(nothing, host);
        return;
      }
      const { scene } = picture;
      const ids = [
        ...scene.lights.map((light) => light.id),
        ...(scene.things.some((thing) => thing.id === id) && id !== null ? [id] : []),
      ];
      render(
        ids.map((one) => {
          const at = placeOf(scene, one);
          return at ? handle(scene, one, at) : nothing;
        }),
        host,
      );
    },
  };
}

const LAMP = html`<svg viewBox="0 0 24 24" width="22" height="22" aria-hidden="true"><circle
  cx="12" cy="12" r="4.500" /><path d="M12 2.500v3M12 18.500v3M2.500 12h3M18.500 12h3M5.300
    5.300l2.100 2.100M16.600 16.600l2.100 2.100M5.300 18.700l2.100-2.100M16.600 7.400l2.100-2.100"
  /></svg>`;
const CROSS = html`<svg viewBox="0 0 24 24" width="22" height="22" aria-hidden="true"><path
  d="M12 3v18M3 12h18M12 3l-2.500 2.500M12 3l2.500 2.500M12 21l-2.500-2.500M12 21l2.500-2.500M3
    12l2.500-2.500M3 12l2.500 2.500M21 12l-2.500-2.500M21 12l-2.500 2.500" /></svg>`;

/** The point of its handle: a lamp's place, a point in a sun's direction, a thing's anchor. */
function placeOf(scene: Scene, id: string): Vec3 | null {
  const light = scene.lights.find((one) => one.id === id);
  const thing = scene.things.find((one) => one.id === id);
  if (thing) return definitionOf(thing.shape).anchor(thing.shape).at;
  if (!light) return null;
  if (light.light !== 'sun') return light.at;
  const { target } = scene.camera;
  const at = (i: 0 | 1 | 2): number => target[i] + light.towards[i];
  return [at(0), at(1), at(2)];
}

const isInside = (
  { x, y, depth }: ReturnType<typeof projectedPoint>,
  { width, height }: DraggedThing['frame'],
): boolean => depth > 0 && x >= 0 && x <= width && y >= 0 && y <= height;

/** Where its handle is, in percent: at the edge in its direction where it is not in the picture. */
function shownAt({ scene, width, height }: PictureSettings, at: Vec3, host: HTMLElement) {
  const { x, y, depth } = projectedPoint(cameraFrameOf(scene, width, height), at);
  const [mx, my] = [EDGE / (host.clientWidth || 1), EDGE / (host.clientHeight || 1)];
  const [u, v] = [x / width - 0.5, y / height - 0.5];
  const beyond = Math.max(Math.abs(u) / (0.5 - mx), Math.abs(v) / (0.5 - my));
  const isAway = !(depth > 0) || beyond > 1;
  const shrink = isAway && beyond > 0 ? 1 / beyond : 1;
  return { x: 100 * (0.5 + u * shrink), y: 100 * (0.5 + v * shrink), isAway };
}

/** Where a light is, or goes. */
export function placeWords({ things, lights }: Scene, id: string): string {
  const light = lights.find((one) => one.id === id);
  const thing = things.find((one) => one.id === id);
  if (light?.light === 'sun') return `towards ${triple(light.towards)}`;
  const at = light?.at ?? (thing && definitionOf(thing.shape).anchor(thing.shape).at);
  return at ? `at ${triple(at)}` : '';
}

const triple = (v: Vec3): string => `(${v.map((x) => display(x)).join(', ')})`;
