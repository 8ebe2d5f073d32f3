import { REFLECTED, REFRACTED } from '../scene/effects/body.ts';
import type { Scene } from '../scene/types.ts';
import type { Recorder } from './tracer.ts';
import { NOTHING, type RayEnd, type RayKind, type RayNode, type RayTree } from './types.ts';

interface Growing extends RayNode {
  readonly children: RayNode[];
}

interface TreeRecorder extends Recorder {
  treeOf(x: number, y: number): RayTree;
}

/** Records the ray trees of one pixel's camera rays. */
export function createRecorder({ lights }: Scene): TreeRecorder {
  const nodes: Growing[] = [];
  const roots: RayNode[] = [];

  const add = (parent: number, node: Growing): void => {
    (nodes[parent]?.children ?? roots).push(node);
  };

  return {
    wave(wave) {
      const { rays } = wave;
      for (let i = 0; i < wave.count; i++) {
        const node: Growing = {
          kind: kindOf(wave.kind[i] as number),
          ray: {
            origin: [rays.Ex[i] as number, rays.Ey[i] as number, rays.Ez[i] as number],
            direction: [rays.dx[i] as number, rays.dy[i] as number, rays.dz[i] as number],
          },
          from: wave.from[i] as number,
          weight: Math.max(wave.red[i] as number, wave.green[i] as number, wave.blue[i] as number),
          end: endOf(wave, i),
          children: [],
        };
        add(wave.node[i] as number, node);
        wave.node[i] = nodes.push(node) - 1;
      }
    },
    shadowRays({ count, rays, from, blocker, t, node }, light) {
      const id = lights[light.index]?.id ?? '';
      for (let k = 0; k < count; k++) {
        const surface = blocker[k] as number;
        const end: RayEnd =
          surface === NOTHING
            ? { end: 'light', light: id, t: t[k] as number }
            : { end: 'blocked', light: id, t: t[k] as number, surface };
        add(node[k] as number, {
          kind: 'shadow',
          ray: {
            origin: [rays.Ex[k] as number, rays.Ey[k] as number, rays.Ez[k] as number],
            direction: [rays.dx[k] as number, rays.dy[k] as number, rays.dz[k] as number],
          },
          from: from[k] as number,
          weight: nodes[node[k] as number]?.weight ?? 0,
          end,
          children: [],
        });
      }
    },
    treeOf: (x, y) => ({ x, y, rays: roots }),
  };
}

function endOf(wave: Parameters<Recorder['wave']>[0], i: number): RayEnd {
  const surface = wave.surface[i] as number;
  if (surface === NOTHING) return { end: 'background' };
  return {
    end: 'hit',
    t: wave.t[i] as number,
    point: [wave.Px[i] as number, wave.Py[i] as number, wave.Pz[i] as number],
    normal: [wave.Nx[i] as number, wave.Ny[i] as number, wave.Nz[i] as number],
    surface,
  };
}

const kindOf = (kind: number): RayKind =>
  kind === REFLECTED ? 'reflected' : kind === REFRACTED ? 'refracted' : 'camera';
