import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileOf, GENERATED } from './certified/generated.ts';
import { certifiedModule, oneRayText } from './certified/module.ts';
import { ONE_RAY } from './certified/one-ray.ts';

/** Writes what is made of certified's stages anew. */
export function writeCertified(root: string): void {
  const file = `${root}/${GENERATED}`;
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, fileOf(certifiedModule()));
  writeFileSync(`${root}/${ONE_RAY}`, oneRayText());
}
