import { writeCertified } from './certified.ts';
import { writeTrees } from './trees.ts';

/* `npm run kernels`: writes the committed files of generated kernels anew. */
writeTrees(process.cwd());
writeCertified(process.cwd());
