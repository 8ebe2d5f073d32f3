import {
  type Answered,
  type Connection,
  type Course,
  type CourseReport,
  type Environment,
  scaled,
} from './course.ts';

/* Statements of xAPI 1.0.3 (ADL): actor, verb, activity and result. */

const VERBS = 'http://adlnet.gov/expapi/verbs/';
const TYPES = 'http://adlnet.gov/expapi/activities/';
const XAPI_VERSION = '1.0.3';

type Actor = Readonly<Record<string, unknown>>;

/** An agent with an account: a name or number at this home page. */
export const accountOf = (homePage: string, name: string): Actor => ({
  objectType: 'Agent',
  account: { homePage, name },
});

/** The actor and the activity of statements. */
export interface StatementContext {
  readonly actor: Actor;
  /** IRI of the set. */
  readonly activity: string;
  /** Ties the statements of one attempt together; '' for none. */
  readonly registration: string;
}

export type Statement = Readonly<Record<string, unknown>>;

const verb = (name: string) => ({ id: `${VERBS}${name}`, display: { en: name } });

const withRegistration = (registration: string) => (registration ? { registration } : {});

/** The IRI of something within the activity. */
const within = (activity: string, name: string): string =>
  `${activity}${/[?#]/.test(activity) ? '&' : '#'}${name}`;

export function answeredStatement(
  { id, about, response, expected, right, causes }: Answered,
  { actor, activity, registration }: StatementContext,
  env: Environment,
): Statement {
  const extensions =
    causes.length > 0 ? { extensions: { [within(activity, 'misconceptions')]: causes } } : {};
  return {
    id: env.uuid(),
    actor,
    verb: verb('answered'),
    object: {
      objectType: 'Activity',
      id: within(activity, `question=${/\d+/.exec(id)?.[0] ?? ''}`),
      definition: {
        name: { en: about },
        type: `${TYPES}cmi.interaction`,
        interactionType: 'long-fill-in',
        correctResponsesPattern: [expected],
      },
    },
    result: { response, success: right, ...extensions },
    context: {
      ...withRegistration(registration),
      contextActivities: { parent: [{ objectType: 'Activity', id: activity }] },
    },
    timestamp: env.stamp(),
  };
}

/** That the set was completed, and passed or failed. */
function completedStatements(
  report: CourseReport,
  { actor, activity, registration }: StatementContext,
  env: Environment,
): Statement[] {
  const { right, total, passed } = report;
  const score = { scaled: Number(scaled(report).toFixed(4)), raw: right, min: 0, max: total };
  return ['completed', passed ? 'passed' : 'failed'].map((name) => ({
    id: env.uuid(),
    actor,
    verb: verb(name),
    object: {
      objectType: 'Activity',
      id: activity,
      definition: { name: { en: 'Graze: a set of questions' }, type: `${TYPES}assessment` },
    },
    result: { score, completion: true, success: passed },
    ...(registration ? { context: { registration } } : {}),
    timestamp: env.stamp(),
  }));
}

/** How a page was launched: where statements go, by whom. */
interface Launch extends StatementContext {
  /** Ends with a slash. */
  readonly endpoint: string;
  readonly auth: string;
}

/** The launch in an address's query; words on what it lacks. */
export function readLaunch(query: string, { activity }: Course): Launch | string {
  const given = new URLSearchParams(query);
  const endpoint = given.get('endpoint') ?? '';
  if (!/^https?:\/\/[^/]/.test(endpoint)) {
    return 'this page was opened without the address of a record store (endpoint)';
  }
  const actor = actorIn(given.get('actor') ?? '');
  if (!actor) return 'this page was opened without a name to answer under (actor)';
  const registration = given.get('registration') ?? '';
  return {
    endpoint: endpoint.endsWith('/') ? endpoint : `${endpoint}/`,
    auth: given.get('auth') ?? '',
    actor,
    registration: /^[\da-f]{8}(?:-[\da-f]{4}){3}-[\da-f]{12}$/i.test(registration)
      ? registration
      : '',
    activity: given.get('activity_id') || activity,
  };
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const first = (value: unknown): unknown => (Array.isArray(value) ? value[0] : value);

/** An agent with one identifier; launches of version 0.95 have lists, and longer names. */
function actorIn(text: string): Actor | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (!isRecord(value)) return null;
  const named = first(value.name);
  const name = typeof named === 'string' ? { name: named } : {};
  const account = first(value.account);
  if (isRecord(account)) {
    const homePage = account.homePage ?? account.accountServiceHomePage;
    const own = account.name ?? account.accountName;
    if (typeof homePage !== 'string' || typeof own !== 'string') return null;
    return { ...accountOf(homePage, own), ...name };
  }
  for (const key of ['mbox', 'mbox_sha1sum', 'openid']) {
    const found = first(value[key]);
    if (typeof found === 'string' && found !== '') {
      return { objectType: 'Agent', [key]: found, ...name };
    }
  }
  return null;
}

/** A text that identifies the student of a launch. */
function learnerOf({ account, mbox, mbox_sha1sum, openid }: Actor): string {
  if (isRecord(account)) return String(account.name);
  return String(mbox ?? mbox_sha1sum ?? openid ?? '').replace(/^mailto:/, '');
}

/** A request to a record store, and its answer. */
export type Request = (
  url: string,
  about: {
    readonly method: string;
    readonly headers: Readonly<Record<string, string>>;
    readonly body: string | null;
    /** The page may be left before it is answered. */
    readonly last: boolean;
  },
) => Promise<{ readonly status: number; readonly text: string }>;

