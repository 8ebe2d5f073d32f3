import { execFileSync } from 'node:child_process';
import fc from 'fast-check';
import { Scorm12API, Scorm2004API } from 'scorm-again';
import { describe, expect, test } from 'vitest';
import { derivationFor } from '../../../src/check/compose.ts';
import { judge } from '../../../src/check/judge.ts';
import {
  type Progress,
  solutionShown,
  started,
  tried,
  typed,
} from '../../../src/check/progress.ts';
import { plan, question } from '../../../src/check/session.ts';
import type { Answer, Field } from '../../../src/check/types.ts';
import { findApi } from '../../../src/pages/check/scorm-window.ts';
import {
  type Answered,
  answeredOf,
  type Connection,
  type Course,
  courseReport,
  type Environment,
  readCourse,
} from '../../../src/state/course/course.ts';
import { pageWithCourse } from '../../../src/state/course/package.ts';
import { connectScorm, type ScormApi, type ScormVersion } from '../../../src/state/course/scorm.ts';
import { sessionStatements } from '../../../src/state/course/session-statements.ts';
import { COURSE_SYSTEMS } from '../../../src/state/course/systems.ts';
import {
  accountOf,
  connectXapi,
  type Request,
  readLaunch,
} from '../../../src/state/course/xapi.ts';
import { readHandIn } from '../../../src/state/hand-in.ts';
import { shortest } from '../../../src/text/format.ts';
import { many } from '../many.ts';

const SET = 'coefficients,roots,nappes.2,normal;shapes=cone;level=1';
const COURSE: Course = {
  ...{ system: 'scorm12', set: SET, seed: 41, own: false, pass: 50 },
  activity: 'https://course.example/#/check?set=roots&seed=41',
};

let ms = 0;
const AROUND: Environment = {
  now: () => ms,
  clock: () => '09:08:07',
  stamp: () => '2026-11-30T09:08:07.12Z',
  uuid: () => '00000000-0000-4000-8000-000000000000',
};

const written = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join(', ') : (answer ?? '');
};

const wrongFor = ({ kind, options }: Field): string => {
  if (kind === 'choice') return options.at(-1)?.id ?? '';
  return kind === 'number' ? '−23/6' : '1, 2, 3';
};

/** A question answered, rightly or not. */
function answer(
  progress: Progress,
  index: number,
  isRight: boolean,
): readonly [Progress, Answered | null] {
  const posed = question(progress.seed, index, progress.set);
  const filled = posed.fields.reduce(
    (now, field) =>
      typed(now, index, field.id, isRight ? written(posed.truth[field.id]) : wrongFor(field)),
    progress,
  );
  const judged = judge(derivationFor(posed), filled.asked[index]?.texts ?? {});
  const next = tried(filled, index, judged);
  return [next, answeredOf(posed, index, next, judged)];
}

const reportOf = (progress: Progress, most = 4096, handedIn = false) =>
  courseReport(COURSE, progress, { who: '', place: 2, handedIn, most });

interface System {
  readonly version: ScormVersion;
  readonly api: ScormApi;
  get(element: string): string;
  /** All that it holds, for a next visit. */
  kept(): Record<string, unknown>;
}

const versions = COURSE_SYSTEMS.flatMap(({ scorm }) => (scorm ? [scorm] : []));

/** An independent course system of this version. */
function systemOf(version: ScormVersion, kept: Record<string, unknown> = {}): System {
  const settings = { autocommit: false, logLevel: 5 };
  const is12 = version.api === 'API';
  const made = is12 ? new Scorm12API(settings) : new Scorm2004API(settings);
  made.loadFromJSON(kept, 'cmi');
  const api = made as unknown as ScormApi;
  const call = (name: string, ...given: string[]): string =>
    String((api[name] as (...all: string[]) => unknown).apply(api, given));
  return {
    ...{ version, api },
    get: (element) => call(version.names.get, element),
    kept: () => JSON.parse(JSON.stringify(made.cmi)),
  };
}

const connected = ({ version, api }: System): Connection => {
  const found = connectScorm(version, api, AROUND);
  if (typeof found === 'string') throw new Error(found);
  return found;
};

