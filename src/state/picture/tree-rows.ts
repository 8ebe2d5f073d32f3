import type { Ray, Shape } from '../../math/index.ts';
import { isGlass } from '../../scene/facts.ts';
import { nameIn } from '../../scene/names.ts';
import { type Surface, surfacesOf } from '../../scene/surfaces.ts';
import type { Scene } from '../../scene/types.ts';
import { display } from '../../text/format.ts';
import type { RayKind, RayNode, StartRule, TraceSettings } from '../../tracer/types.ts';
import type { Between } from '../heights.ts';
import { leastCountedT, type RootFilter } from './root-fates.ts';
import { startText } from './start-rule.ts';
import { surfaceSteps } from './surface-steps.ts';

/** A row of the list of a pixel's rays. */
export interface TreeRow {
  /**
   * Indices of children from the root: '0', '0.2', '0.2.1'; equal for the same ray in two trees. A
   * row for several rays has a plus after that of the first.
   */
  readonly path: string;
  /** The paths of the rays that it stands for. */
  readonly rays: readonly string[];
  readonly depth: number;
  readonly kind: RayKind;
  readonly ray: Ray;
  readonly weight: number;
  /** What it is, and where it starts: 'shadow ray from ball to lamp'. */
  readonly words: string;
  /** Words on where the ray ended: first the verdict, then the rest. */
  readonly verdict: string;
  readonly rest: string;
  /** The shape of the surface where it ended; null if it ended nowhere. */
  readonly shape: Shape | null;
  /** The question to open in Explore: for a cap its whole thing, which has the same first hit. */
  readonly opens: ExploreTarget | null;
  readonly rootFilter: RootFilter;
  readonly t: number | null;
  readonly node: RayNode;
  /** If the row stands for several shadow rays to one light: how many, and how many are blocked. */
  readonly group: { readonly count: number; readonly blocked: number } | null;
}

interface ExploreTarget {
  readonly shape: Shape;
  readonly between: Between | null;
  readonly caps: boolean;
  readonly start: string;
}

/** The settings of a picture that decide which root counts. */
type Tracing = Pick<TraceSettings, 'method' | 'start' | 'forced'>;

/** From this many shadow rays to one light on, they share a row. */
const GROUP_FROM = 3;

/** The rows of a tree, each ray before those it fires. `open`: paths of groups shown ray by ray. */
export function treeRows(
  scene: Scene,
  root: RayNode,
  open: ReadonlySet<string>,
  how: Tracing,
): TreeRow[] {
  const surfaces = surfacesOf(scene);
  const walk = (node: RayNode, path: string, depth: number): TreeRow[] => {
    const own = rowOf(node, path, depth, scene, surfaces, how);
    return [own, ...children(node, path, depth + 1)];
  };
  const children = (node: RayNode, path: string, depth: number): TreeRow[] => {
    const rows: TreeRow[] = [];
    node.children.forEach((child, i) => {
      const mates = node.children.filter((other) => sameLight(child, other));
      const first = mates[0] === child;
      if (mates.length < GROUP_FROM) rows.push(...walk(child, `${path}.${i}`, depth));
      else if (first) rows.push(groupOf(node, mates, path, depth, rowTools));
      if (mates.length >= GROUP_FROM && open.has(groupPath(node, mates, path))) {
        rows.push(...walk(child, `${path}.${i}`, depth + 1));
      }
    });
    return rows;
  };
  const rowTools = (node: RayNode, path: string, depth: number): TreeRow =>
    rowOf(node, path, depth, scene, surfaces, how);
  return walk(root, '0', 0);
}

/** The path of a group's row. */
function groupPath(parent: RayNode, [first]: readonly RayNode[], path: string): string {
  return `${path}.${first ? parent.children.indexOf(first) : 0}+`;
}

function sameLight(a: RayNode, b: RayNode): boolean {
  return a.kind === 'shadow' && b.kind === 'shadow' && lightOf(a) === lightOf(b);
}

const lightOf = ({ end }: RayNode): string | null => ('light' in end ? end.light : null);

function groupOf(
  parent: RayNode,
  mates: readonly RayNode[],
  path: string,
  depth: number,
  rowOfNode: (node: RayNode, path: string, depth: number) => TreeRow,
): TreeRow {
  const [first] = mates as readonly [RayNode];
  const blocked = mates.filter(({ end }) => end.end === 'blocked').length;
  const words = `of ${mates.length} to ${lightOf(first) ?? 'a light'}`;
  const verdict = blocked === 0 ? 'all free' : `${blocked} blocked`;
  const row = rowOfNode(first, groupPath(parent, mates, path), depth);
  return {
    ...row,
    rays: mates.map((mate) => `${path}.${parent.children.indexOf(mate)}`),
    words: `${mates.length} ${row.words.replace('ray', 'rays')}`,
    verdict,
    rest: ` ${words}`,
    group: { count: mates.length, blocked },
  };
}

