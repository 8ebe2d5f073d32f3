/** A map that is ready to be opened, with one sentence on what it shows. */
interface ReadyMap {
  readonly id: string;
  readonly title: string;
  readonly sentence: string;
  /** What makes the sentence true; tests/unit/lesson/map-claims.ts judges each. */
  readonly claims: readonly string[];
  readonly link: string;
}

/** In the order of the lesson about them. */
export const READY_MAPS: readonly ReadyMap[] = [
  {
    id: 'torn-edge',
    title: 'the torn edge',
    sentence: 'One pixel is one double here, and the line D = 0 is a torn edge for textbook.',
    claims: ['a pixel is 1 double', 'map 1 wrong', 'map 1 along D = 0', 'map 1 tears D'],
    link:
      '#/accuracy?shape=cylinder&E=5,0,1&d=-1,0,0&C=0,0,0&r=1&method=textbook' +
      '&atlas=E.z,r&zoom=13&by=ulps',
  },
  {
    id: 'from-far-away',
    title: 'from far away',
    sentence:
      'From 10⁸ away textbook is wrong in a band along D = 0, and moment, which forms D in ' +
      'another way, in no pixel.',
    claims: ['E beyond 1e8', 'map 1 wrong', 'map 1 along D = 0', 'map 2 right everywhere'],
    link:
      '#/accuracy?shape=cylinder&E=100000001,1,1&d=-1,0,0&C=0,1,0&r=1&method=textbook' +
      '&atlas=E.z,r&maps=textbook,moment',
  },
  {
    id: 'half-the-bits',
    title: 'half the bits',
    sentence:
      'Where float32 is wrong along D = 0, textbook, the same formula with twice the bits, is ' +
      'right in every pixel.',
    claims: ['map 1 wrong', 'map 1 along D = 0', 'map 2 right everywhere'],
    link:
      '#/accuracy?shape=cone&E=200,1.1,0.7&d=-1,0,0.001&V=0,3,0&c=0.47&method=textbook' +
      '&atlas=E.z,c&zoom=3&maps=textbook32,textbook',
  },
  {
    id: 'beside-a-generator',
    title: 'beside a generator',
    sentence:
      'Beside a generator’s direction A tears for textbook; interval is never wrong, and cannot ' +
      'tell instead.',
    claims: [
      ...['a pixel is 1 double', 'map 1 wrong', 'map 1 along A = 0', 'map 1 tears A'],
      ...['map 2 never wrong', 'map 2 cannot tell somewhere'],
    ],
    link:
      '#/accuracy?shape=cone&E=1,2,3&d=0.06,1,0.08&V=0,0,0&c=0.1&method=textbook' +
      '&atlas=d.x,d.z&zoom=13&by=ulps&maps=textbook,interval',
  },
  {
    id: 'the-rim',
    title: 'the rim',
    sentence: 'At the rim of a circle textbook sees hits that are not there, and exact none.',
    claims: ['map 1 only invents', 'map 1 along rim', 'map 1 tears rim', 'map 2 right everywhere'],
    link:
      '#/accuracy?shape=circle&E=3,1,2&d=-1,0,0&N=1,0.5,0&C=0,1,0&r=2&method=textbook' +
      '&atlas=E.z,E.y&zoom=13&by=ulps&maps=textbook,exact',
  },
  {
    id: 'leaving-a-surface',
    title: 'leaving a surface',
    sentence:
      'Without a start rule many rays that leave the cone meet it again where they start, and ' +
      'with it none does.',
    claims: ['map 1 only invents', 'map 1 wrong in a tenth', 'map 2 right everywhere'],
    link:
      '#/accuracy?shape=cone&E=3,1,1&d=-0.8,-0.2,-0.3&V=0,3,0&c=0.5&method=textbook' +
      '&atlas=E.z,E.y&start=none,from',
  },
];
