import { xmlText } from '../../check/exports/xml.ts';
import { setName } from '../../check/sets.ts';
import { COURSE_ELEMENT, type Course } from './course.ts';

/* Packages for course systems: the page as one file with a set in it, and a manifest. */

/** An identifier of XML for a text: letters and digits. */
function idFor(text: string): string {
  let [a, b] = [0x811c9dc5, 0x2545f491];
  for (const c of text) {
    a = Math.imul(a ^ (c.codePointAt(0) ?? 0), 0x01000193);
    b = Math.imul(b ^ (a >>> 13), 0x85ebca6b);
  }
  return `graze-${(a >>> 0).toString(36)}${(b >>> 0).toString(36)}`;
}

const titleOf = ({ set, seed }: Course): string => `Graze: ${setName(set)}, seed ${seed}`;

interface ManifestFormat {
  readonly namespace: string;
  readonly adlcp: string;
  readonly version: string;
  /** Attribute that says that the page speaks with the course system. */
  readonly type: string;
}

const manifest =
  ({ namespace, adlcp, version, type }: ManifestFormat) =>
  (course: Course): string => {
    const id = idFor(JSON.stringify([course.set, course.seed, version]));
    const title = xmlText(titleOf(course));
    return [
      '<?xml version="1.0" encoding="UTF-8"?>',
      `<manifest identifier="${id}" version="1.0" xmlns="${namespace}"`,
      `    xmlns:adlcp="${adlcp}">`,
      '  <metadata>',
      '    <schema>ADL SCORM</schema>',
      `    <schemaversion>${version}</schemaversion>`,
      '  </metadata>',
      `  <organizations default="${id}-set">`,
      `    <organization identifier="${id}-set">`,
      `      <title>${title}</title>`,
      `      <item identifier="${id}-item" identifierref="${id}-page" isvisible="true">`,
      `        <title>${title}</title>`,
      '      </item>',
      '    </organization>',
      '  </organizations>',
      '  <resources>',
      `    <resource identifier="${id}-page" type="webcontent" adlcp:${type}="sco"`,
      '        href="index.html">',
      '      <file href="index.html"/>',
      '    </resource>',
      '  </resources>',
      '</manifest>',
      '',
    ].join('\n');
  };

/** imsmanifest.xml of SCORM 1.2. */
export const manifest12 = manifest({
  namespace: 'http://www.imsproject.org/xsd/imscp_rootv1p1p2',
  adlcp: 'http://www.adlnet.org/xsd/adlcp_rootv1p2',
  version: '1.2',
  type: 'scormtype',
});

/** imsmanifest.xml of SCORM 2004, 3rd edition. */
export const manifest2004 = manifest({
  namespace: 'http://www.imsglobal.org/xsd/imscp_v1p1',
  adlcp: 'http://www.adlnet.org/xsd/adlcp_v1p3',
  version: '2004 3rd Edition',
  type: 'scormType',
});

/** tincan.xml, which describes how a page that sends xAPI statements is launched. */
export function tincan(course: Course): string {
  const title = xmlText(titleOf(course));
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<tincan xmlns="http://projecttincan.com/tincan.xsd">',
    '  <activities>',
    `    <activity id="${xmlText(course.activity)}"`,
    '        type="http://adlnet.gov/expapi/activities/assessment">',
    `      <name>${title}</name>`,
    `      <description lang="en">${title}</description>`,
    '      <launch lang="en">index.html</launch>',
    '    </activity>',
    '  </activities>',
    '</tincan>',
    '',
  ].join('\n');
}

/** Text within a script element: no end of it, no comment. */
const inScript = (value: unknown): string => JSON.stringify(value).replaceAll('<', '\\u003c');

/**
 * The page with a course in it. A link that is given counts; without one it opens the set.
 *
 * @param page the one file
 * @param hash of the set's questions
 * @throws RangeError if the page is none that a course fits into.
 */
export function pageWithCourse(page: string, course: Course, hash: string): string {
  const at = page.search(/<script\b/);
  if (at < 0 || !page.includes('</head>')) throw new RangeError('it is not the page of one file');
  const said =
    `<script type="application/json" id="${COURSE_ELEMENT}">${inScript(course)}</script>\n    ` +
    `<script>location.hash||location.replace(${inScript(hash)})</script>\n    `;
  return `${page.slice(0, at)}${said}${page.slice(at)}`;
}