function rowOf(
  node: RayNode,
  path: string,
  depth: number,
  scene: Scene,
  surfaces: readonly Surface[],
  how: Tracing,
): TreeRow {
  const { kind, ray, weight, end } = node;
  // A ray that meets nothing is shown with the surface that it leaves.
  const asked = 'surface' in end ? end.surface : surfaces[node.from] ? node.from : 0;
  const surface = surfaces[asked];
  const filterOf = (index: number): RootFilter => ({
    ray,
    between: (how.forced.heights !== 'off' && surfaces[index]?.between) || null,
    leaves: how.start.rule === 'from' && node.from === index,
    least: leastCountedT(how.start, kind === 'camera'),
    most: end.end === 'light' ? end.t : Number.POSITIVE_INFINITY,
    passes: kind === 'shadow' && isClear(scene, surface),
  });
  const { verdict, rest } = verdictOf(node, scene, surfaces);
  // Before it hits a cap, the ray may have passed a root of the capped shape.
  const side = surfaces.findIndex(
    ({ thing, part }) => thing === surface?.thing && part === 'shape',
  );
  const shape = surfaces[side]?.shape;
  const passed = 'surface' in end && shape ? cutWords(shape, filterOf(side), end.t, how) : [];
  const of = side === asked ? '' : 'of its side ';
  return {
    ...{ path, rays: [path], depth, kind, ray, weight, node, verdict },
    words: wayWords(node, scene, surfaces),
    rootFilter: filterOf(asked),
    rest: rest + passed.map((words) => `; ${of}${words}`).join(''),
    shape: surface?.shape ?? null,
    opens: surface ? opensOf(node, surface, scene, surfaces, how) : null,
    t: 't' in end ? end.t : null,
    group: null,
  };
}

function opensOf(
  { kind, from }: RayNode,
  surface: Surface,
  { things }: Scene,
  surfaces: readonly Surface[],
  { start, forced }: Tracing,
): ExploreTarget {
  const between = (forced.heights !== 'off' && things[surface.thing]?.between) || null;
  const own = surfaces.filter(({ thing }) => thing === surface.thing);
  const caps = between !== null && own.some(({ part }) => part !== 'shape');
  const whole = caps ? own.find(({ part }) => part === 'shape') : surface;
  // A cap that stands alone, while its shape is not cut off, is a circle of its own.
  const leaves = caps ? own.includes(surfaces[from] as Surface) : surfaces[from] === surface;
  const rule: StartRule =
    kind === 'camera' || (start.rule === 'from' && !leaves) ? { rule: 'none' } : start;
  return {
    shape: (whole ?? surface).shape,
    between: surface.between || caps ? between : null,
    caps,
    start: startText(rule),
  };
}

function isClear({ things }: Scene, surface: Surface | undefined): boolean {
  const thing = surface && things[surface.thing];
  return thing !== undefined && isGlass(thing);
}

/** Words on roots of the shape before the hit, which the heights cut off. */
function cutWords(
  shape: Shape,
  meeting: RootFilter,
  hit: number,
  { method }: Tracing,
): readonly string[] {
  if (!meeting.between) return [];
  const { roots = [] } = surfaceSteps(shape, meeting, method) ?? {};
  return roots.filter(({ fate, t }) => fate === 'cut' && t < hit).map(({ words }) => words);
}

function verdictOf(
  { end, from }: RayNode,
  scene: Scene,
  surfaces: readonly Surface[],
): Pick<TreeRow, 'verdict' | 'rest'> {
  if (end.end === 'background') return { verdict: 'meets nothing', rest: ': the background' };
  const at = Number.isFinite(end.t) ? ` at t = ${display(end.t)}` : '';
  if (end.end === 'light')
    return { verdict: 'free', rest: `: reaches ${nameIn(scene, end.light)}` };
  const name = surfaceName(scene, surfaces[end.surface]);
  if (end.end === 'hit') return { verdict: name, rest: at };
  const own = end.surface === from ? 'the surface it starts on' : name;
  return { verdict: 'blocked', rest: ` by ${own},${at}` };
}

/** What kinds of rays are called. */
export const RAY_WORDS: Readonly<Record<RayKind, string>> = {
  camera: 'camera ray',
  shadow: 'shadow ray',
  reflected: 'reflected ray',
  refracted: 'refracted ray',
};

function wayWords(
  { kind, from, end }: RayNode,
  scene: Scene,
  surfaces: readonly Surface[],
): string {
  const start = surfaces[from] ? ` from ${surfaceName(scene, surfaces[from])}` : '';
  const light = 'light' in end ? ` to ${nameIn(scene, end.light)}` : '';
  return `${RAY_WORDS[kind]}${start}${light}`;
}

/** 'glass cone', 'glass cone, its lower cap' */
function surfaceName(scene: Scene, surface: Surface | undefined): string {
  const thing = surface && scene.things[surface.thing];
  if (!thing) return 'nothing';
  const name = nameIn(scene, thing.id);
  if (surface.part === 'shape') return name;
  return `${name}, its ${surface.part === 'low cap' ? 'lower' : 'upper'} end`;
}
