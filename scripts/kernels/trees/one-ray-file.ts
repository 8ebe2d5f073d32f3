import { courseForm } from '../../../src/math/methods/forms.ts';
import { formOf, normalOf, pointOf, rootsOf } from './emit-one-ray.ts';
import { Graph } from './graph.ts';
import type { Question } from './program.ts';
import { header, keyOf, nameOf, wrapped } from './text.ts';

/** A question to a kind of shape; `turns`: its trees depend on a parameter that is an axis. */
type Asked = Question & { readonly kind: string; readonly turns: boolean };

/** From which method a part is taken; null: from this one. */
type Shared = Readonly<Record<'forms' | 'roots', string | null>>;

const VERDICT = /\breturn ([A-Z]+);/g;

/**
 * The pieces of a method for one ray. Objects are made of those of the course's form in doubles
 * only: the other files have what batches need, curved shapes without points and normals.
 */
export function oneRay(title: string, questions: readonly Asked[], shared: Shared): string {
  const [{ system, form, solver }] = questions as [Asked];
  const forObjects = form === courseForm && system.format.width === 64;
  const isCurved = ({ formula }: Asked): boolean => formula.family === 'curved';
  const asked = questions.filter((one) => isCurved(one) || (forObjects && !one.turns));
  const curved = asked.filter(isCurved);
  const record = (suffix: string, of: readonly Asked[]): string =>
    `{\n${of.map(({ kind }) => `${keyOf(kind)}: ${nameOf(kind)}${suffix},`).join('\n')}\n}`;

  const functions: string[] = [];
  const parts: string[] = [];
  if (shared.forms) {
    parts.push(`...${nameOf(shared.forms)}`);
  } else {
    functions.push(...asked.map((one) => formOf(nameOf(one.kind), one)));
    parts.push(`forms: ${record('', asked)}`);
    if (forObjects) {
      functions.push(pointOf(system), ...curved.map((one) => normalOf(nameOf(one.kind), one)));
      parts.push('point', `normals: ${record('Normal', curved)}`);
    }
  }
  if (!shared.roots) functions.push(rootsOf(solver, system));
  parts.push(shared.roots ? `roots: ${nameOf(shared.roots)}.roots` : 'roots');

  const type = forObjects ? 'Pieces' : 'OneRay';
  const body = [
    ...functions,
    `export const ONE_RAY: ${type} = {\n${parts.map((part) => `${part},`).join('\n')}\n};`,
  ].join('\n\n');
  const verdicts = [...new Set(Array.from(body.matchAll(VERDICT), ([, word]) => word))].sort();
  const types = [type, 'PutForm', 'PutNormal', 'PutPoint', 'PutRoots'].filter((name) =>
    new RegExp(`: ${name}\\b`).test(body),
  );
  const others = [...new Set(Object.values(shared).filter((id) => id !== null))];
  const { arithmetic } = system.make(new Graph(system.format));
  return [
    header(`One ray by the method ${title}, in ${arithmetic.id}.`),
    ...(body.includes('Vec3') ? ["import type { Vec3 } from '../../vec3.ts';\n"] : []),
    ...(verdicts.length > 0 ? [`import { ${verdicts.join(', ')} } from '../batch.ts';\n`] : []),
    `import type { ${types.sort().join(', ')} } from '../one-ray.ts';\n`,
    ...others.map((id) => `import { ONE_RAY as ${nameOf(id)} } from './${id}-one.ts';\n`),
    body.includes('fround(') ? '\nconst { fround } = Math;\n\n' : '\n',
    wrapped(body),
  ].join('');
}
