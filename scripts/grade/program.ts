import { Worker } from 'node:worker_threads';
import type { Case } from '../../src/check/program/cases.ts';
import type { Output } from '../../src/check/program/judge.ts';
import { readValue } from '../../src/check/program/protocol.ts';
import { adviceFor, asScript, looksTyped, tooLong } from '../../src/check/program/script.ts';
import { stripTypes } from '../../src/check/program/strip.ts';

/*
 * Runs a student's program on cases in a worker of its own: no require, process, network or files
 * within, a time for each case and for all, and a limit of memory. Node says itself that its vm is
 * no wall against an attacker: programs of strangers are graded in a container.
 */

export interface Limits {
  /** ms that one case may take, and all of them together. */
  readonly each: number;
  readonly total: number;
  /** MB of heap. */
  readonly memory: number;
}

export const LIMITS: Limits = { each: 1000, total: 60_000, memory: 256 };

interface Ran {
  readonly outputs: readonly Output[];
  /** Why it did not run to the end; '' if it did. */
  readonly problem: string;
}

/** Numbers that JSON lacks travel as { $: 'NaN' }. */
const tagged = (_: string, x: unknown): unknown =>
  typeof x === 'number' && !Number.isFinite(x) ? { $: String(x) } : x;
const untagged = (_: string, x: unknown): unknown =>
  typeof x === 'object' && x !== null && '$' in x ? Number(x.$) : x;

/**
 * What runs beside the program. It keeps what it needs before the program can change it, and gives
 * only texts to the world outside.
 */
const INNER = `(() => {
  'use strict';
  const { parse, stringify } = JSON;
  const { isArray, from } = Array;
  const { isView } = ArrayBuffer;
  const { isFinite } = Number;
  const { min } = Math;
  const Text = String;
  const { slice, replace } = Text.prototype;
  const call = Function.prototype.call;
  const cut = call.bind(slice);
  const first = call.bind(RegExp.prototype.exec);
  const silent = () => {};
  const console = {};
  for (const name of ['log', 'info', 'debug', 'warn', 'error', 'table', 'dir', 'trace', 'assert'])
    console[name] = silent;
  globalThis.console = console;
  const number = (x) => (isFinite(x) ? x : { $: Text(x) });
  const simple = (x, depth) => {
    if (x === null || typeof x === 'boolean') return x;
    if (typeof x === 'number') return number(x);
    if (typeof x === 'string') return cut(x, 0, 60);
    if (typeof x !== 'object') return x === undefined ? undefined : 'a ' + typeof x;
    if (isArray(x) || isView(x)) {
      if (depth > 2) return 'an array';
      return from({ length: min(x.length, 20) }, (_, i) => simple(x[i], depth + 1));
    }
    if (typeof x.then === 'function') return 'a promise';
    return depth === 0 ? { t: simple(x.t, 1), normal: simple(x.normal, 1) } : 'an object';
  };
  const words = (error) => {
    try {
      return cut(Text(error && error.message !== undefined ? error.message : error), 0, 300);
    } catch {
      return 'something that cannot be written';
    }
  };
  const lineOf = (error) => {
    try {
      const found = first(/program\\.js:(\\d+)/, cut(Text(error.stack), 0, 4000));
      return found ? +found[1] : null;
    } catch {
      return null;
    }
  };
  const revive = (_, x) => (typeof x === 'object' && x !== null && '$' in x ? +x.$ : x);
  return (run, text) => {
    try {
      const { shape, ray } = parse(text, revive);
      return stringify({ value: simple(run(shape, ray), 0) });
    } catch (error) {
      return stringify({ threw: words(error), line: lineOf(error) });
    }
  };
})()`;

