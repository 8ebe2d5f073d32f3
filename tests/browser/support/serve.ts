import { ISOLATED, SHARED, serveBuilt } from '../../serve-site.ts';

/** Once before all tests; what it returns is called after them. */
export default async function serve(): Promise<() => void> {
  const site = process.env.E2E_SITE ?? 'dist/site';
  const port = Number(process.env.E2E_PORT ?? 4173);
  const plain = await serveBuilt({ folder: '/', headers: SHARED, port, site });
  const isolated = await serveBuilt({ folder: '/', headers: ISOLATED, site });
  process.env.E2E_ISOLATED = isolated.url;
  return () => {
    for (const { close } of [plain, isolated]) close();
  };
}
