import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import { afterAll, describe, expect, test } from 'vitest';
import { gift } from '../../../src/check/exports/gift.ts';
import { moodleXml } from '../../../src/check/exports/moodle.ts';
import { type Part, partsOfSet } from '../../../src/check/exports/parts.ts';
import { qtiFiles } from '../../../src/check/exports/qti.ts';
import { isForStack, stackFormulas, stackXml } from '../../../src/check/exports/stack.ts';
import { SETS } from '../../../src/check/sets.ts';
import { zipOf } from '../../../src/state/zip.ts';

const NEWEST = Object.keys(SETS).at(-1) ?? '';
const PARTS = partsOfSet(41, NEWEST);
const MORE = [1, 2, 3].flatMap((seed) =>
  partsOfSet(seed, 'roots*2,coefficients,discriminant;shapes=cone,hyperboloid,sphere'),
);
const STRANGE = 'a<b> & "c" ~ = # { } : \\ ]]> $course$ é−√\u{1d465}\nnext';
const strange = (part: Part): Part => ({
  ...part,
  title: STRANGE.replace('\n', ' '),
  prompt: STRANGE,
  options: part.options.map(({ id, title }) => ({
    id,
    title: `${title} ${STRANGE.split('\n')[0]}`,
  })),
});
const ODD = PARTS.slice(0, 4).map(strange);

