import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileOf, GENERATED } from './certified/generated.ts';
import { certifiedModule } from './certified/module.ts';

/** Writes the WebAssembly of certified's stages anew. */
export function writeCertified(root: string): void {
  const file = `${root}/${GENERATED}`;
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, fileOf(certifiedModule()));
}
