import type { ExploreModel } from '../derive.ts';

/** Something that can be copied or saved from the Explore page, as text. */
export interface Export {
  readonly id: string;
  /** Text in the menu. */
  readonly title: string;
  /** File extension without the dot; a test's is `test.ts`. */
  readonly extension: string;
  readonly mime: string;
  text(model: ExploreModel): string;
}
