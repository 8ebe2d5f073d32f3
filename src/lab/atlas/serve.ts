import type { LabReply, MapJob } from '../messages.ts';
import { piecesOf } from './frame.ts';
import { createMapper } from './map.ts';
import { probe } from './probe.ts';

/**
 * Does one map job after the other and posts pixels as they come. A new job ends the one before:
 * `pause` lets it be heard. An error becomes a reply.
 */
export function createMapServer(post: (reply: LabReply) => void, pause: () => Promise<void>) {
  let latest = -1;
  return async (asked: MapJob): Promise<void> => {
    const { job } = asked;
    latest = job;
    try {
      if (asked.type === 'probe') {
        post({ type: 'probed', job, probe: probe(asked.request) });
        return;
      }
      const mapper = createMapper(asked.request);
      for (const { block, pixels } of piecesOf(asked.part, asked.parts)) {
        post({ type: 'mapped', job, block, part: mapper.part(pixels) });
        await pause();
        if (latest !== job) return;
      }
    } catch (error) {
      post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
    }
  };
}
