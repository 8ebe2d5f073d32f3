/* What Explore has beyond its first frame, which does not wait for it. */

export { announcement } from './announce.ts';
export { closerLook } from './closer-look.ts';
export { GALLERY } from './gallery/index.ts';
