import { definitionOf } from '../math/shapes.ts';
import { isGlass, isLit, whyNoShadow } from './facts.ts';
import type { Scene, Thing } from './types.ts';

/** Whether what is left out would be seen in a scene. */
export type Shows = 'yes' | 'perhaps' | 'no';

/** Something in nature that pictures leave out or simplify; the page and docs/FAKED.md list it. */
interface Simplification {
  readonly title: string;
  /** Whether it is left out or simplified. */
  readonly how: 'left out' | 'simplified';
  /** What is done instead. */
  readonly reason: string;
  /** The file that does it. */
  readonly file: string;
  shows(scene: Scene): Shows;
}

const yesIf = (shows: boolean): Shows => (shows ? 'yes' : 'no');
const perhapsIf = (may: boolean): Shows => (may ? 'perhaps' : 'no');
const isMatt = ({ material }: Thing): boolean => !material.glass && material.mirror < 1;
const isMirror = ({ material }: Thing): boolean => material.mirror > 0;
const hasGlass = ({ things }: Scene): boolean => things.some(isGlass);
const bends = ({ things }: Scene): boolean =>
  things.some(({ material }) => (material.glass?.index ?? 1) > 1);
const hasLamp = ({ lights }: Scene): boolean => lights.some(({ light }) => light === 'sphere');
/** A whole convex thing gets no light from itself. */
const isHollow = ({ shape, between }: Thing): boolean =>
  between !== undefined || !definitionOf(shape).body().convex(shape);

export const SIMPLIFICATIONS: readonly Simplification[] = [
  {
    title: 'light from other surfaces',
    how: 'left out',
    reason: 'a constant stands in for it',
    file: 'src/scene/types.ts',
    shows: ({ things }) =>
      yesIf(things.some(isMatt) && (things.length > 1 || things.some(isHollow))),
  },
  {
    title: 'light from the background',
    how: 'left out',
    reason: 'what is seen behind things lights none of them: the same constant stands in for it',
    file: 'src/tracer/shade.ts',
    shows: ({ things }) => yesIf(things.some(isMatt)),
  },
  {
    title: 'caustics, shadows of clear glass',
    how: 'left out',
    reason: 'light goes straight through glass on its way to what it lights, and off no mirror',
    file: 'src/scene/facts.ts',
    shows: (scene) =>
      yesIf(
        scene.lights.length > 0 &&
          scene.things.some(isLit) &&
          scene.things.some((thing) => isGlass(thing) || isMirror(thing)),
      ),
  },
  {
    title: 'dispersion',
    how: 'simplified',
    reason:
      'glass has one index, or where it asks for it three: red, green and blue part, and no ' +
      'colours between them',
    file: 'src/scene/effects/dispersion-body.ts',
    shows: (scene) => yesIf(bends(scene)),
  },
  {
    title: 'polarisation',
    how: 'left out',
    reason: 'what glass mirrors is the mean of both directions',
    file: 'src/scene/optics.ts',
    shows: (scene) => yesIf(bends(scene)),
  },
  {
    title: 'waves',
    how: 'left out',
    reason: 'light goes in rays: no diffraction, no colours of thin films',
    file: 'src/tracer/wave.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
  {
    title: 'air',
    how: 'left out',
    reason: 'around things is nothing that dims, scatters or bends light',
    file: 'src/tracer/medium.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
  {
    title: 'spectra',
    how: 'simplified',
    reason: 'a colour is three numbers: red, green and blue',
    file: 'src/tracer/colour.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
  {
    title: 'more light than white',
    how: 'simplified',
    reason: 'a colour that is brighter than white is cut off at 1',
    file: 'src/tracer/colour.ts',
    shows: ({ ambient, lights, things }) =>
      perhapsIf(
        things.some(isLit) && ambient + lights.reduce((sum, { strength }) => sum + strength, 0) > 1,
      ),
  },
  {
    title: 'lamps themselves',
    how: 'left out',
    reason: 'a lamp lights, and is neither seen nor mirrored, but for its highlights',
    file: 'src/tracer/nearest.ts',
    shows: (scene) => perhapsIf(hasLamp(scene)),
  },
  {
    title: 'lamps with a size',
    how: 'simplified',
    reason:
      'their light comes from so many points of the disc that is seen of them; highlights, ' +
      'fall-off and what coloured glass leaves are those of the middle',
    file: 'src/scene/effects/soft-shadow-body.ts',
    shows: (scene) => yesIf(hasLamp(scene) && scene.things.some(isLit)),
  },
  {
    title: 'lights without a size',
    how: 'simplified',
    reason: 'shadows of a point and of a sun are sharp: in nature each light has a size',
    file: 'src/scene/effects/shadow-body.ts',
    shows: (scene) =>
      yesIf(scene.lights.some(({ light }) => light !== 'sphere') && whyNoShadow(scene) === null),
  },
  {
    title: 'mirrors',
    how: 'simplified',
    reason: 'they mirror the same share at each angle, and of each colour',
    file: 'src/scene/effects/reflection-body.ts',
    shows: ({ things }) =>
      yesIf(things.some(({ material: { mirror } }) => mirror > 0 && mirror < 1)),
  },
  {
    title: 'light below surfaces',
    how: 'left out',
    reason: 'what a matt surface takes up leaves it at the same point, or not at all',
    file: 'src/tracer/shade.ts',
    shows: ({ things }) => perhapsIf(things.some(isMatt)),
  },
  {
    title: 'rough surfaces',
    how: 'simplified',
    reason: 'matt ones are Lambert’s, highlights are Phong’s, mirrors and glass are smooth',
    file: 'src/scene/effects/highlights-body.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
  {
    title: 'glass in glass',
    how: 'simplified',
    reason: 'around glass there is always air, also where two of them touch',
    file: 'src/scene/effects/refraction-body.ts',
    shows: ({ things }) => perhapsIf(things.filter(isGlass).length > 1),
  },
  {
    title: 'highlights on glass',
    how: 'simplified',
    reason: 'the share that they take does not go through',
    file: 'src/scene/effects/refraction-body.ts',
    shows: ({ things, lights }) =>
      yesIf(
        lights.length > 0 &&
          things.some((thing) => isGlass(thing) && thing.material.shine.strength > 0),
      ),
  },
  {
    title: 'weak rays',
    how: 'left out',
    reason:
      'one that can bring no more than half a level of 255 is not fired: a bound for one ray, ' +
      'not for their sum',
    file: 'src/tracer/weight.ts',
    shows: (scene) => perhapsIf(hasGlass(scene) || scene.things.some(isMirror)),
  },
  {
    title: 'endless reflections',
    how: 'left out',
    reason: 'rays go on for at most 64 bounces',
    file: 'src/tracer/weight.ts',
    shows: (scene) => perhapsIf(hasGlass(scene) || scene.things.some(isMirror)),
  },
  {
    title: 'between the rays',
    how: 'simplified',
    reason: 'a pixel is the mean of its rays: of one, unless more are asked for or it rests',
    file: 'src/tracer/prepare.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
  {
    title: 'a lens',
    how: 'simplified',
    reason: 'the camera is a pinhole: all is sharp, and nothing moves',
    file: 'src/scene/types.ts',
    shows: ({ things }) => perhapsIf(things.length > 0),
  },
];
