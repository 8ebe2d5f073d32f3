import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync } from 'vite';
import { describe, expect, test } from 'vitest';
import { SHAPES } from '../../src/math/index.ts';

/* Who may import whom (docs/ARCHITECTURE.md). Types count too. */

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');

const PURE = ['text', 'math', 'scene', 'tracer', 'lab', 'check'];
const VIEWS = ['canvas', 'panels', 'charts'];

/** Each room, and the rooms it may import from; its own always. A room need not exist yet. */
const ROOMS: Readonly<Record<string, readonly string[]>> = {
  text: [],
  math: ['text'],
  scene: ['math', 'text'],
  tracer: ['math', 'scene'],
  lab: ['math', 'text'],
  check: ['math', 'scene', 'lab', 'text'],
  // Of the tracer only types: see below.
  state: PURE,
  lesson: [...PURE, 'state'],
  workers: PURE,
  ui: ['text'],
  canvas: [...PURE, 'state', 'ui'],
  panels: [...PURE, 'state', 'ui'],
  charts: [...PURE, 'state', 'ui'],
  pages: [...PURE, ...VIEWS, 'state', 'lesson', 'ui', 'workers'],
  // ui for what belongs to the whole window and to no page: theme, gestures, files, the announcer,
  // the styles.
  main: ['pages', 'state', 'workers', 'ui'],
  // The element for other pages: parts of a page, without the page.
  embed: [...PURE, ...VIEWS, 'state', 'pages', 'ui'],
};

/** The doors of src/math: other rooms import nothing else of it. */
const DOORS = new Set(
  ['index', 'accelerate', 'batch', 'drawing', 'exact', 'families', 'formula', 'rng', 'shapes'].map(
    (name) => `src/math/${name}.ts`,
  ),
);

/** Packages, and the rooms that may know them. */
const PACKAGES: Readonly<Record<string, readonly string[]>> = {
  three: ['canvas'],
  lit: ['ui', 'panels', 'charts', 'pages', 'main'],
  'd3-scale': ['charts'],
  fflate: ['state'],
  marked: ['lesson'],
  sucrase: ['check'],
  uqr: ['pages'],
};

/** What the pure rooms and the state may not touch: a page, a clock, chance. */
const IMPURE = new Set([
  ...['document', 'navigator', 'localStorage', 'sessionStorage', 'customElements', 'matchMedia'],
  ...['HTMLElement', 'SVGElement', 'requestAnimationFrame', 'fetch', 'XMLHttpRequest', 'Worker'],
  ...['Date', 'performance', 'setTimeout', 'setInterval', 'queueMicrotask', 'Math.random'],
]);
/**
 * The math module is to stand on its own, so for it nothing of its surroundings may be named at
 * all.
 */
const OUTSIDE_MATH = new Set([
  ...[...IMPURE, 'window', 'self', 'globalThis', 'location', 'history', 'process', 'console'],
  ...['crypto', 'Intl', 'postMessage'],
]);

type Sources = Readonly<Record<string, string>>;

interface AnyNode {
  readonly type: string;
  readonly [key: string]: unknown;
}

const isNode = (value: unknown): value is AnyNode =>
  typeof value === 'object' && value !== null && 'type' in value && typeof value.type === 'string';

function childrenOf(node: AnyNode): AnyNode[] {
  return Object.values(node).flat().filter(isNode);
}

/**
 * The node and all below it, not into functions if `shallow`: those do not run when a module is
 * imported.
 */
function within(node: AnyNode, shallow = false, found: AnyNode[] = []): AnyNode[] {
  if (shallow && /Function|ClassBody/.test(node.type)) return found;
  found.push(node);
  for (const child of childrenOf(node)) within(child, shallow, found);
  return found;
}

/** Every rule asks for every node of every file: read them once. */
const known = new Map<string, readonly AnyNode[]>();
function nodesOf(path: string, source: string): readonly AnyNode[] {
  const found = known.get(source);
  if (found) return found;
  const { program, errors } = parseSync(path, source);
  if (errors.length > 0) throw new Error(`${path}: ${errors[0]?.message}`);
  const nodes = within(program as unknown as AnyNode);
  known.set(source, nodes);
  return nodes;
}

