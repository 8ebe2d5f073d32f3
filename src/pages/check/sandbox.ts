import type { Output } from '../../check/program/judge.ts';
import {
  type ConsoleLine,
  type Reply,
  type RunMessage,
  readReply,
  type Timing,
} from '../../check/program/protocol.ts';

type Ending =
  | { readonly how: 'done' }
  | { readonly how: 'refused'; readonly message: string; readonly line: number | null }
  | { readonly how: 'stopped'; readonly message: string }
  /** The frame or its worker did not start, so that the program never ran. */
  | { readonly how: 'unopened'; readonly message: string };

/** Receives the messages of a run. */
interface SandboxListener {
  output(index: number, output: Output): void;
  note(message: string): void;
  console(line: ConsoleLine): void;
  unsteady(index: number): void;
  timing(timing: Timing): void;
  untimed(message: string): void;
  end(ending: Ending): void;
}

/** Handlers that do nothing, for messages that a run has no use for. */
export const IGNORE_MESSAGES: Omit<SandboxListener, 'output' | 'end'> = {
  note() {},
  console() {},
  unsteady() {},
  timing() {},
  untimed() {},
};

/** Limits in ms until the first message: since the frame was created, and since it was loaded. */
const OPEN_LIMIT_MS = 12_000;
const AFTER_LOAD_MS = 5000;
/**
 * ms without a message after which the run ends. The frame's own watchdog ends a worker after 1 s.
 */
const FRAME_LIMIT_MS = 6000;
/** Most messages of a run. The harness sends less than 1,000; more can only be the program's. */
const MOST_MESSAGES = 5000;

let lastId = 0;

/**
 * Runs a program in a new worker of a frame (sandbox.html) that has no origin, network, storage or
 * access to the page. The frame is removed after the run. Returns a function that cancels it.
 */
export function runInSandbox(
  host: Element,
  job: Omit<RunMessage, 'type' | 'id'>,
  listener: SandboxListener,
): () => void {
  const id = ++lastId;
  const frame = document.createElement('iframe');
  frame.className = 'sandbox-frame';
  frame.title = 'sandbox';
  frame.tabIndex = -1;
  frame.setAttribute('aria-hidden', 'true');
  frame.setAttribute('sandbox', 'allow-scripts');
  frame.setAttribute('referrerpolicy', 'no-referrer');
  let timer = 0;
  let opened = false;
  let ended = false;
  let messages = 0;
  const close = (): void => {
    ended = true;
    clearTimeout(timer);
    window.removeEventListener('message', hear);
    frame.remove();
  };
  const end = (ending: Ending): void => {
    if (ended) return;
    close();
    listener.end(ending);
  };
  const stop = (message: string): void => end({ how: 'stopped', message });
  const within = (ms: number, otherwise: () => void): void => {
    clearTimeout(timer);
    timer = window.setTimeout(otherwise, ms);
  };
  const unopened = async (): Promise<void> => {
    // The run has ended: later messages of the frame are ignored.
    window.removeEventListener('message', hear);
    const message = await likelyCause();
    end({ how: 'unopened', message });
  };
  const hear = ({ source, data }: MessageEvent<unknown>): void => {
    if (source === null || source !== frame.contentWindow) return;
    const reply = readReply(data);
    if (!reply || (reply.type !== 'ready' && reply.id !== id)) return;
    if (++messages > MOST_MESSAGES) {
      stop('more messages than a run can have');
      return;
    }
    if (reply.type === 'ready' && !opened) {
      opened = true;
      frame.contentWindow?.postMessage({ ...job, type: 'run', id }, '*');
    }
    within(FRAME_LIMIT_MS, () => stop('the sandbox did not answer'));
    pass(reply, listener, end);
  };
  window.addEventListener('message', hear);
  frame.addEventListener('load', () => {
    if (!opened && !ended) within(AFTER_LOAD_MS, () => void unopened());
  });
  within(OPEN_LIMIT_MS, () => void unopened());
  void open(frame, host);
  return close;
}

function pass(reply: Reply, listener: SandboxListener, end: (ending: Ending) => void): void {
  if (reply.type === 'case') listener.output(reply.index, reply.output);
  if (reply.type === 'cases') {
    for (const [i, output] of reply.outputs.entries()) listener.output(reply.index + i, output);
  }
  if (reply.type === 'note') listener.note(reply.message);
  if (reply.type === 'console') listener.console(reply);
  if (reply.type === 'unsteady') listener.unsteady(reply.index);
  if (reply.type === 'timing') listener.timing(reply);
  if (reply.type === 'untimed') listener.untimed(reply.message);
  if (reply.type === 'done') end({ how: 'done' });
  if (reply.type === 'refused') end({ how: 'refused', message: reply.message, line: reply.line });
  if (reply.type === 'stopped') end({ how: 'stopped', message: reply.message });
}

const FILE = './sandbox.html';
const OFFLINE = import.meta.env.MODE === 'single';

/** Loads the sandbox: from a file with its own policy; in the offline file from an inline text. */
async function open(frame: HTMLIFrameElement, host: Element): Promise<void> {
  if (OFFLINE) {
    const { default: text } = await import('./sandbox.html?raw');
    frame.srcdoc = text;
  } else {
    frame.src = FILE;
  }
  host.append(frame);
}

/** Words on why the frame did not start, from the server's answer for its file. */
async function likelyCause(): Promise<string> {
  const browser = 'the browser did not run its script';
  if (OFFLINE) return browser;
  try {
    const response = await fetch(FILE, { signal: AbortSignal.timeout(3000), cache: 'no-store' });
    if (!response.ok) return `the server answers ${response.status} for sandbox.html`;
    if (!(await response.text()).includes('id="harness"')) {
      return 'the server sends another page in place of sandbox.html';
    }
    return (
      `${browser}: a header of the server may forbid it (X-Frame-Options, ` +
      `Content-Security-Policy, Cross-Origin-Resource-Policy)`
    );
  } catch {
    return 'sandbox.html cannot be fetched: no connection, or the server does not answer';
  }
}
