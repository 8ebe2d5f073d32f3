import type { Course } from './course.ts';
import { manifest12, manifest2004, tincan } from './package.ts';
import { SCORM_12, SCORM_2004, type ScormVersion } from './scorm.ts';

/** A way in which a page speaks with a course system, and the package that it comes in. */
export interface CourseSystem {
  readonly id: string;
  readonly title: string;
  /** What the system is called in sentences. */
  readonly name: string;
  /** The run-time that it looks for; null if it is launched with an address for statements. */
  readonly scorm: ScormVersion | null;
  readonly manifest: { readonly name: string; readonly write: (course: Course) => string };
  /** For whoever makes the package. */
  readonly says: string;
}

const TOLD =
  'The course system gets the score, how many questions are done, passed or failed, the time, ' +
  'each answer that is checked with what was right, and a hand-in code, from which the page goes ' +
  'on where it was left.';

export const COURSE_SYSTEMS: readonly CourseSystem[] = [
  {
    id: 'scorm12',
    title: 'SCORM 1.2',
    name: 'SCORM 1.2',
    scorm: SCORM_12,
    manifest: { name: 'imsmanifest.xml', write: manifest12 },
    says: `Graze as one page with this set, and its manifest, in a zip. ${TOLD}`,
  },
  {
    id: 'scorm2004',
    title: 'SCORM 2004',
    name: 'SCORM 2004',
    scorm: SCORM_2004,
    manifest: { name: 'imsmanifest.xml', write: manifest2004 },
    says:
      'The same for newer systems (3rd edition, also read by those of the 4th): answers have the ' +
      'topic, the try and the mistakes that were named beside them.',
  },
  {
    id: 'xapi',
    title: 'xAPI',
    name: 'the record store',
    scorm: null,
    manifest: { name: 'tincan.xml', write: tincan },
    says:
      'The same page with a tincan.xml, for systems that launch it with the address of a ' +
      'learning record store: it sends statements there (answered, completed, passed or ' +
      'failed), under the name that it was launched with, and keeps its hand-in code there. The ' +
      'set is named by the link above.',
  },
];
