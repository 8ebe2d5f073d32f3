import type { Question } from '../../src/math/families.ts';

type Json = number | string | boolean | null | readonly Json[] | { readonly [key: string]: Json };

/** Simpler numbers to try in x's place, simplest first. */
const simpler = (x: number): number[] =>
  [
    0,
    1,
    -1,
    Math.round(x),
    Math.fround(x),
    Number(x.toPrecision(3)),
    Number(x.toPrecision(8)),
  ].filter((y) => Number.isFinite(y) && y !== x && String(y).length < String(x).length);

/**
 * The same failure with simpler numbers: each in turn is replaced as long as the question still
 * fails.
 */
export function shrink(question: Question, fails: (question: Question) => boolean): Question {
  const stillFails = (candidate: Json): boolean => {
    try {
      return fails(candidate as unknown as Question);
    } catch {
      // No longer a question at all: a zero direction, say.
      return false;
    }
  };
  let best = JSON.parse(JSON.stringify(question)) as Json;
  for (let changed = true; changed; ) {
    changed = false;
    for (const path of paths(best)) {
      for (const y of simpler(at(best, path) as number)) {
        const candidate = replaced(best, path, y);
        if (!stillFails(candidate)) continue;
        best = candidate;
        changed = true;
        break;
      }
    }
  }
  return best as unknown as Question;
}

type Path = readonly string[];

function paths(json: Json, here: Path = []): Path[] {
  if (typeof json === 'number') return [here];
  if (typeof json !== 'object' || json === null) return [];
  return Object.entries(json).flatMap(([key, value]) => paths(value, [...here, key]));
}

const at = (json: Json, path: Path): Json =>
  path.reduce<Json>((inside, key) => (inside as Record<string, Json>)[key] as Json, json);

function replaced(json: Json, path: Path, value: Json): Json {
  const [key, ...rest] = path;
  if (key === undefined) return value;
  const copy = (Array.isArray(json) ? [...json] : { ...(json as object) }) as Record<string, Json>;
  copy[key] = replaced(copy[key] as Json, rest, value);
  return copy as Json;
}