const folder = mkdtempSync(join(tmpdir(), 'graze-course-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** What a program in Python, which knows nothing of Graze, reads in a file. */
function python(program: string, files: Readonly<Record<string, string>>): unknown {
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  const out = execFileSync('python3', ['-c', program, folder], { encoding: 'utf8' });
  return JSON.parse(out);
}

interface Read {
  readonly title: string;
  readonly prompt: string;
  /** Value, fraction, tolerance, feedback. */
  readonly answers: readonly (readonly [string, number, number, string])[];
}

const toleranceOf = (x: number | string): number =>
  typeof x === 'number' ? 5e-4 * (x === 0 ? 1 : Math.abs(x)) : 0;

/** What the part says, in the form of a reader. */
function said({ title, prompt, answer, wrong, options }: Part): Read {
  const choices = options.map(({ id, title: words }): Read['answers'][number] => [
    words,
    id === answer ? 100 : 0,
    0,
    wrong.find((one) => one.answer === id)?.says ?? '',
  ]);
  const numbers = [{ answer, says: '' }, ...wrong].map(
    ({ answer: x, says }, i): Read['answers'][number] => [
      String(x),
      i === 0 ? 100 : 0,
      toleranceOf(x),
      says,
    ],
  );
  return { title, prompt, answers: typeof answer === 'number' ? numbers : choices };
}

const MOODLE = `
import html, json, re, sys, xml.etree.ElementTree as E
root = E.parse(sys.argv[1] + '/set.xml').getroot()
def words(node):
    found = node.find('text').text if node is not None else ''
    if node is None or node.get('format') != 'html' or not found: return found or ''
    inner = E.fromstring('<d>' + found + '</d>')
    return '\\n'.join(p.text or '' for p in inner)
def read(q):
    return {'title': q.find('name/text').text, 'prompt': words(q.find('questiontext')),
      'answers': [[a.find('text').text, float(a.get('fraction')),
        float(a.findtext('tolerance') or 0), words(a.find('feedback'))]
        for a in q.findall('answer')]}
print(json.dumps([read(q) for q in root if q.get('type') in ('numerical', 'multichoice')]))
`;

describe('Moodle XML', () => {
  test.each([
    ['the newest set', PARTS],
    ['special characters', ODD],
  ])('%s is read again by another program', (_, parts) => {
    const read = python(MOODLE, { 'set.xml': moodleXml(parts, `Graze/${STRANGE}`) });
    const numbers = (one: Read) => ({
      ...one,
      answers: one.answers.map(([value, share, tolerance, says]) => [
        Number.isNaN(Number(value)) ? value : Number(value),
        share,
        Number(tolerance.toPrecision(12)),
        says,
      ]),
    });
    expect((read as Read[]).map(numbers)).toEqual(parts.map(said).map(numbers));
  });

  test('the right answer is accepted, and no mistake’s', () => {
    for (const { answer, tolerance, wrong } of [...PARTS, ...MORE]) {
      for (const { answer: other } of wrong) {
        if (typeof answer !== 'number' || typeof other !== 'number') expect(other).not.toBe(answer);
        else expect(Math.abs(answer - other)).toBeGreaterThan(tolerance);
      }
    }
    expect(PARTS.some(({ wrong }) => wrong.length > 2)).toBe(true);
  });
});

/** A reader of GIFT that follows Moodle's description of the format. */
function readGift(text: string): Read[] {
  const unescaped = (words: string): string =>
    words.replace(/\\([\\~=#{}:n])/g, (_, c) => (c === 'n' ? '\n' : c));
  return text.split(/\n\n/).map((question) => {
    const [, title = '', prompt = '', mark = '', body = ''] =
      /^::((?:\\.|[^:\\])*)::\[plain\]((?:\\.|[^{\\])*) \{(#?)([\s\S]*)\}\n?$/.exec(question) ?? [];
    const [all = ''] = body.split('\n  ####');
    const answers = all
      .split('\n')
      .filter((line) => line.trim() !== '')
      .map((line): Read['answers'][number] => {
        const [, sign = '', rest = ''] = /^ {2}([=~])(.*)$/.exec(line) ?? [];
        const [, value = '', says = ''] = /^((?:\\.|[^#\\])*)#?(.*)$/.exec(rest) ?? [];
        const number = /^%(\d+)%([^:]+):(.+)$/.exec(value);
        return mark === '#'
          ? [number?.[2] ?? '', Number(number?.[1]), Number(number?.[3]), unescaped(says)]
          : [unescaped(value), sign === '=' ? 100 : 0, 0, unescaped(says)];
      });
    return { title: unescaped(title), prompt: unescaped(prompt), answers };
  });
}

describe('GIFT', () => {
  test.each([
    ['the newest set', PARTS],
    ['special characters', ODD],
  ])('%s is read again', (_, parts) => {
    expect(readGift(gift(parts))).toEqual(parts.map(said));
  });
});

/** Reads the package and processes responses as QTI 2.1 says, for each answer. */
const QTI = `
import json, sys, xml.etree.ElementTree as E
Q = '{http://www.imsglobal.org/xsd/imsqti_v2p1}'; P = '{http://www.imsglobal.org/xsd/imscp_v1p1}'
at = sys.argv[1] + '/'
manifest = E.parse(at + 'imsmanifest.xml').getroot()
files = [r.get('href') for r in manifest.iter(P + 'resource')]
asked = json.load(open(at + 'asked.json'))
def holds(e, response):
    base = e.find(Q + 'baseValue')
    if e.tag == Q + 'match': return response == base.text
    low, high = map(float, e.get('tolerance').split())
    return float(base.text) - low <= float(response) <= float(base.text) + high
def process(item, response):
    out = {'SCORE': '0', 'FEEDBACK': None}
    for branch in item.find(Q + 'responseProcessing/' + Q + 'responseCondition'):
        if holds(branch[0], response):
            for s in branch[1:]: out[s.get('identifier')] = s[0].text
            break
    shown = [f for f in item.findall(Q + 'modalFeedback') if f.get('identifier') == out['FEEDBACK']]
    return [float(out['SCORE']), '\\n'.join(p.text or '' for f in shown for p in f)]
result = []
for name, responses in zip(files, asked):
    item = E.parse(at + name).getroot()
    prompt = '\\n'.join(p.text or '' for p in item.find(Q + 'itemBody/' + Q + 'div'))
    right = item.find(Q + 'responseDeclaration/' + Q + 'correctResponse/' + Q + 'value').text
    told = (Q + 'simpleChoice', Q + 'modalFeedback')
    ids = [e.get('identifier') for e in item.iter() if e.tag in told]
    result.append({'title': item.get('title'), 'prompt': prompt, 'right': right,
      'unique': len(ids) == len(set(ids)), 'marked': [process(item, r) for r in responses]})
print(json.dumps(result))
`;

describe('QTI 2.1', () => {
  test.each([
    ['the newest set', PARTS],
    ['special characters', ODD],
  ])('%s comes out of its package and marks as told', (_, parts) => {
    const files = qtiFiles(parts);
    const unzipped = unzipSync(zipOf(files));
    const read = Object.fromEntries(
      Object.entries(unzipped).map(([name, bytes]) => [name, new TextDecoder().decode(bytes)]),
    );
    expect(read).toEqual(files);
    const known = (part: Part) =>
      part.wrong.filter(
        ({ answer }) => typeof answer === 'number' || part.options.some(({ id }) => id === answer),
      );
    const asked = parts.map((part) =>
      [part.answer, ...known(part).map(({ answer }) => answer)].map(String),
    );
    const found = python(QTI, { ...read, 'asked.json': JSON.stringify(asked) });
    expect(found).toEqual(
      parts.map((part) => ({
        title: part.title,
        prompt: part.prompt,
        right: String(part.answer),
        unique: true,
        marked: [[1, ''], ...known(part).map(({ says }) => [0, says])],
      })),
    );
  });
});

/** Evaluates the statements of Maxima that the export uses, in doubles. */
function maxima(variables: string, expression: string): number {
  const js = (text: string): string =>
    text
      .replace(/\b(v\w+|r\w*)\[(\d)\]/g, (_, name, i) => `${name}[${Number(i) - 1}]`)
      .replace(/\bsqrt\(/g, 'Math.sqrt(')
      .replace(/\bsort\(/g, 'sorted(')
      .replace(/\breverse\(/g, 'reversed(');
  const statements = variables.split('\n').map((line) => {
    const [, name, value] = /^(\w+): (.*);$/.exec(line) ?? [];
    return `const ${name} = ${js(value ?? '')};`;
  });
  const run = new Function(
    'sorted',
    'reversed',
    `${statements.join('\n')}\nreturn ${js(expression)};`,
  );
  return run(
    (all: number[]) => [...all].sort((a, b) => a - b),
    (all: number[]) => [...all].reverse(),
  );
}

describe('STACK', () => {
  const parts = [...PARTS, ...MORE].filter(isForStack);

  test('every node is a formula that gives its answer', () => {
    expect(parts.length).toBeGreaterThan(12);
    for (const part of parts) {
      const { variables, nodes } = stackFormulas(part);
      const [right, ...others] = nodes.map(({ answer }) => maxima(variables, answer));
      expect(right, part.title).toBeCloseTo(part.answer as number, 9);
      expect(others, `${part.title}\n${variables}`).toHaveLength(part.wrong.length);
      part.wrong.forEach(({ answer, id }, i) => {
        const near = Math.abs((others[i] ?? Number.NaN) - (answer as number));
        expect(near, `${part.title} ${id}\n${variables}`).toBeLessThan(
          1e-9 * (1 + Math.abs(answer as number)),
        );
      });
    }
  });

  test('the file is well-formed, and its nodes lead on to one another', () => {
    const program = `
import json, sys, xml.etree.ElementTree as E
root = E.parse(sys.argv[1] + '/stack.xml').getroot()
def read(q):
    nodes = q.findall('prt/node')
    return [q.find('name/text').text, [n.findtext('name') for n in nodes],
      [n.findtext('falsenextnode') for n in nodes], [n.findtext('tans') for n in nodes]]
print(json.dumps([read(q) for q in root if q.get('type') == 'stack']))`;
    const odd = parts.slice(0, 3).map(strange);
    const read = python(program, { 'stack.xml': stackXml(odd, 'x') }) as [
      string,
      string[],
      string[],
      string[],
    ][];
    expect(read.map(([title]) => title)).toEqual(odd.map(({ title }) => title));
    for (const [, names, next, answers] of read) {
      expect(names).toEqual(names.map((_, i) => String(i)));
      expect(next).toEqual(names.map((_, i) => (i + 1 < names.length ? String(i + 1) : '-1')));
      expect(new Set(answers).size).toBe(answers.length);
    }
  });
});
