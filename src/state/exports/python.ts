import { POINT, PYTHON as SYNTAX } from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import { body, type Language, vectorCode } from './language.ts';
import { type Constant, partsOf } from './parts.ts';
import type { Test } from './program.ts';

/** The same program as the TypeScript export; it uses the standard library only. */
export const python: Export = {
  id: 'python',
  title: 'the ray as Python',
  extension: 'py',
  mime: 'text/x-python',
  text: rayPython,
};

const LANGUAGE: Language = {
  syntax: SYNTAX,
  comment: (text) => `# ${text}`,
  put: (name, value) => `${name} = ${value}`,
  vector: (parts) => `(${parts.join(', ')})`,
  putVector: (name, value) => `${name} = ${value}`,
  test: testCode,
  when: (test, then) => [`if ${test}:`, ...then.map((line) => `    ${line}`)],
  answer: (verdict, ts) => `return "${verdict}", [${ts.join(', ')}]`,
  indent: '    ',
};

export function rayPython(model: ExploreModel): string {
  const { program, shape, E, d, ends, about, names } = partsOf(model);
  const own = names(SYNTAX.component);
  return `${[
    ...about.map(LANGUAGE.comment),
    'import json',
    'import math',
    '',
    ...shape.map(constant),
    ...(ends?.heights ?? []).map(constant),
    '',
    '',
    'def intersect(E, d):',
    '    """The case, and t of every point of the whole line, ascending."""',
    ...body(program, LANGUAGE, own),
    '',
    '',
    'def hit_at(E, d, t):',
    '    """The point at t, and the course\'s normal there: not normalised, zero at a singular ' +
      'point."""',
    `    X = ${vectorCode(POINT, LANGUAGE, own)}`,
    `    normal = ${vectorCode(program.normal, LANGUAGE, own)}`,
    '    singular = all(n == 0 for n in normal)',
    '    normal = (0.0, 0.0, 0.0) if singular else normal',
    '    return {"t": t, "point": X, "normal": normal, "singular": singular}',
    '',
    '',
    ...[
      { name: 'E', value: E, title: 'eye' },
      { name: 'd', value: d, title: 'direction' },
    ].map(constant),
    ...(ends ? endsCode(ends.caps, ends.f(SYNTAX)) : []),
    ...(ends ? MAIN.map((line) => (line.startsWith('print') ? WITH_ENDS : line)) : MAIN),
  ].join('\n')}\n`;
}

const WITH_ENDS = 'print(json.dumps({"class": verdict, "hits": with_ends(verdict, hits)}))';

const endsCode = (caps: boolean, f: string): string[] =>
  `

def with_ends(verdict, hits):
    """Each root is a hit or cut off${caps ? ', and through a disc it meets a cap' : ''}."""
    roots = [
        {**hit, "fate": "cut" if hit["point"][1] < low or hit["point"][1] > high else "hit"}
        for hit in hits
    ]
${
  caps
    ? `    if d[1] == 0:
        return roots
    found = []
    for y in (low, high) if d[1] > 0 else (high, low):
        t = (y - E[1]) / d[1]
        X = (E[0] + t * d[0], y, E[2] + t * d[2])
        f = ${f}
        # On the rim the root there counts.
        if f > 0 if verdict == "contained" else not f < 0:
            continue
        while roots and not roots[0]["t"] > t:
            found.append(roots.pop(0))
        normal = (0.0, -1.0 if y == low else 1.0, 0.0)
        found.append({"t": t, "point": X, "normal": normal, "singular": False, "fate": "cap"})
    return found + roots`
    : '    return roots'
}

`.split('\n');

const MAIN = `
verdict, ts = intersect(E, d)
hits = [hit_at(E, d, t) for t in ts]
if any(math.isnan(x) for hit in hits for x in hit["point"] + hit["normal"]):
    verdict, hits = "undecided", []
print(json.dumps({"class": verdict, "hits": hits}))`.split('\n');

function constant({ name, value, title }: Constant): string {
  return typeof value === 'number'
    ? `${name} = ${SYNTAX.number(value)}  # ${title}`
    : `${name} = (${value.map(SYNTAX.number).join(', ')})  # ${title}`;
}

function testCode(test: Test): string {
  switch (test.is) {
    case 'zero':
      return `${test.name} == 0`;
    case 'negative':
      return `${test.name} < 0`;
    case 'greater':
      return `${test.name} > ${test.than}`;
    case 'lost':
      return test.names.map((name) => `not math.isfinite(${name})`).join(' or ');
    case 'positive':
      return test.names.map((name) => `0 < ${name} < math.inf`).join(' or ');
  }
}