describe.each(versions)('$api', (version) => {
  const is12 = version.api === 'API';
  const status = (system: System): string[] =>
    is12
      ? [system.get('cmi.core.lesson_status')]
      : [system.get('cmi.completion_status'), system.get('cmi.success_status')];
  const score = (system: System): number =>
    Number(system.get(is12 ? 'cmi.core.score.raw' : 'cmi.score.raw'));

  test('a course system takes score, status and each answer', async () => {
    const system = systemOf(
      version,
      is12 ? { core: { student_id: 'ada' } } : { learner_id: 'ada' },
    );
    const connection = connected(system);
    expect(connection).toMatchObject({ learner: 'ada', state: '', complete: false });
    let progress = started(41, SET);
    const total = plan(41, SET).length;
    for (let i = 0; i < total; i++) {
      for (const isRight of [false, i < 3]) {
        const [next, answered] = answer(progress, i, isRight);
        progress = next;
        expect(await connection.send(reportOf(progress), answered)).toBe('');
        const { right } = reportOf(progress);
        expect(score(system)).toBeCloseTo((100 * right) / total, 2);
        const isDone = right === total;
        expect(status(system)[0]).toBe(isDone ? 'passed' : 'incomplete');
      }
    }
    expect(Number(system.get('cmi.interactions._count'))).toBe(2 * total);
    // 1.2 lets answers be written, and not read.
    const { interactions } = system.kept() as {
      interactions: Record<string, Record<string, string>>;
    };
    const last = Object.values(interactions).filter((x) => typeof x === 'object');
    expect(JSON.stringify(last)).toContain('−23/6');
    expect(await connection.send(reportOf(progress, 4000, true), null)).toBe('');
    expect(status(system)).toEqual(is12 ? ['passed'] : ['completed', 'passed']);
  });

  test('another visit goes on where the first was left', async () => {
    const first = systemOf(version);
    const connection = connected(first);
    const [one, answered] = answer(started(41, SET), 0, true);
    const progress = solutionShown(typed(one, 1, 't1', 'half typed'), 2);
    await connection.send(reportOf(one), answered);
    ms += 3_723_450;
    connection.end(reportOf(progress));
    const data = first.kept();
    const again = connected(systemOf(version, data));
    expect(again.place).toBe(2);
    const { asked, seed } = readHandIn(again.state);
    expect(seed).toBe(41);
    expect(asked[0]).toEqual(progress.asked[0]);
    expect(asked[1]?.texts).toEqual({ t1: 'half typed' });
    expect(asked[2]?.solutionShown).toBe(true);
  });

  test('what refuses, throws or is gone is said, and nothing more is asked of it', async () => {
    const report = reportOf(started(41, SET));
    const broken = { ...systemOf(version).api };
    for (const name of Object.values(version.names)) broken[name] = () => 'false';
    expect(connectScorm(version, broken, AROUND)).toContain('error false');
    expect(connectScorm(version, {}, AROUND)).toContain(version.names.start);
    const thrower = {
      [version.names.start]: () => {
        throw new Error('gone');
      },
    };
    expect(connectScorm(version, thrower, AROUND)).toBe('gone');
    const system = systemOf(version);
    const api: Record<string, unknown> = {};
    for (const name of Object.values(version.names)) {
      api[name] = (...given: string[]) =>
        (system.api[name] as (...all: string[]) => unknown).apply(system.api, given);
    }
    const connection = connectScorm(version, api, AROUND);
    if (typeof connection === 'string') throw new Error(connection);
    api[version.names.commit] = () => 'false';
    expect(await connection.send(report, null)).toMatch(/^error \d+/);
    api[version.names.set] = () => {
      throw new Error('the connection is lost');
    };
    expect(await connection.send(report, null)).toBe('the connection is lost');
    // An answer that was refused goes with the next report.
    const [progress, answered] = answer(started(41, SET), 0, true);
    await connection.send(reportOf(progress), answered);
    const taken: unknown[] = [];
    api[version.names.set] = (element: string) => {
      taken.push(element);
      return 'true';
    };
    api[version.names.commit] = () => 'true';
    expect(await connection.send(reportOf(progress), null)).toBe('');
    expect(taken).toContain('cmi.interactions.0.id');
    taken.length = 0;
    await connection.send(reportOf(progress), null);
    expect(taken.join()).not.toContain('interactions');
    connection.end(report);
    api[version.names.set] = () => {
      throw new Error('it was asked after its end');
    };
    expect(await connection.send(report, null)).toBe('');
  });

  test('who looks at what was done changes nothing', async () => {
    const system = systemOf(
      version,
      is12 ? { core: { lesson_mode: 'review' } } : { mode: 'review' },
    );
    const connection = connected(system);
    expect(connection.readOnly).toBe(true);
    await connection.send(reportOf(answer(started(41, SET), 0, true)[0]), null);
    expect(system.get('cmi.suspend_data')).toBe('');
  });
});

