import type { ExploreModel } from '../derive.ts';

/** Something that can be copied or saved from the Explore page, as text. */
export interface Export {
  readonly id: string;
  /** As a menu says it. */
  readonly title: string;
  /** Of a file of it, without the dot; a test's is `test.ts`. */
  readonly extension: string;
  readonly mime: string;
  text(model: ExploreModel): string;
}