/** The statements of the file itself. */
const bodyOf = (path: string, source: string): AnyNode[] =>
  (nodesOf(path, source)[0]?.body ?? []) as AnyNode[];

interface Import {
  readonly from: string;
  readonly typesOnly: boolean;
}

const importsKnown = new Map<string, readonly Import[]>();
/**
 * Static and dynamic imports, re-exports, import types, and files named by `new URL(…,
 * import.meta.url)`.
 */
function importsOf(path: string, source: string): readonly Import[] {
  const known = importsKnown.get(source) ?? readImports(nodesOf(path, source));
  importsKnown.set(source, known);
  return known;
}

function readImports(nodes: readonly AnyNode[]): Import[] {
  return nodes.flatMap((node): Import[] => {
    const at = (value: unknown, typesOnly: boolean): Import[] =>
      isNode(value) && typeof value.value === 'string' ? [{ from: value.value, typesOnly }] : [];
    switch (node.type) {
      case 'ImportDeclaration':
        return at(node.source, node.importKind === 'type');
      case 'ExportNamedDeclaration':
      case 'ExportAllDeclaration':
        return at(node.source, node.exportKind === 'type');
      case 'ImportExpression':
        return at(node.source, false);
      case 'TSImportType':
        return at(node.source ?? node.argument, true);
      case 'NewExpression': {
        const callee = node.callee as AnyNode;
        const [first, second] = node.arguments as AnyNode[];
        const isUrl = callee.name === 'URL' && second?.type === 'MemberExpression';
        return isUrl ? at(first, false) : [];
      }
      default:
        return [];
    }
  });
}

/** What the page and the element begin with. */
const ENTRIES = new Set(['src/main.ts', 'src/embed.ts']);

/** src/canvas/scene.ts → canvas; src/main.ts → main. */
const roomOf = (path: string): string => {
  const [, room = '', rest] = path.split('/');
  return rest === undefined ? room.replace(/\.ts$/, '') : room;
};

const packageOf = (from: string): string =>
  from
    .split('/')
    .slice(0, from.startsWith('@') ? 2 : 1)
    .join('/');

function wrongImports(sources: Sources): string[] {
  return Object.entries(sources).flatMap(([path, source]) =>
    importsOf(path, source).flatMap(({ from, typesOnly }) => {
      const room = roomOf(path);
      const allowed = ROOMS[room];
      if (!allowed) return [`${path}: there is no room ${room}`];
      if (!from.startsWith('.')) {
        const ok = PACKAGES[packageOf(from)]?.includes(room);
        return ok ? [] : [`${path}: ${room} may not know ${from}`];
      }
      const target = posix.join(posix.dirname(path), from.replace(/\?.*$/, ''));
      const there = roomOf(target);
      if (room === 'state' && there === 'tracer' && !typesOnly) {
        return [`${path}: state may know only types of ${from}`];
      }
      const ok = target.startsWith('src/') && (there === room || allowed.includes(there));
      if (!ok) return [`${path}: ${room} may not import ${from}`];
      const byDoor = there !== 'math' || room === 'math' || DOORS.has(target);
      return byDoor ? [] : [`${path}: ${from} is no door of src/math`];
    }),
  );
}

/** Names that stand for themselves: not properties, not keys. `Math.random` is one name. */
function namesIn(nodes: readonly AnyNode[]): string[] {
  const notNames = new Set<unknown>();
  const names: string[] = [];
  for (const node of nodes) {
    if (node.type === 'MemberExpression' && !node.computed) {
      notNames.add(node.property);
      const { name } = node.object as AnyNode;
      const { name: property } = node.property as AnyNode;
      names.push(`${name}.${property}`);
    }
    if (/Property|MethodDefinition|TSPropertySignature/.test(node.type) && !node.computed) {
      if (node.key !== node.value && !node.shorthand) notNames.add(node.key);
    }
  }
  const plain = nodes.filter((node) => node.type === 'Identifier' && !notNames.has(node));
  return [...names, ...plain.map(({ name }) => String(name))];
}

function wrongNames(sources: Sources): string[] {
  return Object.entries(sources).flatMap(([path, source]) => {
    const room = roomOf(path);
    const forbidden =
      room === 'math' ? OUTSIDE_MATH : [...PURE, 'state'].includes(room) ? IMPURE : new Set();
    const found = namesIn(nodesOf(path, source)).filter((name) => forbidden.has(name));
    return [...new Set(found)].map((name) => `${path}: ${room} may not name ${name}`);
  });
}