const page = (head: string): string => `<!doctype html><html><head>${head}</head></html>`;

test('a package is the page with the set in it, and a manifest that another reader finds', () => {
  const strange = { ...COURSE, activity: 'https://a.example/?x="<&é</script>#/check' };
  const text = pageWithCourse(page('<script type="module">let a;</script>'), strange, '#/check?a');
  const [, said] = /id="graze-course">(.*?)<\/script>/.exec(text) ?? [];
  expect(readCourse(said)).toEqual(strange);
  expect(text.indexOf('graze-course')).toBeLessThan(text.indexOf('module'));
  expect(() => pageWithCourse('Not found', COURSE, '')).toThrow(RangeError);
  for (const [name, bad] of [
    ['set', 'cube'],
    ['seed', '41'],
    ['activity', null],
  ] as const) {
    expect(readCourse(JSON.stringify({ ...COURSE, [name]: bad }))).toBeNull();
  }
  for (const bad of [null, '', '{', '[]', 'null']) expect(readCourse(bad)).toBeNull();
  // What the schemas ask (imscp_rootv1p1p2.xsd, imscp_v1p1.xsd, adlcp_*.xsd): names, their order,
  // unique identifiers of XML, references that are met.
  const program = `
import json, re, sys, xml.etree.ElementTree as E
def plain(name): return re.sub(r'^{.*}', '', name)
def walk(e): return [plain(e.tag), {plain(k): v for k, v in e.attrib.items()},
    (e.text or '').strip(), [walk(x) for x in e]]
print(json.dumps([[E.fromstring(t).tag, walk(E.fromstring(t))] for t in json.load(sys.stdin)]))`;
  const input = JSON.stringify(
    COURSE_SYSTEMS.map(({ manifest }) => manifest.write(strange).replace(/^<\?.*\?>/, '')),
  );
  const [of12, of2004, ofXapi] = JSON.parse(
    execFileSync('python3', ['-c', program], { input, encoding: 'utf8' }),
  );
  for (const [[tag, root], namespace, version, type] of [
    [of12, 'http://www.imsproject.org/xsd/imscp_rootv1p1p2', '1.2', 'scormtype'],
    [of2004, 'http://www.imsglobal.org/xsd/imscp_v1p1', '2004 3rd Edition', 'scormType'],
  ]) {
    expect(tag).toBe(`{${namespace}}manifest`);
    const [, , , [metadata, organizations, resources]] = root;
    expect(metadata[3].map(([name, , words]: string[]) => [name, words])).toEqual([
      ['schema', 'ADL SCORM'],
      ['schemaversion', version],
    ]);
    const [organization] = organizations[3];
    const [title, item] = organization[3];
    const [resource] = resources[3];
    expect([title[0], item[0], resource[0], resource[3][0][0]]).toEqual([
      ...['title', 'item', 'resource', 'file'],
    ]);
    expect(title[2]).toBe('Graze: coefficients,roots,nappes.2,normal, seed 41');
    expect(organizations[1].default).toBe(organization[1].identifier);
    expect(item[1].identifierref).toBe(resource[1].identifier);
    expect(resource[1]).toMatchObject({ type: 'webcontent', href: 'index.html', [type]: 'sco' });
    expect(resource[3][0][1]).toEqual({ href: 'index.html' });
    const ids = [root, organization, item, resource].map(([, { identifier }]) => identifier);
    expect(new Set(ids).size).toBe(4);
    for (const id of ids) expect(id).toMatch(/^[a-z][\w.-]*$/);
  }
  const [, , , [[, , , [activity]]]] = ofXapi[1];
  expect(ofXapi[0]).toBe('{http://projecttincan.com/tincan.xsd}tincan');
  expect(activity[1].id).toBe(strange.activity);
  expect(activity[3].map(([name]: string[]) => name)).toEqual(['name', 'description', 'launch']);
});

