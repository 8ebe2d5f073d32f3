import type { Texts } from '../../check/grade.ts';
import { type Progress, readSessions, started, withSession } from '../../check/progress.ts';
import { recall, remember } from '../../ui/storage.ts';

const SESSIONS = 'graze.check.sessions';
const PROGRAM = 'graze.check.program';
const OWN = 'graze.check.own';

/** What this page keeps in the browser's storage, so that a reload loses nothing. */
export interface CheckStorage {
  session(seed: number, set: string): Progress;
  keep(progress: Progress): void;
  program(): string | null;
  keepProgram(source: string): void;
  own(): Texts;
  keepOwn(texts: Texts): void;
}

export function openCheckStorage(): CheckStorage {
  let sessions = readSessions(recall(SESSIONS));
  return {
    session: (seed, set) =>
      sessions.find((one) => one.seed === seed && one.set === set) ?? started(seed, set),
    keep(progress) {
      sessions = withSession(sessions, progress);
      remember(SESSIONS, JSON.stringify(sessions));
    },
    program: () => recall(PROGRAM),
    keepProgram: (source) => remember(PROGRAM, source),
    own: () => readTexts(recall(OWN)),
    keepOwn: (texts) => remember(OWN, JSON.stringify(texts)),
  };
}

function readTexts(text: string | null): Texts {
  try {
    const value: unknown = JSON.parse(text ?? '');
    if (typeof value !== 'object' || value === null) return {};
    return Object.fromEntries(Object.entries(value).filter(([, one]) => typeof one === 'string'));
  } catch {
    return {};
  }
}
