import { describe } from 'vitest';
import type { ShapeDefinition } from '../../../src/math/shapes/define.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { contractOf } from './contract.ts';

const DEFINITIONS = SHAPES as unknown as readonly ShapeDefinition<Shape>[];

describe.each(DEFINITIONS.map((definition) => [definition.kind, definition] as const))(
  '%s',
  (_kind, definition) => contractOf(definition),
);
