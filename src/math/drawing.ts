/** Door: what of a shape is drawn, and its extent. */

export type { Box, Heights } from './shapes/body.ts';
export { capsOf } from './shapes/caps.ts';
export type { Drawing, Figure, Grip, Patch, PatchEnd, Stage } from './shapes/drawing.ts';
export { multiplesWithin, roundStep } from './shapes/steps.ts';
