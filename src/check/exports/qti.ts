import { type Part, plainNumber } from './parts.ts';
import { xmlText } from './xml.ts';

/* QTI 2.1 (imsglobal.org): an item a part, and the manifest of the package. */

const SPACE = 'http://www.imsglobal.org/xsd/imsqti_v2p1';

const paragraphs = (text: string): string =>
  text
    .split('\n')
    .map((line) => `<p>${xmlText(line)}</p>`)
    .join('');

const tolerance = (x: number): number => 5e-4 * (x === 0 ? 1 : Math.abs(x));

const value = (type: string, x: string): string =>
  `<baseValue baseType="${type}">${xmlText(x)}</baseValue>`;

/** The condition that the response is this answer. */
function equals(x: number | string): string {
  const variable = '<variable identifier="RESPONSE"/>';
  if (typeof x === 'string') return `<match>${variable}${value('identifier', x)}</match>`;
  const t = plainNumber(tolerance(x));
  return (
    `<equal toleranceMode="absolute" tolerance="${t} ${t}">${variable}` +
    `${value('float', plainNumber(x))}</equal>`
  );
}

const set = (identifier: string, type: string, x: string): string =>
  `<setOutcomeValue identifier="${identifier}">${value(type, x)}</setOutcomeValue>`;

const identifier = (id: string): string => `m-${id.replace(/[^\w-]/g, '-')}`;

/** One part as an assessmentItem. */
function qtiItem(part: Part): string {
  const { answer, options, wrong } = part;
  const isNumber = typeof answer === 'number';
  const type = isNumber ? 'float' : 'identifier';
  const right = isNumber ? plainNumber(answer) : answer;
  const known = isNumber
    ? wrong
    : wrong.filter((one) => options.some(({ id }) => id === one.answer));
  const interaction = isNumber
    ? '<p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="12"/></p>'
    : `<choiceInteraction responseIdentifier="RESPONSE" shuffle="true" maxChoices="1">${options
        .map(
          ({ id, title }) =>
            `<simpleChoice identifier="${xmlText(id)}">${xmlText(title)}</simpleChoice>`,
        )
        .join('')}</choiceInteraction>`;
  const branches = known.map(
    (one) =>
      `      <responseElseIf>${equals(one.answer)}` +
      `${set('SCORE', 'float', '0')}${set('FEEDBACK', 'identifier', identifier(one.id))}` +
      '</responseElseIf>',
  );
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<assessmentItem xmlns="${SPACE}" identifier="${part.id}" title="${xmlText(part.title)}"`,
    '    adaptive="false" timeDependent="false">',
    `  <responseDeclaration identifier="RESPONSE" cardinality="single" baseType="${type}">`,
    `    <correctResponse><value>${xmlText(right)}</value></correctResponse>`,
    '  </responseDeclaration>',
    '  <outcomeDeclaration identifier="SCORE" cardinality="single" baseType="float">',
    '    <defaultValue><value>0</value></defaultValue>',
    '  </outcomeDeclaration>',
    '  <outcomeDeclaration identifier="FEEDBACK" cardinality="single" baseType="identifier"/>',
    `  <itemBody><div>${paragraphs(part.prompt)}</div>`,
    isNumber ? `<div>${interaction}</div>` : interaction,
    '  </itemBody>',
    '  <responseProcessing>',
    '    <responseCondition>',
    `      <responseIf>${equals(answer)}${set('SCORE', 'float', '1')}` +
      `${set('FEEDBACK', 'identifier', 'right')}</responseIf>`,
    ...branches,
    '    </responseCondition>',
    '  </responseProcessing>',
    ...known.map(
      ({ id, says }) =>
        `  <modalFeedback outcomeIdentifier="FEEDBACK" identifier="${identifier(id)}" ` +
        `showHide="show">${paragraphs(says)}</modalFeedback>`,
    ),
    '</assessmentItem>',
    '',
  ].join('\n');
}

/** The files of a QTI 2.1 package, by name. */
export function qtiFiles(parts: readonly Part[]): Record<string, string> {
  const resources = parts.map(
    ({ id }) =>
      `    <resource identifier="res-${id}" type="imsqti_item_xmlv2p1" href="${id}.xml">` +
      `<file href="${id}.xml"/></resource>`,
  );
  const manifest = [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<manifest xmlns="http://www.imsglobal.org/xsd/imscp_v1p1" identifier="graze-set">',
    '  <metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>',
    '  <organizations/>',
    '  <resources>',
    ...resources,
    '  </resources>',
    '</manifest>',
    '',
  ].join('\n');
  const items = parts.map((part) => [`${part.id}.xml`, qtiItem(part)] as const);
  return { 'imsmanifest.xml': manifest, ...Object.fromEntries(items) };
}
