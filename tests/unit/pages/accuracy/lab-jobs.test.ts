import { describe, expect, test } from 'vitest';
import type { LabReply } from '../../../../src/lab/messages.ts';
import type { Measured, MeasureRequest } from '../../../../src/lab/session.ts';
import { type LabWorker, measureJob, sweepJob } from '../../../../src/pages/accuracy/lab-jobs.ts';

const REQUEST = { family: 'typical' } as MeasureRequest;
const measured = (round: number, complete = false): LabReply => ({
  type: 'measured',
  measured: { round, complete } as Measured,
});

/** A worker that answers when it is told to. */
class FakeWorker implements LabWorker {
  onmessage: LabWorker['onmessage'] = null;
  onerror: LabWorker['onerror'] = null;
  readonly asked: unknown[] = [];
  ended = false;
  postMessage(request: unknown): void {
    this.asked.push(request);
  }
  terminate(): void {
    this.ended = true;
  }
  reply(data: LabReply): void {
    this.onmessage?.({ data } as MessageEvent<LabReply>);
  }
}

function bench() {
  const workers: FakeWorker[] = [];
  let drawn = 0;
  const spawn = async (): Promise<LabWorker> => {
    const worker = new FakeWorker();
    workers.push(worker);
    return worker;
  };
  const changed = (): void => {
    drawn += 1;
  };
  return { workers, spawn, changed, drawn: () => drawn };
}

const arrived = (): Promise<void> => new Promise((done) => setTimeout(done));

describe('a job', () => {
  test('asks a worker of its own, keeps what comes, and ends it when it is done', async () => {
    const { workers, spawn, changed, drawn } = bench();
    const job = measureJob(spawn, changed);
    job.start(REQUEST);
    expect(job.running).toBe(true);
    await arrived();
    const [worker] = workers;
    expect(worker?.asked).toEqual([{ type: 'measure', request: REQUEST }]);
    worker?.reply(measured(3));
    expect(job.result?.round).toBe(3);
    worker?.reply(measured(15, true));
    worker?.reply({ type: 'done' });
    expect(worker?.ended).toBe(true);
    expect([job.running, job.result?.complete]).toEqual([false, true]);
    expect(drawn()).toBe(4);
  });

  test('is cancelled at once: its worker ends, late replies are dropped', async () => {
    const { workers, spawn, changed } = bench();
    const job = measureJob(spawn, changed);
    job.start(REQUEST);
    await arrived();
    workers[0]?.reply(measured(3));
    job.cancel();
    expect([job.running, workers[0]?.ended]).toEqual([false, true]);
    workers[0]?.reply(measured(4));
    expect(job.result?.round).toBe(3);
  });

  test('may be cancelled while its worker is still on the way', async () => {
    const { workers, spawn, changed } = bench();
    const job = measureJob(spawn, changed);
    job.start(REQUEST);
    job.cancel();
    await arrived();
    expect([workers[0]?.ended, workers[0]?.asked]).toEqual([true, []]);
    expect(job.running).toBe(false);
  });

  test('started again ends the one before, whose replies count for nothing', async () => {
    const { workers, spawn, changed } = bench();
    const job = sweepJob(spawn, changed);
    const ask = { family: 'far-origin', seed: 1, shapes: 1, count: 1, points: 2 };
    job.start(ask);
    await arrived();
    job.start({ ...ask, seed: 2 });
    await arrived();
    expect(workers[0]?.ended).toBe(true);
    workers[0]?.reply({ type: 'swept', point: { difficulty: 9, rows: [] } });
    workers[1]?.reply({ type: 'swept', point: { difficulty: 0, rows: [] } });
    workers[1]?.reply({ type: 'swept', point: { difficulty: 1, rows: [] } });
    expect(job.result?.map(({ difficulty }) => difficulty)).toEqual([0, 1]);
    expect(job.request?.seed).toBe(2);
  });

  test('says why it failed: in the worker, by the worker, or before there was one', async () => {
    const { workers, spawn, changed } = bench();
    const job = measureJob(spawn, changed);
    job.start(REQUEST);
    await arrived();
    workers[0]?.reply({ type: 'failed', message: "unknown family 'x'" });
    expect([job.running, job.failed]).toEqual([false, "unknown family 'x'"]);
    job.start(REQUEST);
    expect(job.failed).toBe('');
    await arrived();
    workers[1]?.onerror?.({ message: '' } as ErrorEvent);
    expect(job.failed).toBe('the worker could not be started');
    const none = measureJob(() => Promise.reject(new Error('no workers here')), changed);
    none.start(REQUEST);
    await arrived();
    expect([none.running, none.failed]).toEqual([false, 'no workers here']);
  });
});
