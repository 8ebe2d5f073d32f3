/** Starts the download of a file with this content. */
export function download(name: string, content: string | Blob, type = 'text/plain'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type }) : content;
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser has taken the blob by the next task.
  setTimeout(() => URL.revokeObjectURL(url));
}

/** Largest file that is read, in bytes: more than any state or scene, less than a video. */
const LARGEST_BYTES = 2_000_000;

/**
 * Whether the browser would let a file be chosen now: it does for some seconds after a key or a
 * click, and otherwise nothing happens.
 */
export const mayPick = (): boolean => navigator.userActivation?.isActive ?? true;

/** Asks for a file and gives its text, or null. */
export function pickFile(accept: string): Promise<string | null> {
  return new Promise((resolve) => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = accept;
    // In the page while the dialog is open, so that nothing clears it away.
    input.hidden = true;
    document.body.append(input);
    const done = (text: string | null | Promise<string | null>): void => {
      input.remove();
      resolve(text);
    };
    input.addEventListener('change', () => done(readText(input.files?.[0])));
    input.addEventListener('cancel', () => done(null));
    input.click();
  });
}

/** A file, and its path within the folders that were chosen or dropped. */
export interface PathFile {
  readonly path: string;
  readonly file: File;
}

export const chosenFiles = (input: HTMLInputElement): readonly PathFile[] =>
  [...(input.files ?? [])].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/** The texts of files, null for one that is too large; in a folder also what is no text. */
export const readTexts = (
  files: readonly PathFile[],
): Promise<readonly { readonly path: string; readonly text: string | null }[]> =>
  Promise.all(
    files.map(async ({ path, file }) => ({
      path,
      text: file.size <= LARGEST_BYTES ? await file.text() : null,
    })),
  );

/** All files that were dropped, also those in folders. To be called while the event is handled. */
export async function droppedFiles({ items, files }: DataTransfer): Promise<readonly PathFile[]> {
  const entries = [...items].flatMap((item) => item.webkitGetAsEntry() ?? []);
  if (entries.length === 0) return [...files].map((file) => ({ path: file.name, file }));
  return (await Promise.all(entries.map(filesOf))).flat();
}

async function filesOf(entry: FileSystemEntry): Promise<PathFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((done, fail) =>
      (entry as FileSystemFileEntry).file(done, fail),
    );
    return [{ path: entry.fullPath.replace(/^\//, ''), file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: PathFile[] = [];
  // A reader gives a hundred entries at a time, and none at the end.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, fail) =>
      reader.readEntries(done, fail),
    );
    if (some.length === 0) return found;
    found.push(...(await Promise.all(some.map(filesOf))).flat());
  }
}

/** Calls back with the text of a file that is dropped anywhere on the page. */
export function watchDrops(root: HTMLElement, opened: (text: string) => void): void {
  root.addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  });
  root.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    void readText(file).then((text) => {
      if (text !== null) opened(text);
    });
  });
}

let tooLarge = (_: string): void => {};

/** Sets who is told, in words, that a file is too large to be opened. */
export function onTooLarge(tell: (words: string) => void): void {
  tooLarge = tell;
}

async function readText(file: File | undefined): Promise<string | null> {
  if (!file) return null;
  if (file.size <= LARGEST_BYTES) return file.text();
  tooLarge(
    `'${file.name.slice(0, 60)}' was not opened: it is larger than ${LARGEST_BYTES / 1e6} MB`,
  );
  return null;
}
