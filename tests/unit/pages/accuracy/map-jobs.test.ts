import { describe, expect, test } from 'vitest';
import { mapOf } from '../../../../src/lab/atlas/frame.ts';
import type { MapRequest } from '../../../../src/lab/atlas/request.ts';
import { createMapServer } from '../../../../src/lab/atlas/serve.ts';
import type { LabReply, LabRequest } from '../../../../src/lab/messages.ts';
import { mapJobs } from '../../../../src/pages/accuracy/atlas/map-jobs.ts';
import type { LabWorker } from '../../../../src/pages/accuracy/lab-jobs.ts';

const REQUEST: MapRequest = {
  shape: { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
  ray: { origin: [5, 0, 1], direction: [-1, 0, 0] },
  ...{ unit: false, axes: ['E.z', 'r'], at: [1, 1], measure: 'ulps', zoom: 13, method: 'textbook' },
};

const turn = (): Promise<void> => new Promise((done) => setTimeout(done));

/** A worker that does the work in this thread, a piece at each turn. */
class TrueWorker implements LabWorker {
  onmessage: LabWorker['onmessage'] = null;
  onerror: LabWorker['onerror'] = null;
  readonly asked: LabRequest[] = [];
  ended = false;
  private readonly serve = createMapServer((data: LabReply) => {
    if (!this.ended) this.onmessage?.({ data } as MessageEvent<LabReply>);
  }, turn);
  postMessage(request: LabRequest): void {
    this.asked.push(request);
    if (request.type === 'map' || request.type === 'probe') void this.serve(request);
  }
  terminate(): void {
    this.ended = true;
  }
}

function bench() {
  const workers: TrueWorker[] = [];
  const spawn = async (): Promise<LabWorker> => {
    const worker = new TrueWorker();
    workers.push(worker);
    return worker;
  };
  const jobs = mapJobs(spawn, () => {}, 2);
  const until = async (holds: () => boolean): Promise<void> => {
    while (!holds()) await turn();
  };
  return { workers, jobs, until };
}

describe('the maps’ workers', () => {
  test('draw it together, coarse to fine, and look at it closely', async () => {
    const { workers, jobs, until } = bench();
    jobs.show(REQUEST);
    expect(jobs.state()).toMatchObject({ running: true, share: 0, frame: null });
    await until(() => jobs.state().frame !== null);
    // Every pixel has a colour before a tenth of them has been asked.
    expect(jobs.state().share).toBeLessThan(0.1);
    await until(() => !jobs.state().running);
    expect(workers).toHaveLength(2);
    expect(jobs.state().frame?.marks).toEqual(mapOf(REQUEST).marks);
    expect(jobs.state().summary?.wrong).toBeGreaterThan(0);
    await until(() => jobs.state().probe !== null);
    expect(jobs.state().probe?.torn[0]?.line).toBe('D');
    // The same again is there already.
    jobs.show({ ...REQUEST });
    expect(jobs.state().running).toBe(false);
  });

  test('a window that follows ends the one before, whose pixels count for nothing', async () => {
    const { workers, jobs, until } = bench();
    jobs.show(REQUEST);
    await until(() => jobs.state().share > 0);
    const next = { ...REQUEST, zoom: 12 };
    jobs.show(next);
    await until(() => !jobs.state().running);
    expect(workers).toHaveLength(2);
    expect(jobs.state().shown).toBe(next);
    expect(jobs.state().frame?.marks).toEqual(mapOf(next).marks);
  });

  test('cancelled, they end at once; what is there stays, and it can go on', async () => {
    const { workers, jobs, until } = bench();
    jobs.show(REQUEST);
    await until(() => jobs.state().frame !== null);
    jobs.cancel();
    expect(jobs.state().running).toBe(false);
    expect(workers.every(({ ended }) => ended)).toBe(true);
    const { share, frame } = jobs.state();
    for (let i = 0; i < 5; i++) await turn();
    expect(jobs.state().share).toBe(share);
    expect(frame).not.toBeNull();
    jobs.show(REQUEST);
    expect(jobs.state().running).toBe(false);
    jobs.again();
    await until(() => jobs.state().summary !== null);
  });

  test('a map that cannot be drawn says why', async () => {
    const { jobs, until } = bench();
    jobs.show({ ...REQUEST, axes: ['E.z', 'k'] });
    await until(() => !jobs.state().running);
    expect(jobs.state().failed).toContain("'k' is no number of a ray and a cylinder");
    const none = mapJobs(
      () => Promise.reject(new Error('no workers here')),
      () => {},
      2,
    );
    none.show(REQUEST);
    await until(() => !none.state().running);
    expect(none.state().failed).toBe('no workers here');
  });
});
