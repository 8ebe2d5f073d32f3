import { derivationFor } from '../../check/compose.ts';
import { judge } from '../../check/judge.ts';
import { askedAt, type Progress } from '../../check/progress.ts';
import { plan, question } from '../../check/session.ts';
import { answeredOf, type Environment } from './course.ts';
import { answeredStatement, type Statement, type StatementContext } from './xapi.ts';

/**
 * The statements of a session, one for each question that was tried, with what stands in its boxes.
 * A step for each question, since posing one may take some 50 ms.
 */
export function* sessionStatements(
  progress: Progress,
  scene: Omit<StatementContext, 'registration'>,
  env: Environment,
): Generator<Statement[], void> {
  for (const [index] of plan(progress.seed, progress.set).entries()) {
    const { tries, texts } = askedAt(progress, index);
    if (tries > 0) {
      const posed = question(progress.seed, index, progress.set);
      const judged = judge(derivationFor(posed), texts);
      const answered = answeredOf(posed, index, progress, judged);
      const own = { ...scene, registration: '' };
      yield answered ? [answeredStatement(answered, own, env)] : [];
    }
  }
}