const KINDS: ReadonlySet<unknown> = new Set(SHAPES.map(({ kind }) => kind));
const isKind = (node: unknown): boolean => isNode(node) && KINDS.has(node.value);
const isOp = (node: unknown): boolean =>
  isNode(node) && isNode(node.property) && node.property.name === 'op';

/**
 * A switch over shapes, or a comparison of a kind with one, anywhere but in the shapes' own files.
 */
function wrongSwitches(sources: Sources): string[] {
  return Object.entries(sources).flatMap(([path, source]) => {
    if (path.startsWith('src/math/shapes/')) return [];
    return nodesOf(path, source).flatMap((node) => {
      const { discriminant, cases, left, right } = node as { [key: string]: unknown };
      // A formula's operation may be called 'square' too.
      const asks = node.type === 'SwitchStatement' && !isOp(discriminant);
      const overKinds = asks && (cases as AnyNode[]).some((one) => isKind(one.test));
      const ofKind = (side: unknown): boolean =>
        isNode(side) &&
        (side.name === 'kind' || (isNode(side.property) && side.property.name === 'kind'));
      const compared =
        node.type === 'BinaryExpression' &&
        ((ofKind(left) && isKind(right)) || (ofKind(right) && isKind(left)));
      return overKinds || compared ? [`${path}: a case distinction over shapes`] : [];
    });
  });
}

const PAGE = new Set(['document', 'window', 'navigator', 'location', 'history', 'localStorage']);

const declaredBy = (node: AnyNode): unknown[] =>
  node.type === 'VariableDeclaration'
    ? (node.declarations as AnyNode[]).map(({ id }) => (id as AnyNode).name)
    : [];

/** `rays` for the statement `rays.count = 1;` */
function filledBy({ expression }: AnyNode): unknown {
  let target = isNode(expression) && expression.type === 'AssignmentExpression' && expression.left;
  while (isNode(target) && target.type === 'MemberExpression') target = target.object;
  return isNode(target) ? target.name : null;
}

/** What a module does when it is imported, other than declaring, and filling what it declared. */
function wrongActs(sources: Sources): string[] {
  return Object.entries(sources).flatMap(([path, source]) => {
    const mayAct = ENTRIES.has(path) || roomOf(path) === 'workers';
    if (mayAct) return [];
    const body = bodyOf(path, source);
    const own = new Set(body.flatMap(declaredBy));
    const acts = body.filter(
      (node) =>
        !/^(Import|Export|TS)|Declaration$/.test(node.type) &&
        !own.has(filledBy(node)) &&
        !namesIn(within(node)).includes('customElements.define'),
    );
    const touched = namesIn(body.flatMap((node) => within(node, true))).filter((n) => PAGE.has(n));
    return [
      ...acts.map(({ type }) => `${path}: acts at import (${type})`),
      ...touched.map((name) => `${path}: touches ${name} at import`),
    ];
  });
}

/** Every set of files that import each other, types included, each sorted and in one text. */
function circles(sources: Sources): string[] {
  const targets = new Map(
    Object.entries(sources).map(([path, source]) => [
      path,
      importsOf(path, source)
        .filter(({ from }) => from.startsWith('.'))
        .map(({ from }) => posix.join(posix.dirname(path), from.replace(/\?.*$/, '')))
        .filter((target) => target in sources),
    ]),
  );
  // A file that imports none of those that are left is in no circle.
  let left = 0;
  while (left !== targets.size) {
    left = targets.size;
    for (const [path, to] of targets) if (!to.some((one) => targets.has(one))) targets.delete(path);
  }
  const reached = new Map<string, Set<string>>();
  for (const start of targets.keys()) {
    const seen = new Set<string>();
    const open = [...(targets.get(start) ?? [])];
    for (let path = open.pop(); path !== undefined; path = open.pop()) {
      if (seen.has(path)) continue;
      seen.add(path);
      open.push(...(targets.get(path) ?? []));
    }
    reached.set(start, seen);
  }
  const found = [...targets.keys()].flatMap((path) => {
    const back = [...(reached.get(path) ?? [])].filter((other) => reached.get(other)?.has(path));
    return back.includes(path) ? [back.sort().join(' ↔ ')] : [];
  });
  return [...new Set(found)];
}

