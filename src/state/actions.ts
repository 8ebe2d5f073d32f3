import type { Vec3 } from '../math/vec3.ts';
import type { View } from './view.ts';

/** Everything that can happen to the state. A dragged handle and a slider send the same action. */
export type Action =
  | { readonly type: 'shape'; readonly kind: string }
  | { readonly type: 'origin'; readonly value: Vec3 }
  | { readonly type: 'direction'; readonly value: Vec3 }
  | { readonly type: 'unit'; readonly on: boolean }
  | { readonly type: 'param'; readonly key: string; readonly value: Vec3 | number | string }
  | { readonly type: 'method'; readonly id: string }
  | { readonly type: 'view'; readonly view: View }
  | { readonly type: 'bead'; readonly t: number | null }
  | { readonly type: 'reset'; readonly what: 'E' | 'd' | 'all' | { readonly param: string } }
  | { readonly type: 'link'; readonly hash: string }
  | { readonly type: 'dismiss' };

export type Dispatch = (action: Action) => void;
