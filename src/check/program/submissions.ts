/* Which files of a class are graded, and whose they are. */

const PROGRAMS = ['js', 'mjs', 'cjs', 'ts', 'mts'];
const RESULTS = ['json', 'jsonl', 'csv', 'tsv', 'txt'];

const endingOf = (name: string): string => /\.([^./]+)$/.exec(name)?.[1]?.toLowerCase() ?? '';

/** Whether a file is a program that is run, by its name. */
export const isProgram = (name: string): boolean => PROGRAMS.includes(endingOf(name));

/** Whether a file may hold results of a program in another language. */
export const isResults = (name: string): boolean => RESULTS.includes(endingOf(name));

export const isGraded = (name: string): boolean => isProgram(name) || isResults(name);

type Chosen = { readonly name: string } | { readonly problem: string };

/** The file of a folder that is graded: the only one that can be, or that is called so. */
export function chosenOf(names: readonly string[]): Chosen {
  const files = names.filter(isGraded);
  const named = files.filter((name) => /^(?:intersect|results)\./.test(name));
  const [only, ...others] = named.length > 0 ? named : files;
  if (only === undefined) return { problem: 'nothing in this folder can be graded' };
  if (others.length === 0) return { name: only };
  return { problem: `several files in this folder could be meant: ${files.join(', ')}` };
}

/** Those of the same name are told apart: two of them would be one line of a course system. */
export const toldApart = <T extends { readonly who: string }>(all: readonly T[]): T[] =>
  all.map((one, i) => {
    const before = all.slice(0, i).filter(({ who }) => who === one.who).length;
    return before === 0 ? one : { ...one, who: `${one.who} (${before + 1})` };
  });

/** A file of a submission and whose it is: the file's name, or that of its folder. */
export interface Submission<F> {
  readonly who: string;
  readonly file: F | null;
  /** Why nothing of it is graded; '' if something is. */
  readonly problem: string;
}

/**
 * The submissions among files with their paths. The folder that all are in is the class's, if there
 * are folders or several files within it; a file or a folder in it is a submission.
 */
export function submissionsAmong<F extends { readonly path: string }>(
  files: readonly F[],
): Submission<F>[] {
  const split = files.map((file) => ({ file, parts: file.path.split('/').filter(Boolean) }));
  const [first] = split;
  const isAll = split.every(({ parts }) => parts.length > 1 && parts[0] === first?.parts[0]);
  const isOfClass = isAll && (split.length > 1 || (first?.parts.length ?? 0) > 2);
  const folders = new Map<string, F[]>();
  const alone: Submission<F>[] = [];
  for (const { file, parts } of split) {
    const [top = '', ...within] = isOfClass ? parts.slice(1) : parts;
    if (within.length > 0) folders.set(top, [...(folders.get(top) ?? []), file]);
    else alone.push({ who: top.replace(/\.[^.]*$/, ''), file, problem: '' });
  }
  const ofFolders = [...folders].map(([who, own]): Submission<F> => {
    const name = (file: F): string => file.path.split('/').at(-1) ?? '';
    const chosen = chosenOf(own.map(name));
    if ('problem' in chosen) return { who, file: null, problem: chosen.problem };
    return { who, file: own.find((file) => name(file) === chosen.name) ?? null, problem: '' };
  });
  return toldApart(
    [...alone, ...ofFolders].sort((a, b) => a.who.localeCompare(b.who, 'en', { numeric: true })),
  );
}