/** The names that a file exports. */
function exportsOf(path: string, source: string): string[] {
  return bodyOf(path, source).flatMap((node) => {
    if (node.type !== 'ExportNamedDeclaration') return [];
    const { declaration, specifiers } = node as { [key: string]: unknown };
    const listed = (specifiers as AnyNode[]).map(({ exported }) => textOf(exported));
    if (!isNode(declaration)) return listed;
    const { declarations, id } = declaration as { [key: string]: unknown };
    const made = (declarations as AnyNode[] | undefined)?.map((one) => one.id) ?? [id];
    return made.flatMap((one) => {
      const names = within(one as AnyNode).filter(({ type }) => type === 'Identifier');
      return isNode(one) && one.type === 'Identifier' ? [textOf(one)] : names.map(textOf);
    });
  });
}

const textOf = (node: unknown): string => {
  const { name, value } = node as { name?: string; value?: string };
  return name ?? value ?? '';
};

/**
 * What a file takes from others, as `path name`. Of a module that is imported as a whole, or late,
 * it takes what it names anywhere.
 */
function takenBy(path: string, source: string): string[] {
  const target = (from: string): string =>
    posix.join(posix.dirname(path), from.replace(/\?.*$/, ''));
  const all = [...new Set(nodesOf(path, source).map(textOf))];
  return nodesOf(path, source).flatMap((node) => {
    const { specifiers, source: from, argument } = node as { [key: string]: unknown };
    const at = textOf(from ?? argument ?? '');
    if (typeof at !== 'string' || !at.startsWith('.')) return [];
    const wholly = (): string[] => all.map((name) => `${target(at)} ${name}`);
    if (node.type === 'ImportExpression' || node.type === 'TSImportType') return wholly();
    if (node.type !== 'ImportDeclaration' && node.type !== 'ExportNamedDeclaration') return [];
    return (specifiers as AnyNode[]).flatMap(({ type, imported, local }) =>
      type === 'ImportNamespaceSpecifier'
        ? wholly()
        : [`${target(at)} ${textOf(imported ?? local)}`],
    );
  });
}

/** Exports that no other file imports. */
function unusedExports(sources: Sources, importers: Sources): string[] {
  const taken = new Set(Object.entries(importers).flatMap(([path, text]) => takenBy(path, text)));
  return Object.entries(sources).flatMap(([path, source]) =>
    exportsOf(path, source)
      .map((name) => `${path} ${name}`)
      .filter((one) => !taken.has(one)),
  );
}

/** Files that nothing leads to: from the entries, the doors of the math module and the workers. */
function unreached(sources: Sources): string[] {
  const starts = Object.keys(sources).filter(
    (path) => ENTRIES.has(path) || DOORS.has(path) || roomOf(path) === 'workers',
  );
  const reached = new Set(starts);
  for (const path of reached) {
    for (const { from } of importsOf(path, sources[path] ?? '')) {
      const target = posix.join(posix.dirname(path), from.replace(/\?.*$/, ''));
      if (target in sources) reached.add(target);
    }
  }
  return Object.keys(sources).filter((path) => !reached.has(path));
}

/** What a screen reader says by itself: a live region, an alert, an element that is one. */
const LIVE = [
  /\baria-?live\b/i,
  /html`[^`]*<output\b/,
  /\brole['"]?\s*[=:,]\s*['"]?(?:alert|status|log|timer|marquee)\b/,
];
const liveRegions = (sources: Sources): string[] =>
  Object.keys(sources).filter((path) => LIVE.some((live) => live.test(sources[path] ?? '')));

/** What a value may be written with so that nothing is made when its module is imported. */
const LITERAL = new Set([
  ...['Literal', 'TemplateLiteral', 'TemplateElement', 'Identifier', 'MemberExpression'],
  ...['UnaryExpression', 'BinaryExpression', 'ArrayExpression', 'ObjectExpression', 'Property'],
  ...['TSAsExpression', 'TSSatisfiesExpression', 'ParenthesizedExpression'],
]);
/** What a module may hold beside values. */
const DECLARED = /^(Import|Export|TS)\w*Declaration$|^VariableDeclaration$/;
/** Parts of these that are types only, or names that are given. */
const NOT_RUN = new Set(['typeAnnotation', 'typeArguments', 'specifiers', 'attributes', 'source']);

