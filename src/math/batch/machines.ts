import * as doubleDouble from '../float/double-double.ts';
import * as interval from '../float/interval.ts';
import type { Machine } from './register-machine.ts';

/*
 * Plain objects: the properties of a module's own namespace object are getters once it is bundled,
 * and much slower.
 */

export const doubleDoubleMachine: Machine = { ...doubleDouble };
export const intervalMachine: Machine = { ...interval };