/** The worker, as a text: it has no file of its own in a bundle. */
const WORKER = `
const { parentPort, workerData } = require('node:worker_threads');
const vm = require('node:vm');
const { inner, script, cases, each } = workerData;
const context = vm.createContext(Object.create(null), {
  codeGeneration: { strings: false, wasm: false },
  microtaskMode: 'afterEvaluate',
});
const name = 'graze' + Math.random().toString(36).slice(2);
const post = (message) => parentPort.postMessage(message);
const at = (text, filename) => vm.runInContext(text, context, { timeout: each, filename });
const fixed = (key, text, filename) =>
  at('Object.defineProperty(globalThis, "' + key + '", { value: ' + text + '});', filename);
try {
  fixed(name, inner, 'harness.js');
  fixed(name + 'run', '(function (graze_default) {' + script +
    '\\n; return typeof intersect === "function" ? intersect : graze_default; })()', 'program.js');
  if (at('typeof ' + name + 'run', 'harness.js') !== 'function') {
    post({ refused: 'there is no function intersect(shape, ray)', line: null });
  } else {
    for (const text of cases) {
      try {
        const one = name + '(' + name + 'run, ' + JSON.stringify(text) + ')';
        post({ text: String(at(one, 'harness.js')) });
      } catch (error) {
        post({ stopped: error.code === 'ERR_SCRIPT_EXECUTION_TIMEOUT' });
        break;
      }
    }
    post({ done: true });
  }
} catch (error) {
  const timeout = error && error.code === 'ERR_SCRIPT_EXECUTION_TIMEOUT';
  const found = /program\\.js:(\\d+)/.exec(String(error && error.stack));
  const kind = error && error.name === 'SyntaxError' ? 'syntax error: ' : '';
  post({
    refused: timeout
      ? 'it does not get to its end'
      : kind + String(error && error.message).slice(0, 300),
    line: found ? Number(found[1]) : null,
  });
}
`;

interface Message {
  readonly text?: string;
  readonly stopped?: boolean;
  readonly done?: true;
  readonly refused?: string;
  readonly line?: number | null;
}

/** Runs a program in JavaScript or TypeScript; it never throws for what the program does. */
export async function runProgram(
  source: string,
  cases: readonly Case[],
  limits: Limits = LIMITS,
): Promise<Ran> {
  const long = tooLong(source);
  if (long) return { outputs: [], problem: `not run: ${long}` };
  const plain = looksTyped(source) ? null : await runScript(source, cases, limits);
  if (plain && !plain.problem.includes('syntax error')) return plain;
  const stripped = stripTypes(source);
  if (stripped.ok && (!plain || stripped.text !== source)) {
    return runScript(stripped.text, cases, limits);
  }
  if (plain) return plain;
  const { message, line } = stripped as { readonly message: string; readonly line: number | null };
  return { outputs: [], problem: placed(message, line) };
}

const placed = (message: string, line: number | null): string =>
  line === null ? message : `line ${line}: ${message}`;

function runScript(source: string, cases: readonly Case[], limits: Limits): Promise<Ran> {
  const worker = new Worker(WORKER, {
    eval: true,
    env: {},
    execArgv: [],
    stdin: false,
    stdout: true,
    stderr: true,
    resourceLimits: { maxOldGenerationSizeMb: limits.memory, maxYoungGenerationSizeMb: 32 },
    workerData: {
      inner: INNER,
      script: asScript(source),
      each: limits.each,
      cases: cases.map(({ shape, ray }) => JSON.stringify({ shape, ray }, tagged)),
    },
  });
  return new Promise((resolve) => {
    const outputs: Output[] = [];
    const end = (problem: string): void => {
      clearTimeout(timer);
      void worker.terminate();
      resolve({ outputs, problem });
    };
    const timer = setTimeout(() => end(`stopped after ${limits.total / 1000} s`), limits.total);
    worker.on('error', (error) => end(`stopped: ${String(error.message).slice(0, 200)}`));
    worker.on('exit', () => end('it ended the worker'));
    worker.on('message', (message: Message) => {
      if (message.text !== undefined) outputs.push(outputOf(message.text));
      else if (message.stopped !== undefined) {
        outputs.push({ type: 'stopped' });
        const why = message.stopped ? `took more than ${limits.each / 1000} s` : 'ended the run';
        end(`case ${outputs.length} of ${cases.length} ${why}`);
      } else if (message.refused !== undefined) {
        const advice = adviceFor(source, message.refused);
        const words = placed(message.refused, message.line ?? null);
        end(advice ? `${words}. ${advice}` : words);
      } else end('');
    });
  });
}

function outputOf(text: string): Output {
  const data = JSON.parse(text, untagged) as Record<string, unknown>;
  if ('threw' in data) {
    const line = typeof data.line === 'number' ? data.line : null;
    return { type: 'threw', message: String(data.threw), line };
  }
  return readValue(data.value);
}