/**
 * What is below the node and no literal, as it is written: a call, `new`, a loop, a spread of a
 * list … Functions are not looked into. A call of `lazily` makes one, and is looked at as a list.
 */
function madeIn(node: AnyNode, source: string): string[] {
  const into = (parts: readonly AnyNode[]) => parts.flatMap((part) => madeIn(part, source));
  const below = () =>
    into(Object.entries(node).flatMap(([key, value]) => (NOT_RUN.has(key) ? [] : nodesIn(value))));
  const { type, callee, properties } = node as AnyNode & Readonly<Record<string, never>>;
  if (/Function/.test(type) || /^TS(Interface|TypeAlias)/.test(type)) return [];
  if (LITERAL.has(type) || DECLARED.test(type)) {
    // { ...LENGTH, title: 'radius' } has the fields of another literal.
    const spread = nodesIn(properties).filter((part) => part.type === 'SpreadElement');
    return spread.length === 0
      ? below()
      : into(nodesIn(properties).map((part) => (part.argument ?? part) as AnyNode));
  }
  if (type === 'VariableDeclarator') return into(nodesIn([node.init, ...defaultsOf(node.id)]));
  if (type === 'ClassDeclaration' || type === 'ClassBody') {
    return into(nodesIn([node.superClass, node.body].flat()));
  }
  if (type === 'MethodDefinition') return into(node.computed ? nodesIn(node.key) : []);
  if (type === 'PropertyDefinition') {
    return into(nodesIn([node.computed && node.key, node.static && node.value]));
  }
  if (type === 'CallExpression' && textOf(callee) === 'lazily')
    return into(nodesIn(node.arguments));
  return [source.slice(node.start as number, node.end as number)];
}

const nodesIn = (value: unknown): AnyNode[] => [value].flat().filter(isNode);
/** { a = f() } of a pattern. */
const defaultsOf = (pattern: unknown): AnyNode[] =>
  nodesIn(pattern).flatMap((one) => within(one).filter(({ type }) => type === 'AssignmentPattern'));

/** What the math module makes when it is imported, and what it imports of other rooms. */
function madeAtImport(sources: Sources): string[] {
  const reached = new Set(Object.keys(sources).filter((path) => roomOf(path) === 'math'));
  for (const path of reached) {
    for (const { from, typesOnly } of importsOf(path, sources[path] ?? '')) {
      if (!typesOnly) reached.add(posix.join(posix.dirname(path), from));
    }
  }
  return [...reached].flatMap((path) => {
    const source = sources[path] ?? '';
    return bodyOf(path, source).flatMap((node) =>
      madeIn(node, source).map((one) => `${path}: ${one}`),
    );
  });
}

function sourcesUnder(folder: string): Sources {
  const files = readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' });
  const paths = files.filter((name) => /\.ts$/.test(name)).map((name) => `${folder}/${name}`);
  return Object.fromEntries(
    paths.map((path) => [path.replaceAll('\\', '/'), readFileSync(join(ROOT, path), 'utf8')]),
  );
}

const SRC = sourcesUnder('src');
const BESIDE = { ...sourcesUnder('tests'), ...sourcesUnder('scripts') };

