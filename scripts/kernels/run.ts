import { writeTrees } from './trees.ts';

/* `npm run kernels`: writes the committed files of generated kernels anew. */
writeTrees(process.cwd());
