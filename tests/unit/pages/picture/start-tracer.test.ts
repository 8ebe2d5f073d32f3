import { expect, it } from 'vitest';
import { startedAhead } from '../../../../src/pages/picture/start-tracer.ts';
import { type FakeWorker, fakeWorker } from '../../tracer/fake-worker.ts';

function watched() {
  const started: FakeWorker[] = [];
  const start = (): FakeWorker => {
    const worker = fakeWorker();
    started.push(worker);
    return worker;
  };
  return { started, start };
}

it('hands out the workers that were started ahead, then new ones', () => {
  const { started, start } = watched();
  const next = startedAhead(start, 2);
  const ahead = [...started];
  expect(ahead).toHaveLength(2);
  const given = [next(), next(), next()];
  expect(new Set(given.slice(0, 2))).toEqual(new Set(ahead));
  expect(ahead).not.toContain(given[2]);
  expect(given).toContain(started[2]);
});

it('a worker whose start has failed unheard is ended, and another one takes its place', () => {
  const { started, start } = watched();
  const next = startedAhead(start, 1);
  const [first] = started;
  first?.crash('no such file');
  const given = next();
  expect(first?.terminated).toBe(true);
  expect(given).toBe(started[1]);
});