describe('src', () => {
  test('is all there, and every room has a name in the table', () => {
    expect(Object.keys(SRC).length).toBeGreaterThan(80);
    const rooms = new Set(Object.keys(SRC).map(roomOf));
    expect(Object.keys(ROOMS)).toEqual(expect.arrayContaining([...rooms]));
    expect([...rooms]).toEqual(expect.arrayContaining(['math', 'state', 'canvas', 'main']));
  });

  test('has the table that docs/ARCHITECTURE.md shows', () => {
    const text = readFileSync(join(ROOT, 'docs/ARCHITECTURE.md'), 'utf8');
    const rows = [...text.matchAll(/^\| (`.*`) \| .* \| (.*?)(?: \(.*\))? \|$/gm)];
    const shown = rows.flatMap(([, folders = '', words = '']) =>
      [...folders.matchAll(/`(\w+)(?:\.ts)?`/g)].map(([, room = '']) => [
        room,
        words
          .split(', ')
          .flatMap((one) => (one === 'the pure rooms' ? PURE : one === 'nothing' ? [] : [one]))
          .sort(),
      ]),
    );
    const sorted = Object.entries(ROOMS).map(([room, allowed]) => [room, [...allowed].sort()]);
    expect(Object.fromEntries(shown)).toEqual(Object.fromEntries(sorted));
  });

  test('imports only along the table', () => {
    expect(wrongImports(SRC)).toEqual([]);
  });

  test('imports files that exist, by their full name', () => {
    const missing = Object.entries(SRC).flatMap(([path, source]) =>
      importsOf(path, source)
        .filter(({ from }) => from.startsWith('.'))
        .map(({ from }) => posix.join(posix.dirname(path), from.replace(/\?.*$/, '')))
        .filter((target) => !existsSync(join(ROOT, target)))
        .map((target) => `${path}: ${target}`),
    );
    expect(missing).toEqual([]);
  });

  test('reads no source text in the math module: kernels are generated files', () => {
    const reading = Object.entries(SRC).filter(
      ([path, text]) => path.startsWith('src/math/') && /\?raw\b/.test(text),
    );
    expect(reading.map(([path]) => path)).toEqual([]);
  });

  test('has no files that import each other in a circle, types included', () => {
    expect(circles(SRC)).toEqual([]);
    // Nor what shows how to add things.
    expect(circles(BESIDE)).toEqual([]);
  });

  test('exports only what another file imports, the face of the math module aside', () => {
    const unused = unusedExports(SRC, { ...SRC, ...BESIDE });
    const free = /^src\/embed\.ts|^src\/math\/(?:index\.ts|methods\/certified\/)/;
    expect(unused.filter((one) => !free.test(one))).toEqual([]);
  });

  test('has no file that only tests import', () => {
    expect(unreached(SRC)).toEqual([]);
  });

  test('has no page, no clock and no chance in its pure rooms', () => {
    expect(wrongNames(SRC)).toEqual([]);
  });

  test('has no case distinction over shapes outside of src/math/shapes', () => {
    expect(wrongSwitches(SRC)).toEqual([]);
  });

  test('has a live region in the announcer only', () => {
    expect(liveRegions(SRC)).toEqual(['src/ui/announcer.ts']);
  });

  test('acts at import only in main, custom elements and workers', () => {
    expect(wrongActs(SRC)).toEqual([]);
  });
});

describe('the math module', () => {
  test('makes nothing at import: every value is a literal, or asked for by `lazily`', () => {
    expect(madeAtImport(SRC)).toEqual([]);
  });

  test.each([
    'const tree = plus(a, b);',
    'export const known = new Map();',
    'const list = [1, ...others];',
    'const both = { ...first, made: make() };',
    'const deep = { a: [{ b: -f() }] };',
    'const later = lazily(make());',
    'const { a = f() } = b;',
    'class A { static readonly x = f(); }',
    'class A extends f() {}',
    'class A { static { f(); } }',
    'class A { [f()]() {} }',
    'export default f();',
    // biome-ignore lint/suspicious/noTemplateCurlyInString: source text.
    'const text = `${f()}`;',
    'const text = tag`x`;',
    'for (const x of list) x.y = 1;',
    'if (a) f();',
    'a.b = 1;',
    'let n = 0; n++;',
    'const x = (() => 1)();',
    "const x = await import('./x.ts');",
  ])('would notice %s', (source) => {
    expect(madeAtImport({ 'src/math/wrong.ts': source })).toHaveLength(1);
  });

  test.each([
    'const tree: Expr = { op: "square", of: B }; export const list: number[] = [-1, 2 ** 9];',
    'export const f = () => g(); function g() { return new Map(); } const { fround } = Math;',
    'const later = lazily(() => new Map()); let last: number | undefined; const key = `a`;',
    'class A extends Error { name = f(); static x = { get() { return f(); } }; #y = new Map(); }',
    'export const cone = { ...POINT, get x() { return f(); }, y } satisfies Cone as const;',
    'export * from "./a.ts"; export { b } from "./b.ts"; interface C { d(): void } type E = C;',
  ])('and let pass %s', (source) => {
    expect(madeAtImport({ 'src/math/fine.ts': source })).toEqual([]);
  });
});

