import type { Output } from '../check/program/judge.ts';
import { type Run, readReply } from '../check/program/protocol.ts';

export type Ending =
  | { readonly how: 'done' }
  | { readonly how: 'refused'; readonly message: string; readonly line: number | null }
  | { readonly how: 'stopped'; readonly message: string };

export interface Heard {
  output(index: number, output: Output): void;
  note(message: string): void;
  timing(multiple: number): void;
  end(ending: Ending): void;
}

/** The frame's own watchdog takes a second; a frame that says nothing for longer is dead itself. */
const FRAME_LIMIT_MS = 6000;

let lastId = 0;

/**
 * Runs a program in a frame of its own: no origin, no network, no storage, no page (sandbox.html), in a fresh worker. The
 * frame goes away with the run. Gives a function that cancels it.
 */
export function runInSandbox(
  host: Element,
  job: Omit<Run, 'type' | 'id'>,
  heard: Heard,
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
  const close = (): void => {
    clearTimeout(timer);
    window.removeEventListener('message', hear);
    frame.remove();
  };
  const end = (ending: Ending): void => {
    close();
    heard.end(ending);
  };
  const watch = (): void => {
    clearTimeout(timer);
    timer = window.setTimeout(
      () => end({ how: 'stopped', message: 'the sandbox did not answer' }),
      FRAME_LIMIT_MS,
    );
  };
  const hear = ({ source, data }: MessageEvent<unknown>): void => {
    if (source === null || source !== frame.contentWindow) return;
    const reply = readReply(data);
    if (!reply || (reply.type !== 'ready' && reply.id !== id)) return;
    watch();
    if (reply.type === 'ready') frame.contentWindow?.postMessage({ ...job, type: 'run', id }, '*');
    if (reply.type === 'case') heard.output(reply.index, reply.output);
    if (reply.type === 'note') heard.note(reply.message);
    if (reply.type === 'timing') heard.timing(reply.multiple);
    if (reply.type === 'done') end({ how: 'done' });
    if (reply.type === 'refused') end({ how: 'refused', message: reply.message, line: reply.line });
    if (reply.type === 'stopped') end({ how: 'stopped', message: reply.message });
  };
  window.addEventListener('message', hear);
  watch();
  void open(frame, host);
  return close;
}

/** The site has a file with its own policy; the offline file, which has none, carries the same text inside. */
async function open(frame: HTMLIFrameElement, host: Element): Promise<void> {
  if (import.meta.env.MODE === 'single') {
    const { default: text } = await import('./sandbox.html?raw');
    frame.srcdoc = text;
  } else {
    frame.src = './sandbox.html';
  }
  host.append(frame);
}
