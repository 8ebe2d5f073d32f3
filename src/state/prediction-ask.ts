/** Ids of the questions that can be asked while the results are hidden, as a link has them. */
export const ASKS = ['points', 'where', 'first', 'sign'] as const;
export type Ask = (typeof ASKS)[number];

export const isAsk = (id: string): id is Ask => (ASKS as readonly string[]).includes(id);
