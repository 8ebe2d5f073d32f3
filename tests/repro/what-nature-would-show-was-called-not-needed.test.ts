import { expect, test } from 'vitest';
import { planEffects } from '../../src/scene/effects/plan.ts';
import { colouredGlass } from '../../src/scene/presets/coloured-glass.ts';
import { plain } from '../../src/scene/presets/plain.ts';

/*
 * Of coloured glass above a floor the ledger said that shadows are not needed, since all else is
 * glass. Real glass of that colour would cast one: light goes through it here, which is a
 * simplification.
 */
test('coloured glass casts no shadow by a simplification', () => {
  const shadow = planEffects(colouredGlass.scene).find(({ id }) => id === 'shadow');
  expect(shadow).toMatchObject({ needed: false, leftOut: true });
  expect(shadow?.reason).toBe(
    'glass is let through: a simplification; floor cannot shade itself on the side that is seen',
  );
});

test('where nothing could cast one it is not needed', () => {
  const shadow = planEffects(plain.scene).find(({ id }) => id === 'shadow');
  expect(shadow).toMatchObject({ needed: false, leftOut: false });
  expect(shadow?.reason).not.toContain('simplification');
});
