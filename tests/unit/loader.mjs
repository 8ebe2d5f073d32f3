// A loader for Node's own imports: TypeScript without its types.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { transform } from 'sucrase';

export function load(url, context, next) {
  if (!url.endsWith('.ts')) return next(url, context);
  const filePath = fileURLToPath(url);
  const { code: source } = transform(readFileSync(filePath, 'utf8'), {
    filePath,
    transforms: ['typescript'],
    disableESTransforms: true,
  });
  return { format: 'module', shortCircuit: true, source };
}