/** What xAPI 1.0.3 (Data, 2.2 to 2.4) asks of a statement that is sent. */
function expectStatement(statement: unknown): void {
  const iri = expect.stringMatching(/^[a-z][a-z\d+.-]*:[^\s<>"{}|\\^`]+$/i);
  const words = expect.objectContaining({ en: expect.stringMatching(/./) });
  const { actor, object, result, context, ...rest } = statement as Record<
    string,
    Record<string, unknown>
  >;
  expect(rest).toEqual({
    id: expect.stringMatching(
      /^[\da-f]{8}-[\da-f]{4}-[1-5][\da-f]{3}-[89ab][\da-f]{3}-[\da-f]{12}$/,
    ),
    verb: { id: iri, display: words },
    timestamp: expect.stringMatching(/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(?:\.\d+)?Z$/),
  });
  // Exactly one of the four ways to name an agent.
  const { objectType, name: _, ...identifiers } = actor ?? {};
  expect(objectType).toBe('Agent');
  expect(Object.keys(identifiers)).toHaveLength(1);
  if (identifiers.account) {
    expect(identifiers.account).toEqual({ homePage: iri, name: expect.stringMatching(/./) });
  }
  const { definition, ...activity } = object ?? {};
  expect(activity).toEqual({ objectType: 'Activity', id: iri });
  const { type, name, interactionType, correctResponsesPattern } = definition as Record<
    string,
    unknown
  >;
  expect([type, name]).toEqual([iri, words]);
  // Both or neither: the pattern belongs to an interaction.
  expect(correctResponsesPattern === undefined).toBe(interactionType === undefined);
  const { score, success, completion, response, extensions } = (result ?? {}) as {
    readonly score?: Record<string, number>;
    readonly [key: string]: unknown;
  };
  expect(typeof success).toBe('boolean');
  expect(['boolean', 'undefined']).toContain(typeof completion);
  expect(['string', 'undefined']).toContain(typeof response);
  for (const key of Object.keys(extensions ?? {})) expect(key).toEqual(iri);
  if (score) {
    const { scaled = 9, raw = 9, min = 9, max = 0 } = score;
    expect(Math.abs(scaled)).toBeLessThanOrEqual(1);
    expect(min <= raw && raw <= max).toBe(true);
  }
  const { registration, contextActivities, ...other } = context ?? {};
  expect(other).toEqual({});
  if (registration !== undefined) expect(registration).toMatch(/^[\da-f-]{36}$/);
  if (contextActivities !== undefined) {
    expect(contextActivities).toEqual({ parent: [{ objectType: 'Activity', id: iri }] });
  }
  const all = JSON.stringify(statement);
  expect(all).not.toMatch(/:null|:""|:\{\}/);
}

const UUID = '6ba7b810-9dad-41d1-80b4-00c04fd430c8';

describe('statements', () => {
  const actor = { name: ['Ada'], mbox: ['mailto:ada@school.example'] };
  const launchWith = (given: Record<string, string>) =>
    readLaunch(`?${new URLSearchParams(given)}`, COURSE);
  const launched = { endpoint: 'https://store.example/xapi', actor: JSON.stringify(actor) };

  test('of a launch go to its address, well-formed, and wait while refused', async () => {
    const launch = launchWith({ ...launched, auth: 'Basic x', registration: UUID });
    if (typeof launch === 'string') throw new Error(launch);
    const sent: { readonly url: string; readonly method: string; readonly body: string }[] = [];
    let status = 200;
    const request: Request = async (url, { method, headers, body }) => {
      expect(headers).toMatchObject({
        Authorization: 'Basic x',
        'X-Experience-API-Version': '1.0.3',
      });
      sent.push({ url, method, body: body ?? '' });
      return method === 'GET' ? { status: 404, text: '' } : { status, text: '' };
    };
    const connection = await connectXapi(launch, request, AROUND);
    if (typeof connection === 'string') throw new Error(connection);
    expect(connection.learner).toBe('ada@school.example');
    const [wrong, first] = answer(started(41, SET), 0, false);
    const [right, second] = answer(wrong, 0, true);
    status = 503;
    expect(await connection.send(reportOf(wrong), first)).toBe('it answers 503');
    status = 204;
    sent.length = 0;
    expect(await connection.send(reportOf(right, 4096, true), second)).toBe('');
    const post = sent.find(({ method }) => method === 'POST');
    expect(post?.url).toBe('https://store.example/xapi/statements');
    const statements = JSON.parse(post?.body ?? '');
    for (const one of statements) expectStatement(one);
    expect(
      statements.map((one: { verb: { id: string } }) => one.verb.id.split('/').at(-1)),
    ).toEqual(['answered', 'answered', 'completed', 'failed']);
    const put = sent.find(({ method }) => method === 'PUT');
    const asked = new URL(put?.url ?? '').searchParams;
    expect([asked.get('activityId'), asked.get('registration')]).toEqual([COURSE.activity, UUID]);
    expect(JSON.parse(asked.get('agent') ?? '')).toEqual({
      objectType: 'Agent',
      mbox: 'mailto:ada@school.example',
      name: 'Ada',
    });
    // The same score is told once.
    sent.length = 0;
    await connection.send(reportOf(right, 4096, true), null);
    expect(sent.map(({ method }) => method)).toEqual(['PUT']);
    // Also on another visit.
    const kept = sent[0]?.body ?? '';
    const later = await connectXapi(
      launch,
      async (url, { method, body }) => {
        sent.push({ url, method, body: body ?? '' });
        return { status: 200, text: method === 'GET' ? kept : '' };
      },
      AROUND,
    );
    if (typeof later === 'string') throw new Error(later);
    expect(later.complete).toBe(true);
    sent.length = 0;
    later.end(reportOf(right, 4096, true));
    expect(sent.map(({ method }) => method)).toEqual(['PUT']);
  });

  test('come to the store once each, whatever it does meanwhile', async () => {
    const launch = launchWith({ ...launched, registration: UUID });
    if (typeof launch === 'string') throw new Error(launch);
    const step = fc.record({
      does: fc.constantFrom('wrong', 'right', 'leave', 'hand in'),
      // A store may take what it is asked for, refuse all or one of both, or be heard no more.
      store: fc.constantFrom('takes', 'refuses', 'takes states', 'takes statements', 'is unheard'),
    });
    await fc.assert(
      fc.asyncProperty(fc.array(step, { maxLength: 8 }), async (steps) => {
        let ids = 0;
        const around = { ...AROUND, uuid: () => `id-${++ids}` };
        let store: string = 'takes';
        let state = '';
        const had = new Map<string, Readonly<Record<string, unknown>>>();
        const request: Request = async (url, { method, body }) => {
          if (method === 'GET') return { status: state ? 200 : 404, text: state };
          const isState = url.includes('/activities/state');
          if (store === 'refuses') return { status: 500, text: '' };
          if (store === (isState ? 'takes statements' : 'takes states')) {
            return { status: 403, text: '' };
          }
          if (isState) state = body ?? '';
          else {
            const all: { readonly id: string }[] = JSON.parse(body ?? '[]');
            // A strict store takes nothing of what it has partly.
            if (all.some(({ id }) => had.has(id))) return { status: 409, text: '' };
            for (const one of all) had.set(one.id, one);
          }
          if (store === 'is unheard') throw new Error('no network');
          return { status: 200, text: '' };
        };
        let kept = '[]';
        const visit = async (): Promise<Connection> => {
          const found = await connectXapi(launch, request, around);
          if (typeof found === 'string') throw new Error(found);
          found.unsent?.restore(JSON.parse(kept));
          return found;
        };
        let connection = await visit();
        let progress = started(41, SET);
        let [handedIn, tries] = [false, 0];
        const report = () => reportOf(progress, 4096, handedIn);
        for (const { does, store: next } of steps) {
          store = next;
          if (does === 'leave') {
            connection.end(report());
            kept = JSON.stringify(connection.unsent?.now());
            connection = await visit();
          } else if (does === 'hand in') {
            handedIn = true;
            await connection.send(report(), null);
          } else {
            const [later, answered] = answer(progress, tries % 4, does === 'right');
            progress = later;
            if (answered) tries++;
            await connection.send(report(), answered);
          }
        }
        store = 'takes';
        if (connection.unsent?.isOpen(report())) await connection.send(report(), null);
        const verbs = [...had.values()].map(({ verb }) => String((verb as { id: string }).id));
        const count = (verb: string) => verbs.filter((one) => one.endsWith(verb)).length;
        expect(connection.unsent?.now()).toEqual([]);
        expect(count('/answered')).toBe(tries);
        expect(count('/completed') > 0).toBe(report().complete);
        expect(count('/completed')).toBe(count('/passed') + count('/failed'));
        const outcome = [...had.values()].findLast(
          ({ verb }) => !(verb as { id: string }).id.endsWith('/answered'),
        );
        if (outcome) {
          const { right, passed } = report();
          expect(outcome.result).toMatchObject({ score: { raw: right }, success: passed });
        }
      }),
      { numRuns: many(200) },
    );
  });

  test('need an address and a name, and none is sent without', async () => {
    expect(launchWith({})).toContain('endpoint');
    expect(launchWith({ ...launched, endpoint: 'javascript:alert(1)' })).toContain('endpoint');
    for (const bad of ['', '{', '[]', '{}', '{"account":{}}', '{"mbox":5}']) {
      expect(launchWith({ ...launched, actor: bad })).toContain('actor');
    }
    const account =
      '{"account":[{"accountServiceHomePage":"https://a.example","accountName":"7"}]}';
    const old = launchWith({ ...launched, actor: account, registration: 'none' });
    if (typeof old === 'string') throw new Error(old);
    expect(old.registration).toBe('');
    const lost: Request = () => Promise.reject(new Error('no network'));
    expect(await connectXapi(old, lost, AROUND)).toBe('it does not answer');
    const refuses: Request = async () => ({ status: 401, text: '' });
    expect(await connectXapi(old, refuses, AROUND)).toBe('it answers 401');
    for (const text of ['{', '5', '{"state":7,"place":-1,"complete":"yes"}']) {
      const odd: Request = async () => ({ status: 200, text });
      expect(await connectXapi(old, odd, AROUND)).toMatchObject({
        ...{ learner: '7', state: '', place: 0, complete: false },
      });
    }
  });

  test('of a session are the same, as a file', () => {
    const [one] = answer(started(41, SET), 0, false);
    const [two] = answer(one, 1, true);
    const scene = { actor: accountOf('https://a.example/', 'Ada'), activity: COURSE.activity };
    const statements = [...sessionStatements(two, scene, AROUND)].flat();
    expect(statements).toHaveLength(2);
    for (const statement of statements) expectStatement(statement);
  });
});

describe('the window of a course system', () => {
  const system = { LMSInitialize: () => 'true' };
  interface Fake {
    readonly API?: unknown;
    parent: Fake;
    top: Fake;
    opener: Fake | null;
  }
  const blocked = new Proxy({} as Fake, {
    get: () => {
      throw new Error('another origin');
    },
  });

  const fake = (own: object, parent: Fake | null, opener: Fake | null = null): Fake => {
    const made = { ...own, opener } as Fake;
    made.parent = parent ?? made;
    made.top = parent && parent !== blocked ? parent.top : made;
    return made;
  };
  const find = (window: Fake) => findApi('API', window as unknown as Window);
  test('is found above, or above the window that opened this one', () => {
    const top = fake({ API: system }, null);
    expect(find(fake({}, fake({}, top))).api).toBe(system);
    expect(find(fake({}, null, fake({}, top))).api).toBe(system);
    expect(find(fake({}, fake({}, null, top))).api).toBe(system);
    expect(find(fake({}, blocked, top)).api).toBe(system);
  });

  test('is not found where there is none, it is out of reach, or windows go round', () => {
    expect(find(fake({ API: system }, null))).toEqual({ api: null, blocked: false });
    expect(find(fake({}, fake({ API: 'text' }, null)))).toEqual({ api: null, blocked: false });
    expect(find(fake({}, blocked))).toEqual({ api: null, blocked: true });
    const [a, b] = [fake({}, null), fake({}, null)];
    [a.parent, b.parent] = [b, a];
    expect(find(fake({}, a))).toEqual({ api: null, blocked: false });
  });
});

test('a state is as long as there is room for, and loses boxes before anything else', () => {
  const set = 'coefficients*20,roots*20,discriminant*20';
  const asked = fc.record({
    texts: fc.dictionary(fc.constantFrom('A', 'B', 'C', 'D'), fc.string({ maxLength: 80 })),
    tries: fc.nat({ max: 9 }),
    solvedAt: fc.constantFrom(null, 1, 2),
  });
  fc.assert(
    fc.property(fc.array(asked, { maxLength: 60 }), fc.constantFrom(4000, 4096), (all, most) => {
      const rest = { hints: 0, solutionShown: false, causes: [] };
      const each = all.map((one, i) => [String(i), { ...one, ...rest }]);
      const progress: Progress = { ...started(41, set), asked: Object.fromEntries(each) };
      const course = { ...COURSE, set };
      const at = { who: '', place: 0, handedIn: false, most };
      const { state, right } = courseReport(course, progress, at);
      expect(state.length).toBeLessThanOrEqual(most);
      const read = readHandIn(state);
      expect(read.asked.filter(({ solvedAt }) => solvedAt !== null)).toHaveLength(right);
      expect(read.asked.map(({ tries }) => tries).slice(0, all.length)).toEqual(
        all.map(({ tries }) => tries),
      );
    }),
    { numRuns: many(120) },
  );
});
