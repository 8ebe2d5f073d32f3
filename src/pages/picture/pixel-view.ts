import { html, type TemplateResult } from 'lit';
import type { TreeModel } from '../../canvas/ray-tree.ts';
import { LATEX, MATHML } from '../../math/formula.ts';
import { pixelPanel } from '../../panels/picture-pixel.ts';
import { playBar } from '../../panels/picture-play.ts';
import { latexDisplay } from '../../state/exports/latex.ts';
import { mathmlTable } from '../../state/exports/mathml.ts';
import { cameraLines, type PixelRay } from '../../state/picture/camera-lines.ts';
import { sideWords } from '../../state/picture/comparison.ts';
import { type TreeRow, treeRows } from '../../state/picture/tree-rows.ts';
import { type TreeScene, treeScene } from '../../state/picture/tree-scene.ts';
import type { RayNode, RayTree } from '../../tracer/types.ts';
import { copyText } from '../../ui/clipboard.ts';
import type { PictureModel } from './picture-model.ts';
import { createRayPlay } from './ray-play.ts';
import type { RayRecorder } from './ray-recorder.ts';
import type { TraceRequest } from './trace-request.ts';

interface PixelView {
  /** The list of rays of the pixel that is chosen, or how to choose one. */
  panel(model: PictureModel): TemplateResult;
  /** The same rays for the view in space; null while there are none. */
  space(model: PictureModel): TreeModel | null;
  /** The bar that plays the rays; null while there are none. */
  bar(): TemplateResult | null;
  /** Chooses the ray with this path, or none; shows it in the list if several share a row. */
  pick(path: string | null): void;
  /** Goes to the next or the previous ray of the list. */
  go(by: 1 | -1): void;
  play(): void;
  /** While something is dragged the view in space keeps its stage. */
  hold(isHeld: boolean): void;
  /** Path of a ray that the list has to show. */
  wanted(): string | null;
  /** Another page is shown. */
  rest(): void;
}

interface PixelActions {
  readonly changed: () => void;
  readonly announce: (words: string) => void;
  readonly close: () => void;
}

/** Number of ray trees that are cached, the most recent pixels. */
const MOST_TREES = 24;
/** One for each side of a comparison. */
const MOST_ASKED = 2;

const HINT = html`<p class="pixel-problem">Click a pixel to follow its rays.</p>`;

type Known = { readonly tree: RayTree } | { readonly problem: string } | 'asked';

