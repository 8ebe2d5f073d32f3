import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/*
 * Licences ask that their text goes along with the code. Which packages are in a distribution is
 * read from what was bundled, so that none is forgotten.
 */

const FONTS = new URL('../src/ui/fonts/', import.meta.url);
const TITLE = `Graze contains the following packages and fonts, under these licences.\n`;

/** Directory and name of the package that a bundled module is of; null for a module of our own. */
function packageOf(id: string): readonly [directory: string, name: string] | null {
  const found = /^(.*[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+))[\\/]/.exec(id);
  return found?.[1] && found[2] ? [found[1], found[2].replace('\\', '/')] : null;
}

function noticeOf(directory: string, name: string): string {
  const { version, license } = JSON.parse(readFileSync(join(directory, 'package.json'), 'utf8'));
  const file = readdirSync(directory).find((one) => /^licen[cs]e/i.test(one));
  if (!file) throw new Error(`${name} is bundled, and has no licence file to go along with it`);
  return notice(`${name} ${version} (${license})`, readFileSync(join(directory, file), 'utf8'));
}

const notice = (title: string, text: string): string =>
  `${'-'.repeat(80)}\n${title}\n\n${text.trim()}\n`;

/**
 * Collects packages from the page and, as `inWorkers`, from the workers, which are built before it.
 */
export function thirdParty(form: 'file' | 'in the page'): {
  readonly page: Plugin;
  readonly inWorkers: Plugin;
} {
  const packages = new Map<string, string>();
  const collect: Plugin['renderChunk'] = (_, { moduleIds }) => {
    for (const id of moduleIds) {
      const [directory, name] = packageOf(id) ?? [];
      if (directory && name) packages.set(name, directory);
    }
    return null;
  };
  const text = (): string => {
    const names = [...packages.keys()].sort();
    const font = new URL('OFL.txt', FONTS);
    if (!existsSync(font)) throw new Error('the licence of the font is missing');
    return [
      TITLE,
      ...names.map((name) => noticeOf(packages.get(name) as string, name)),
      notice('STIX Two Math, a subset (OFL-1.1)', readFileSync(font, 'utf8')),
    ].join('\n');
  };
  return {
    inWorkers: { name: 'third-party-in-workers', renderChunk: collect },
    page: {
      name: 'third-party',
      apply: 'build',
      enforce: 'post',
      renderChunk: collect,
      generateBundle(_, bundle) {
        if (form === 'file') {
          this.emitFile({ type: 'asset', fileName: 'THIRD-PARTY.txt', source: text() });
          return;
        }
        const page = bundle['index.html'];
        if (page?.type !== 'asset') throw new Error('there is no page to put the licences into');
        const kept = `<template id="third-party"><pre>${escaped(text())}</pre></template>`;
        page.source = String(page.source).replace('</body>', () => `${kept}</body>`);
      },
    },
  };
}

const escaped = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
