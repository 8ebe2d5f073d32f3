/** Something in nature that pictures leave out or simplify; the page and docs/FAKED.md list it. */
interface Simplification {
  readonly title: string;
  /** Whether it is left out or simplified. */
  readonly how: 'left out' | 'simplified';
  /** What is done instead. */
  readonly reason: string;
  /** The file that does it. */
  readonly file: string;
}

export const SIMPLIFICATIONS: readonly Simplification[] = [
  {
    title: 'light from other surfaces',
    how: 'left out',
    reason: 'a constant stands in for it',
    file: 'src/scene/types.ts',
  },
  {
    title: 'shadows of glass, caustics',
    how: 'left out',
    reason: 'light goes through glass on its way to what it lights, straight and undimmed',
    file: 'src/scene/facts.ts',
  },
  {
    title: 'fall-off with distance',
    how: 'left out',
    reason: 'a light is as strong far away as near',
    file: 'src/scene/types.ts',
  },
  {
    title: 'dispersion',
    how: 'left out',
    reason: 'glass has one index for all colours',
    file: 'src/scene/types.ts',
  },
  {
    title: 'polarisation',
    how: 'left out',
    reason: 'what glass mirrors is the mean of both directions',
    file: 'src/scene/optics.ts',
  },
  {
    title: 'spectra',
    how: 'simplified',
    reason: 'a colour is three numbers: red, green and blue',
    file: 'src/tracer/colour.ts',
  },
  {
    title: 'rough surfaces',
    how: 'simplified',
    reason: 'matt ones are Lambert’s, highlights are Phong’s, mirrors and glass are smooth',
    file: 'src/scene/effects/highlights-body.ts',
  },
  {
    title: 'glass in glass',
    how: 'simplified',
    reason: 'around glass there is always air, also where two of them touch',
    file: 'src/scene/effects/refraction-body.ts',
  },
  {
    title: 'highlights on glass',
    how: 'simplified',
    reason: 'the share that they take does not go through',
    file: 'src/scene/effects/refraction-body.ts',
  },
  {
    title: 'weak rays',
    how: 'left out',
    reason:
      'one that can bring no more than half a level of 255 is not fired: a bound for one ray, ' +
      'not for their sum',
    file: 'src/tracer/weight.ts',
  },
  {
    title: 'endless reflections',
    how: 'left out',
    reason: 'rays go on for at most 64 bounces',
    file: 'src/tracer/weight.ts',
  },
  {
    title: 'a lens',
    how: 'simplified',
    reason: 'the camera is a pinhole: all is sharp, and nothing moves',
    file: 'src/scene/types.ts',
  },
];