export function createPixelView(recorder: RayRecorder, actions: PixelActions): PixelView {
  const trees = new Map<string, Known>();
  /** Cache of the scenes, so that the view in space is not rebuilt while nothing changes. */
  const inSpace = new WeakMap<RayNode, TreeScene>();
  let stage: TreeScene['stage'] | null = null;
  let held = false;
  let current: RayNode | null = null;
  let sample: number | null = null;
  let chosen: string | null = null;
  let opened: ReadonlySet<string> = new Set();
  let shown = '';
  /** The shown rows. Play leaves out rows of opened groups, whose rays have own rows. */
  let rows: readonly TreeRow[] = [];
  let wanted: string | null = null;
  const play = createRayPlay(() => {
    wanted = play.at();
    if (wanted !== null && !play.runs()) tell(wanted);
    actions.changed();
  });
  const rowAt = (path: string | null): TreeRow | undefined => rows.find((row) => row.path === path);
  const wordsOf = ({ words, verdict, rest }: TreeRow): string => `${words}; ${verdict}${rest}`;
  function tell(path: string): void {
    const row = rowAt(path);
    if (row) actions.announce(wordsOf(row));
  }

  const keyOf = (request: TraceRequest, [x, y]: readonly [number, number]) =>
    `${x},${y} ${request.key}`;

  /** Requests that are under way: while things move the newest is asked for, not all of them. */
  let asked = 0;
  const treeOf = (request: TraceRequest, [x, y]: readonly [number, number]): Known => {
    const key = keyOf(request, [x, y]);
    return trees.get(key) ?? (asked < MOST_ASKED ? ask(request, [x, y]) : 'asked');
  };

  /** The model that was shown last for this pixel, which stays until the new rays arrive. */
  let lastSettled: { readonly pixel: string; readonly model: PictureModel } | null = null;
  const settled = (model: PictureModel): PictureModel => {
    const { pixel } = model.picture;
    if (!pixel) return model;
    const known = treeOf(model.requests.main, pixel);
    if (known === 'asked' && lastSettled?.pixel === pixel.join()) return lastSettled.model;
    lastSettled = known === 'asked' ? null : { pixel: pixel.join(), model };
    return model;
  };

  const ask = (request: TraceRequest, [x, y]: readonly [number, number]): Known => {
    const key = keyOf(request, [x, y]);
    trees.set(key, 'asked');
    asked += 1;
    const [oldest] = trees.keys();
    if (trees.size > MOST_TREES && oldest !== undefined) trees.delete(oldest);
    recorder.record(request, x, y).then(
      (tree) => {
        asked -= 1;
        trees.set(key, { tree });
        actions.changed();
      },
      (error: Error) => {
        asked -= 1;
        trees.set(key, { problem: error.message });
        actions.changed();
      },
    );
    return 'asked';
  };

  const rowsOf = (
    known: Known | null,
    model: PictureModel,
    { settings }: TraceRequest,
  ): readonly TreeRow[] | null => {
    if (known === null || known === 'asked' || 'problem' in known) return null;
    const root = known.tree.rays[sampleOf(known.tree)];
    return root ? treeRows(model.picture.scene, root, opened, settings) : null;
  };

  /** Index of the sample: the chosen one, else the middle one, which comparisons use. */
  const sampleOf = ({ rays }: RayTree): number =>
    sample !== null && sample < rays.length ? sample : rays.length >> 1;

  const raysOf = (
    { picture }: PictureModel,
    pixel: readonly [number, number],
    tree: RayTree,
  ): PixelRay => ({
    camera: picture.scene.camera,
    width: picture.width,
    height: picture.height,
    pixel,
    sample: sampleOf(tree),
    samples: tree.rays.length,
  });

  const copyRay = async (ray: PixelRay, as: 'latex' | 'mathml'): Promise<void> => {
    const [x, y] = ray.pixel;
    const text =
      as === 'latex'
        ? latexDisplay(`From pixel ${x}, ${y} to its ray`, cameraLines(ray, LATEX))
        : mathmlTable(cameraLines(ray, MATHML));
    const copied = await copyText(text);
    actions.announce(copied ? 'copied: the ray of the pixel' : 'it could not be copied');
  };

  const start = (pixel: readonly [number, number]): void => {
    if (shown === pixel.join()) return;
    shown = pixel.join();
    sample = null;
    chosen = null;
    opened = new Set();
    play.end();
  };

  const hold = (next: readonly TreeRow[]): void => {
    rows = next;
    play.setRows(next.filter(({ group, path }) => !(group && opened.has(path))));
  };

  const pick = (path: string | null): void => {
    const group = path === null ? null : rows.find(({ rays }) => rays.includes(path));
    if (group?.group) opened = new Set([...opened, group.path]);
    chosen = path;
    wanted = path;
    if (path !== null && play.at() !== null) play.seek(path);
    if (path !== null) tell(path);
    actions.changed();
  };

  const tools = {
    sample(index: number): void {
      play.end();
      sample = index;
      chosen = null;
      actions.changed();
    },
    choose(path: string): void {
      chosen = chosen === path ? null : path;
      if (play.at() !== null) play.seek(path);
      actions.changed();
    },
    toggle(path: string): void {
      const next = new Set(opened);
      if (!next.delete(path)) next.add(path);
      opened = next;
      actions.changed();
    },
    close: actions.close,
  };

  return {
    panel(now) {
      const model = settled(now);
      const { pixel, against } = model.picture;
      if (!pixel) {
        shown = '';
        hold([]);
        return HINT;
      }
      const isNew = shown !== pixel.join();
      start(pixel);
      const { main, other } = model.requests;
      const known = treeOf(main, pixel);
      if (known === 'asked' || 'problem' in known) hold([]);
      if (known === 'asked')
        return html`<p class="pixel-problem"
          data-say>following the rays of pixel ${pixel.join(', ')}…</p>`;
      if ('problem' in known)
        return html`<p class="pixel-problem">pixel ${pixel.join(', ')}: ${known.problem} <button
          type="button" class="button" @click=${() => ask(main, pixel)}>Try again</button></p>`;
      hold(rowsOf(known, model, main) ?? []);
      const first = rows[0];
      if (isNew && first)
        actions.announce(
          `pixel ${pixel.join(', ')}: ${first.verdict}${first.rest}, ${rows.length} rays`,
        );
      const left = other ? rowsOf(treeOf(other, pixel), model, other) : null;
      return pixelPanel(
        {
          of: raysOf(model, pixel, known.tree),
          rows,
          left,
          leftWords: other ? sideWords(other.settings, against) : '',
          rightWords: sideWords(main.settings, against),
          method: main.settings.method,
          leftMethod: other?.settings.method ?? main.settings.method,
          chosen,
          opened,
          played: play.at(),
        },
        { ...tools, copy: (as) => void copyRay(raysOf(model, pixel, known.tree), as) },
      );
    },
    space(now) {
      const { picture, requests } = settled(now);
      if (!picture.pixel) return null;
      const known = treeOf(requests.main, picture.pixel);
      if (known === 'asked' || 'problem' in known) return null;
      const root = known.tree.rays[sampleOf(known.tree)];
      if (!root) return null;
      const scene = inSpace.get(root) ?? treeScene(picture.scene, root, held ? stage : null);
      inSpace.set(root, scene);
      stage = scene.stage;
      current = root;
      const at = rowAt(play.at());
      const before = at ? rows.slice(0, rows.indexOf(at) + 1) : rows;
      return {
        scene,
        chosen: new Set((at ?? rowAt(chosen))?.rays),
        shown: at ? new Set(before.flatMap(({ rays }) => rays)) : null,
        growMs: at && play.runs() ? play.pace() / 2 : 0,
        along: now.picture.along,
      };
    },
    bar() {
      if (rows.length === 0) return null;
      const row = rowAt(play.at() ?? chosen);
      const model = {
        at: row ? rows.indexOf(row) + 1 : null,
        count: rows.length,
        runs: play.runs(),
        words: row ? wordsOf(row) : '',
      };
      return playBar(model, { toggle: play.toggle, step: play.step });
    },
    pick,
    go(by) {
      if (play.at() !== null) return play.step(by);
      const all = rows.filter(({ group, path }) => !(group && opened.has(path)));
      const from = all.findIndex(({ path }) => path === chosen);
      const next = from < 0 ? (by === 1 ? 0 : all.length - 1) : from + by;
      pick(all[next]?.path ?? null);
    },
    play: play.toggle,
    hold(isHeld) {
      held = isHeld;
      if (!isHeld && current) inSpace.delete(current);
      actions.changed();
    },
    wanted() {
      const path = wanted;
      wanted = null;
      return path;
    },
    rest() {
      if (play.runs()) play.toggle();
    },
  };
}
