import { provideExamples } from '../../../src/state/example.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';

/* The page loads its examples after the first frame; a test that speaks of them has them now. */
provideExamples(GALLERY);