const STATE_ID = 'graze-session';

/** Most characters of a state: browsers limit requests of a page that is being left. */
const MOST_STATE = 40_000;

/** Speaks with the record store of a launch; words on why it cannot. */
export async function connectXapi(
  launch: Launch,
  request: Request,
  env: Environment,
): Promise<Connection | string> {
  const headers = {
    'X-Experience-API-Version': XAPI_VERSION,
    'Content-Type': 'application/json',
    ...(launch.auth ? { Authorization: launch.auth } : {}),
  };
  const query = new URLSearchParams({
    activityId: launch.activity,
    agent: JSON.stringify(launch.actor),
    stateId: STATE_ID,
    ...withRegistration(launch.registration),
  });
  const stateUrl = `${launch.endpoint}activities/state?${query}`;
  /** '' if it was taken. */
  const ask = async (
    url: string,
    method: string,
    content: unknown,
    last = false,
  ): Promise<string> => {
    try {
      const body = JSON.stringify(content);
      const { status } = await request(url, { method, headers, body, last });
      return status >= 200 && status < 300 ? '' : `it answers ${status}`;
    } catch {
      return 'it does not answer';
    }
  };
  let kept = NOTHING_KEPT;
  try {
    const { status, text } = await request(stateUrl, {
      ...{ method: 'GET', headers, body: null, last: false },
    });
    if (status === 200) kept = stateIn(text);
    else if (status !== 404) return `it answers ${status}`;
  } catch {
    return 'it does not answer';
  }
  /** The outcome that was taken last, on this visit or one before. */
  let { told } = kept;
  /** Statements that were not taken yet. They keep their ids, so that none counts twice. */
  let waiting: readonly Statement[] = [];
  const outcomeWaiting = (): string | undefined => outcomeIn(waiting, launch.registration);
  const isNews = (report: CourseReport): boolean =>
    report.complete && outcomeOf(report) !== (outcomeWaiting() ?? told);
  const add = (report: CourseReport, answered: Answered | null): void => {
    waiting = [
      ...waiting,
      ...(answered ? [answeredStatement(answered, launch, env)] : []),
      ...(isNews(report) ? completedStatements(report, launch, env) : []),
    ];
  };
  const post = async (some: readonly Statement[], last = false): Promise<string> => {
    const refused =
      some.length === 0 ? '' : await ask(`${launch.endpoint}statements`, 'POST', some, last);
    if (refused === HAS_SOME && some.length > 1) {
      let why = '';
      for (const one of some) why ||= await post([one]);
      return why;
    }
    if (refused && refused !== HAS_SOME) return refused;
    waiting = waiting.filter((one) => !some.includes(one));
    told = outcomeIn(some, launch.registration) ?? told;
    return '';
  };
  const keep = ({ state, place, complete }: CourseReport, last = false): Promise<string> =>
    ask(stateUrl, 'PUT', { state, place, complete, told } satisfies StoredSession, last);
  let before: Promise<unknown> = Promise.resolve();
  const { state, place, complete } = kept;
  return {
    ...{ state, place, complete },
    learner: learnerOf(launch.actor),
    readOnly: false,
    most: MOST_STATE,
    unsent: {
      now: () => waiting,
      restore(statements) {
        waiting = [...statements.filter((one) => isOf(launch, one)), ...waiting];
      },
      isOpen: (report) => waiting.length > 0 || isNews(report),
    },
    send(report, answered) {
      add(report, answered);
      const sent = before.then(async () => {
        const refused = await post(waiting);
        const other = await keep(report);
        return refused || other;
      });
      before = sent;
      return sent;
    },
    end(report) {
      add(report, null);
      void post(waiting, true);
      void keep(report, true);
    },
  };
}

/** Answer of a store that already has a statement with one of these ids. */
const HAS_SOME = 'it answers 409';

const outcomeOf = ({ right, passed }: CourseReport): string => `${right} ${passed}`;

/** The outcome that the last of these statements on an attempt's end has. */
function outcomeIn(statements: readonly Statement[], registration: string): string | undefined {
  const outcomes = statements.flatMap(({ result, context }) => {
    const own = isRecord(context) ? (context.registration ?? '') : '';
    if (own !== registration || !isRecord(result) || !isRecord(result.score)) return [];
    return [`${result.score.raw} ${result.success}`];
  });
  return outcomes.at(-1);
}

/** Whether something that was kept is a statement of this student on this set. */
const isOf = ({ actor, activity }: Launch, kept: unknown): kept is Statement =>
  isRecord(kept) &&
  JSON.stringify(kept.actor) === JSON.stringify(actor) &&
  isRecord(kept.object) &&
  String(kept.object.id).startsWith(activity);

/** What a record store keeps of a session. */
interface StoredSession {
  readonly state: string;
  readonly place: number;
  readonly complete: boolean;
  readonly told: string;
}

const NOTHING_KEPT: StoredSession = { state: '', place: 0, complete: false, told: '' };

function stateIn(text: string): StoredSession {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    value = null;
  }
  const { state, place, complete, told } = isRecord(value) ? value : {};
  return {
    state: typeof state === 'string' ? state : '',
    place: Number.isSafeInteger(place) ? Math.max(0, place as number) : 0,
    complete: complete === true,
    told: typeof told === 'string' ? told : '',
  };
}
