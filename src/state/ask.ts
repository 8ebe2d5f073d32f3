/** What a person is asked to predict while the results are hidden; ids as a link has them. */
export const ASKS = ['points', 'where', 'first', 'sign'] as const;
export type Ask = (typeof ASKS)[number];

export const isAsk = (id: string): id is Ask => (ASKS as readonly string[]).includes(id);
