/** A map that is ready to be opened, with one sentence on what it shows. */
interface ReadyMap {
  readonly id: string;
  readonly title: string;
  readonly sentence: string;
  readonly link: string;
}

export const READY_MAPS: readonly ReadyMap[] = [];
