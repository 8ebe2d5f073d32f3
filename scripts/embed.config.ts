import { cpSync, existsSync } from 'node:fs';
import type { Plugin } from 'vite';
import { defineConfig } from 'vite';
import { thirdParty } from './third-party.ts';

/* Builds the element <graze-ray>: `vite build -c scripts/embed.config.ts`, to dist/embed. */

/** In a shadow tree the element is what the root is in a document, and its content is the page. */
const forShadow = (css: string): string =>
  css
    .replace(/@font-face\s*\{[^}]*\}/g, '')
    .replace(/(^|[\s,}])(?:html|body)(?=[\s,{])/g, '$1.embed-root')
    .replace(/:root((?:\[[^\]]*\]|:not\([^)]*\))*)/g, (_, of: string) =>
      of ? `:host(${of})` : ':host',
    );

const NO_STYLE = '\0no-style';

/**
 * Style sheets come as texts, which src/embed/styles.ts lists; what a module imports for its effect
 * would go into the host's document.
 */
const styles: Plugin = {
  name: 'styles-for-shadow',
  enforce: 'pre',
  resolveId: (source) => (source.endsWith('.css') ? NO_STYLE : null),
  load: (id) => (id === NO_STYLE ? '' : null),
  transform(code, id) {
    return id.endsWith('.css?inline') ? forShadow(code) : null;
  },
};

/** A site has it too, under embed/, where the lines that its dialog makes look for it. */
const besideSite: Plugin = {
  name: 'beside-site',
  closeBundle() {
    if (existsSync('dist/site')) cpSync('dist/embed', 'dist/site/embed', { recursive: true });
  },
};

export default defineConfig({
  base: './',
  // As in vite.config.ts.
  resolve: { alias: [{ find: /^lit$/, replacement: 'lit/html.js' }] },
  plugins: [styles, thirdParty('file').page, besideSite],
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist/embed',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 700,
    // It would put links into the host's document.
    modulePreload: false,
    rolldownOptions: {
      input: { graze: 'src/embed.ts' },
      preserveEntrySignatures: 'exports-only',
      treeshake: { moduleSideEffects: [{ test: /\/src\/math\//, sideEffects: false }] },
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: 'graze-[name]-[hash].js',
        assetFileNames: 'graze-[name]-[hash][extname]',
      },
    },
  },
});