describe('these rules would notice', () => {
  const one = (path: string, source: string): Sources => ({ [path]: source });

  test.each([
    ['math', "import '../state/state.ts';"],
    ['math', "import type { SceneModel } from '../state/scene-model.ts';"],
    ['math', "export { render } from 'lit';"],
    ['math', "import * as THREE from 'three';"],
    ['math', "import { readFileSync } from 'node:fs';"],
    ['text', "import type { Vec3 } from '../math/vec3.ts';"],
    ['tracer', "import { display } from '../text/format.ts';"],
    ['ui', "import type { Vec3 } from '../math/vec3.ts';"],
    ['state', "import { theme } from '../ui/theme.ts';"],
    ['state', "import { trace } from '../tracer/trace.ts';"],
    ['state', "import { html } from 'lit';"],
    ['canvas', "import { algebra } from '../panels/algebra.ts';"],
    ['panels', "const late = () => import('../canvas/scene.ts');"],
    ['charts', "import { Vector3 } from 'three/src/math/Vector3.js';"],
    ['charts', "type Late = import('../panels/value.ts').Value;"],
    ['panels', "import { parse } from '../../tests/unit/helper.ts';"],
    ['lab', "new Worker(new URL('../workers/lab.ts', import.meta.url));"],
    ['panels', "import type { Vec3 } from '../math/vec3.ts';"],
    ['kitchen', "import { cone } from '../math/index.ts';"],
  ])('%s: %s', (room, source) => {
    expect(wrongImports(one(`src/${room}/wrong.ts`, source))).toHaveLength(1);
  });

  test('and let these pass', () => {
    const fine: Sources = {
      'src/state/fine.ts':
        "import type { Tree } from '../tracer/tree.ts'; import { f } from '../math/index.ts';",
      'src/math/batch/fine.ts': "import { cone } from '../shapes/cone.ts';",
      'src/canvas/fine.ts': "import { Mesh } from 'three'; import './scene.css';",
      'src/main.ts': "import { mountExplore } from './pages/explore.ts';",
      'src/state/exports/text.ts': "export const code = `\nimport { test } from 'vitest';\n`;",
    };
    expect(wrongImports(fine)).toEqual([]);
  });

  test.each([
    ['src/math/wrong.ts', 'export const x = () => Math.random();'],
    ['src/math/wrong.ts', 'export const x = () => Date.now();'],
    ['src/math/wrong.ts', 'export const x = () => performance.now();'],
    ['src/math/wrong.ts', 'export const x = () => window.innerWidth;'],
    ['src/math/wrong.ts', 'export const f = (e: HTMLElement) => e;'],
    ['src/state/wrong.ts', 'export const x = () => document.title;'],
    ['src/lab/wrong.ts', 'export const x = () => performance.now();'],
  ])('%s: %s', (path, source) => {
    expect(wrongNames(one(path, source))).toHaveLength(1);
  });

  test('but not a word that only looks like one', () => {
    const source = 'export const x = { Date: 1, document: 2 }.document; const s = "window";';
    expect(wrongNames(one('src/math/fine.ts', source))).toEqual([]);
  });

  test.each([
    ["export const f = (s: { kind: string }) => { switch (s.kind) { case 'cone': return 1; } };"],
    ["export const f = (kind: string) => kind === 'plane';"],
    ["export const f = (s: { kind: string }) => 'circle' !== s.kind;"],
    ["export const f = (s: { kind: string }) => (s.kind === 'square' ? 1 : 2);"],
  ])('%s', (source) => {
    expect(wrongSwitches(one('src/panels/wrong.ts', source))).toHaveLength(1);
    expect(wrongSwitches(one('src/math/shapes/fine.ts', source))).toEqual([]);
  });

  test('a circle, also one of types', () => {
    const round: Sources = {
      'src/text/a.ts': "import type { B } from './b.ts';",
      'src/text/b.ts': "export { c } from './c.ts';",
      'src/text/c.ts': "const late = () => import('./a.ts');",
      'src/text/d.ts': "import { c } from './c.ts';",
    };
    expect(circles(round)).toEqual(['src/text/a.ts ↔ src/text/b.ts ↔ src/text/c.ts']);
    expect(circles({ ...round, 'src/text/c.ts': '' })).toEqual([]);
  });

  test('an export that nobody imports, however modules are imported', () => {
    const text = 'export const a = 1; export type B = 1; export { c } from "./y.ts";';
    const sources = one('src/text/x.ts', text);
    const by = (importer: string) => unusedExports(sources, one('src/text/z.ts', importer));
    const all = ['a', 'B', 'c'].map((name) => `src/text/x.ts ${name}`);
    expect(by('import "./x.ts"; const a = 1;')).toEqual(all);
    expect(by('import { a as c, type B } from "./x.ts";')).toEqual([all[2]]);
    expect(by('import * as x from "./x.ts"; x.a + x.c;')).toEqual([all[1]]);
    expect(by('const f = async () => (await import("./x.ts")).c;')).toEqual([all[0], all[1]]);
    expect(by('export { c } from "./x.ts"; type T = typeof import("./x.ts");')).toEqual([
      ...all.slice(0, 2),
    ]);
    const late = one('src/main.ts', 'const f = () => import("./text/a.ts");');
    expect(unreached({ ...late, 'src/text/a.ts': '', 'src/text/b.ts': '' })).toEqual([
      'src/text/b.ts',
    ]);
  });

  test.each([
    'html`<p role="status">x</p>`',
    'html`<p role=alert>x</p>`',
    "element.setAttribute('role', 'log')",
    "element.role = 'status'",
    "element.ariaLive = 'polite'",
    'html`<div aria-live=polite></div>`',
    'html`<output>1</output>`',
  ])('%s', (source) => {
    expect(liveRegions(one('src/panels/wrong.ts', source))).toHaveLength(1);
    expect(liveRegions(one('src/panels/fine.ts', 'html`<p data-say>x</p>`; status'))).toEqual([]);
  });

  test('and a formula’s square is no shape', () => {
    const source =
      "const f = (e: { op: string }) => { switch (e.op) { case 'square': return 1; } };";
    expect(wrongSwitches(one('src/panels/fine.ts', source))).toEqual([]);
  });

  test.each([
    ['src/panels/wrong.ts', 'document.body.append("x");'],
    ['src/ui/wrong.ts', 'export const dark = window.matchMedia("x").matches;'],
    ['src/pages/wrong.ts', 'if (location.hash) alert(1);'],
    ['src/charts/wrong.ts', 'export const size = [window.innerWidth];'],
    ['src/state/wrong.ts', 'start();'],
    ['src/state/wrong.ts', 'globalThis.x = 1;'],
    ['src/ui/wrong.ts', 'document.title = "x";'],
  ])('%s: %s', (path, source) => {
    expect(wrongActs(one(path, source)).length).toBeGreaterThan(0);
  });

  test('and let elements and main act', () => {
    const element = "class X {} customElements.define('graze-x', X as never);";
    const later = 'export function f() { return document.title; } const g = () => window.name;';
    expect(wrongActs(one('src/ui/x.ts', element))).toEqual([]);
    expect(wrongActs(one('src/ui/x.ts', later))).toEqual([]);
    expect(wrongActs(one('src/math/x.ts', 'const one = { n: 0 }; one.n = 1;'))).toEqual([]);
    expect(wrongActs(one('src/main.ts', 'document.title = "Graze";'))).toEqual([]);
    expect(wrongActs(one('src/workers/lab.ts', 'self.onmessage = () => {};'))).toEqual([]);
  });
});

test('code that is loaded lazily is imported by `lazy`, which loads again what failed', () => {
  const asks = Object.entries(SRC).flatMap(([path, source]) =>
    // A worker has no document; the offline file carries what is imported as text.
    /^src\/scene\/effects\//.test(path)
      ? []
      : [...source.replace(/\s+/g, ' ').matchAll(/.{0,40}[^.\w]import\(['"][^'"]*/g)]
          .map(([line]) => line)
          .filter((line) => !/typeof import\(|\?raw/.test(line)),
  );
  expect(asks.length).toBeGreaterThan(5);
  // Also by functions that pass it on to `lazy`: lazyCard.
  for (const line of asks) expect(line).toMatch(/lazy\w*\( ?\(\) => import\(/);
});
