/*
 * The method stable root over arrays, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */

import { lazily } from '../../lazily.ts';
import type { Loop, LoopsByKind } from '../straight-loop.ts';

export const LOOPS = lazily((): LoopsByKind => {
const ONE_OR_NAN = Float64Array.of(1, Number.NaN);
const S = new Float64Array(2);

const planeBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k0 = n[0] as number;
const k3 = n[3] as number;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ((k0 * (ex - k3)) + (k1 * (ey - k4))) + (k2 * (ez - k5));
const v1 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v2 = (-v0) / v1;
t0[i] = v2;
t1[i] = Number.NaN;
if ((!(Math.abs(v2) < 2 ** 511) || !(Math.abs(v1) < 2 ** 511))) {
const v3 = v1 === 0 ? !(v0 - v0 === 0) ? 5 : v0 === 0 ? 4 : 0 : !(v2 - v2 === 0) ? 5 : 6;
const verdict = !(v1 - v1 === 0) ? 5 : v3;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const planeClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k0 = n[0] as number;
const k3 = n[3] as number;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
margin[i] = 1;
const v0 = ((k0 * (ex - k3)) + (k1 * (ey - k4))) + (k2 * (ez - k5));
const v1 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v2 = (-v0) / v1;
if ((!(Math.abs(v2) < 2 ** 511) || !(Math.abs(v1) < 2 ** 511))) {
const v3 = v1 === 0 ? !(v0 - v0 === 0) ? 5 : v0 === 0 ? 4 : 0 : !(v2 - v2 === 0) ? 5 : 6;
const verdict = !(v1 - v1 === 0) ? 5 : v3;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const cylinderBoth: Loop = (n, { count, Ex, Ez, dx, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const z = dz[i] as number;
const v1 = ex - k1;
const v2 = ez - k3;
const v3 = ((2 * x) * v1) + ((2 * z) * v2);
const v4 = (x * x) + (z * z);
const v5 = ((v1 * v1) + (v2 * v2)) - v0;
const v6 = (v3 * v3) - ((4 * v4) * v5);
const v7 = (Math.abs(v3) + Math.sqrt(v6)) * (+(v3 < 0) - 0.5);
const v8 = v7 / v4;
const v9 = v5 / v7;
S[0] = v8;
S[1] = v9;
const v10 = +(v9 < v8);
const v11 = S[0 + v10] as number;
const v12 = S[1 - v10] as number;
t0[i] = v11;
t1[i] = v12;
const v13 = Math.abs(v8) + Math.abs(v9);
if (((((2 ** 1022 <= v13 || v13 <= 0) || v6 === 0) || v4 === 0) || !(Math.abs(v6) <=
1.7976931348623157e+308))) {
const v14 = v3 === 0 ? !(v5 - v5 === 0) ? 5 : v5 === 0 ? 4 : 0 : 1;
const v15 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? 3 : v6 < 0 ? 0 : 6;
const v16 = !(v4 - v4 === 0) ? 5 : v4 === 0 ? !(v3 - v3 === 0) ? 5 : v14 : v15;
const v17 = (-(v4 === 0 ? v5 : v3)) / (v4 === 0 ? v3 : 2 * v4);
const v18 = ((v16 === 1 || v16 === 3) && !(Math.abs(v17) < 2 ** 1022)) ? 6 : v16;
const verdict = v18;
t0[i] = (v16 === 1 || v16 === 3) ? v17 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const cylinderClasses: Loop = (n, { count, Ex, Ez, dx, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const z = dz[i] as number;
const v1 = ex - k1;
const v2 = ez - k3;
const v3 = ((2 * x) * v1) + ((2 * z) * v2);
const v4 = (x * x) + (z * z);
const v5 = ((v1 * v1) + (v2 * v2)) - v0;
const v6 = (v3 * v3) - ((4 * v4) * v5);
margin[i] = v6;
if ((v6 === 0 || !(((Math.abs(v6) < 2 ** 500 && Math.abs(v3) < 2 ** 500) && 2 ** -500 <
Math.abs(v4))))) {
const v7 = v3 === 0 ? !(v5 - v5 === 0) ? 5 : v5 === 0 ? 4 : 0 : 1;
const v8 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? 3 : v6 < 0 ? 0 : 6;
const v9 = !(v4 - v4 === 0) ? 5 : v4 === 0 ? !(v3 - v3 === 0) ? 5 : v7 : v8;
const v10 = (-(v4 === 0 ? v5 : v3)) / (v4 === 0 ? v3 : 2 * v4);
const v11 = ((v9 === 1 || v9 === 3) && !(Math.abs(v10) < 2 ** 1022)) ? 6 : v9;
const verdict = v11;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const coneBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
const v1 = 2 * v0;
const k2 = n[2] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ex - k1;
const v3 = ez - k3;
const v4 = ey - k2;
const v5 = (((2 * x) * v2) + ((2 * z) * v3)) - ((v1 * y) * v4);
const v6 = ((x * x) + (z * z)) - (v0 * (y * y));
const v7 = ((v2 * v2) + (v3 * v3)) - (v0 * (v4 * v4));
const v8 = (v5 * v5) - ((4 * v6) * v7);
const v9 = (Math.abs(v5) + Math.sqrt(v8)) * (+(v5 < 0) - 0.5);
const v10 = v9 / v6;
const v11 = v7 / v9;
S[0] = v10;
S[1] = v11;
const v12 = +(v11 < v10);
const v13 = S[0 + v12] as number;
const v14 = S[1 - v12] as number;
t0[i] = v13;
t1[i] = v14;
const v15 = Math.abs(v10) + Math.abs(v11);
if (((((2 ** 1022 <= v15 || v15 <= 0) || v8 === 0) || v6 === 0) || !(Math.abs(v8) <=
1.7976931348623157e+308))) {
const v16 = v5 === 0 ? !(v7 - v7 === 0) ? 5 : v7 === 0 ? 4 : 0 : 1;
const v17 = !(v8 - v8 === 0) ? 5 : v8 === 0 ? 3 : v8 < 0 ? 0 : 6;
const v18 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? !(v5 - v5 === 0) ? 5 : v16 : v17;
const v19 = (-(v6 === 0 ? v7 : v5)) / (v6 === 0 ? v5 : 2 * v6);
const v20 = ((v18 === 1 || v18 === 3) && !(Math.abs(v19) < 2 ** 1022)) ? 6 : v18;
const verdict = v20;
t0[i] = (v18 === 1 || v18 === 3) ? v19 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const coneClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
const v1 = 2 * v0;
const k2 = n[2] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ex - k1;
const v3 = ez - k3;
const v4 = ey - k2;
const v5 = (((2 * x) * v2) + ((2 * z) * v3)) - ((v1 * y) * v4);
const v6 = ((x * x) + (z * z)) - (v0 * (y * y));
const v7 = ((v2 * v2) + (v3 * v3)) - (v0 * (v4 * v4));
const v8 = (v5 * v5) - ((4 * v6) * v7);
margin[i] = v8;
if ((v8 === 0 || !(((Math.abs(v8) < 2 ** 500 && Math.abs(v5) < 2 ** 500) && 2 ** -500 <
Math.abs(v6))))) {
const v9 = v5 === 0 ? !(v7 - v7 === 0) ? 5 : v7 === 0 ? 4 : 0 : 1;
const v10 = !(v8 - v8 === 0) ? 5 : v8 === 0 ? 3 : v8 < 0 ? 0 : 6;
const v11 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? !(v5 - v5 === 0) ? 5 : v9 : v10;
const v12 = (-(v6 === 0 ? v7 : v5)) / (v6 === 0 ? v5 : 2 * v6);
const v13 = ((v11 === 1 || v11 === 3) && !(Math.abs(v12) < 2 ** 1022)) ? 6 : v11;
const verdict = v13;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const hyperboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k2 = n[2] as number;
const k4 = n[4] as number;
const k0 = n[0] as number;
const v0 = 2 * k0;
const k3 = n[3] as number;
const k1 = n[1] as number;
const v1 = k1 * k1;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ex - k2;
const v3 = ez - k4;
const v4 = ey - k3;
const v5 = (((2 * x) * v2) + ((2 * z) * v3)) - ((v0 * y) * v4);
const v6 = ((x * x) + (z * z)) - (k0 * (y * y));
const v7 = (((v2 * v2) + (v3 * v3)) - (k0 * (v4 * v4))) - v1;
const v8 = (v5 * v5) - ((4 * v6) * v7);
const v9 = (Math.abs(v5) + Math.sqrt(v8)) * (+(v5 < 0) - 0.5);
const v10 = v9 / v6;
const v11 = v7 / v9;
S[0] = v10;
S[1] = v11;
const v12 = +(v11 < v10);
const v13 = S[0 + v12] as number;
const v14 = S[1 - v12] as number;
t0[i] = v13;
t1[i] = v14;
const v15 = Math.abs(v10) + Math.abs(v11);
if (((((2 ** 1022 <= v15 || v15 <= 0) || v8 === 0) || v6 === 0) || !(Math.abs(v8) <=
1.7976931348623157e+308))) {
const v16 = v5 === 0 ? !(v7 - v7 === 0) ? 5 : v7 === 0 ? 4 : 0 : 1;
const v17 = !(v8 - v8 === 0) ? 5 : v8 === 0 ? 3 : v8 < 0 ? 0 : 6;
const v18 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? !(v5 - v5 === 0) ? 5 : v16 : v17;
const v19 = (-(v6 === 0 ? v7 : v5)) / (v6 === 0 ? v5 : 2 * v6);
const v20 = ((v18 === 1 || v18 === 3) && !(Math.abs(v19) < 2 ** 1022)) ? 6 : v18;
const verdict = v20;
t0[i] = (v18 === 1 || v18 === 3) ? v19 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const hyperboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k2 = n[2] as number;
const k4 = n[4] as number;
const k0 = n[0] as number;
const v0 = 2 * k0;
const k3 = n[3] as number;
const k1 = n[1] as number;
const v1 = k1 * k1;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ex - k2;
const v3 = ez - k4;
const v4 = ey - k3;
const v5 = (((2 * x) * v2) + ((2 * z) * v3)) - ((v0 * y) * v4);
const v6 = ((x * x) + (z * z)) - (k0 * (y * y));
const v7 = (((v2 * v2) + (v3 * v3)) - (k0 * (v4 * v4))) - v1;
const v8 = (v5 * v5) - ((4 * v6) * v7);
margin[i] = v8;
if ((v8 === 0 || !(((Math.abs(v8) < 2 ** 500 && Math.abs(v5) < 2 ** 500) && 2 ** -500 <
Math.abs(v6))))) {
const v9 = v5 === 0 ? !(v7 - v7 === 0) ? 5 : v7 === 0 ? 4 : 0 : 1;
const v10 = !(v8 - v8 === 0) ? 5 : v8 === 0 ? 3 : v8 < 0 ? 0 : 6;
const v11 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? !(v5 - v5 === 0) ? 5 : v9 : v10;
const v12 = (-(v6 === 0 ? v7 : v5)) / (v6 === 0 ? v5 : 2 * v6);
const v13 = ((v11 === 1 || v11 === 3) && !(Math.abs(v12) < 2 ** 1022)) ? 6 : v11;
const verdict = v13;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const circleBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
const k3 = n[3] as number;
const k6 = n[6] as number;
const k0 = n[0] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ((k1 * (ex - k4)) + (k2 * (ey - k5))) + (k3 * (ez - k6));
const v1 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v2 = (-v0) / v1;
const v3 = (ex + (v2 * x)) - k4;
const v4 = (ey + (v2 * y)) - k5;
const v5 = (ez + (v2 * z)) - k6;
const v6 = (Math.sqrt(((v3 * v3) + (v4 * v4)) + (v5 * v5))) - k0;
const v7 = +(0 < v6);
t0[i] = v2 * (ONE_OR_NAN[v7] as number);
t1[i] = Number.NaN;
if (((!(Math.abs(v2) < 2 ** 511) || !(Math.abs(v1) < 2 ** 511)) || !(Math.abs(v6) < 2 **
511))) {
const v8 = (v7 !== 0 && v6 - v6 === 0) ? 0 : (!(v6 - v6 === 0) || !(v2 - v2 === 0)) ? 5 : 6;
const v9 = v1 === 0 ? !(v0 - v0 === 0) ? 5 : v0 === 0 ? 4 : 0 : v8;
const verdict = !(v1 - v1 === 0) ? 5 : v9;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const circleClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
const k3 = n[3] as number;
const k6 = n[6] as number;
const k0 = n[0] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ((k1 * (ex - k4)) + (k2 * (ey - k5))) + (k3 * (ez - k6));
const v1 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v2 = (-v0) / v1;
const v3 = (ex + (v2 * x)) - k4;
const v4 = (ey + (v2 * y)) - k5;
const v5 = (ez + (v2 * z)) - k6;
const v6 = (Math.sqrt(((v3 * v3) + (v4 * v4)) + (v5 * v5))) - k0;
const v7 = +(0 < v6);
margin[i] = 1 * (1 - 2 * v7);
if (((!(Math.abs(v2) < 2 ** 511) || !(Math.abs(v1) < 2 ** 511)) || !(Math.abs(v6) < 2 **
511))) {
const v8 = (v7 !== 0 && v6 - v6 === 0) ? 0 : (!(v6 - v6 === 0) || !(v2 - v2 === 0)) ? 5 : 6;
const v9 = v1 === 0 ? !(v0 - v0 === 0) ? 5 : v0 === 0 ? 4 : 0 : v8;
const verdict = !(v1 - v1 === 0) ? 5 : v9;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const squareBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
const k3 = n[3] as number;
const k6 = n[6] as number;
const k0 = n[0] as number;
const v0 = k5 + k0;
const v1 = k6 + k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ((k1 * (ex - k4)) + (k2 * (ey - k5))) + (k3 * (ez - k6));
const v3 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v4 = (-v2) / v3;
const v5 = ey + (v4 * y);
const v6 = k5 - v5;
const v7 = +(0 < v6);
const v8 = v5 - v0;
const v9 = +(0 < v8);
const v10 = ez + (v4 * z);
const v11 = k6 - v10;
const v12 = +(0 < v11);
const v13 = v10 - v1;
const v14 = +(0 < v13);
const v15 = v4 * (ONE_OR_NAN[(((v7 | v9) | v12) | v14)] as number);
t0[i] = v15;
t1[i] = Number.NaN;
if ((((((!(Math.abs(v4) < 2 ** 511) || !(Math.abs(v3) < 2 ** 511)) || !(Math.abs(v6) < 2 **
511)) || !(Math.abs(v8) < 2 ** 511)) || !(Math.abs(v11) < 2 ** 511)) || !(Math.abs(v13) < 2 **
511))) {
const v16 = ((((!(v6 - v6 === 0) || !(v8 - v8 === 0)) || !(v11 - v11 === 0)) || !(v13 - v13 ===
0)) || !(v4 - v4 === 0)) ? 5 : 6;
const v17 = ((((v7 !== 0 && v6 - v6 === 0) || (v9 !== 0 && v8 - v8 === 0)) || (v12 !== 0 &&
v11 - v11 === 0)) || (v14 !== 0 && v13 - v13 === 0)) ? 0 : v16;
const v18 = v3 === 0 ? !(v2 - v2 === 0) ? 5 : v2 === 0 ? 4 : 0 : v17;
const verdict = !(v3 - v3 === 0) ? 5 : v18;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const squareClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k4 = n[4] as number;
const k2 = n[2] as number;
const k5 = n[5] as number;
const k3 = n[3] as number;
const k6 = n[6] as number;
const k0 = n[0] as number;
const v0 = k5 + k0;
const v1 = k6 + k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ((k1 * (ex - k4)) + (k2 * (ey - k5))) + (k3 * (ez - k6));
const v3 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v4 = (-v2) / v3;
const v5 = ey + (v4 * y);
const v6 = k5 - v5;
const v7 = +(0 < v6);
const v8 = v5 - v0;
const v9 = +(0 < v8);
const v10 = ez + (v4 * z);
const v11 = k6 - v10;
const v12 = +(0 < v11);
const v13 = v10 - v1;
const v14 = +(0 < v13);
margin[i] = 1 * (1 - 2 * (((v7 | v9) | v12) | v14));
if ((((((!(Math.abs(v4) < 2 ** 511) || !(Math.abs(v3) < 2 ** 511)) || !(Math.abs(v6) < 2 **
511)) || !(Math.abs(v8) < 2 ** 511)) || !(Math.abs(v11) < 2 ** 511)) || !(Math.abs(v13) < 2 **
511))) {
const v15 = ((((!(v6 - v6 === 0) || !(v8 - v8 === 0)) || !(v11 - v11 === 0)) || !(v13 - v13 ===
0)) || !(v4 - v4 === 0)) ? 5 : 6;
const v16 = ((((v7 !== 0 && v6 - v6 === 0) || (v9 !== 0 && v8 - v8 === 0)) || (v12 !== 0 &&
v11 - v11 === 0)) || (v14 !== 0 && v13 - v13 === 0)) ? 0 : v15;
const v17 = v3 === 0 ? !(v2 - v2 === 0) ? 5 : v2 === 0 ? 4 : 0 : v16;
const verdict = !(v3 - v3 === 0) ? 5 : v17;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const sphereBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k2 = n[2] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v1 = ex - k1;
const v2 = ey - k2;
const v3 = ez - k3;
const v4 = (((2 * x) * v1) + ((2 * y) * v2)) + ((2 * z) * v3);
const v5 = ((x * x) + (y * y)) + (z * z);
const v6 = (((v1 * v1) + (v2 * v2)) + (v3 * v3)) - v0;
const v7 = (v4 * v4) - ((4 * v5) * v6);
const v8 = (Math.abs(v4) + Math.sqrt(v7)) * (+(v4 < 0) - 0.5);
const v9 = v8 / v5;
const v10 = v6 / v8;
S[0] = v9;
S[1] = v10;
const v11 = +(v10 < v9);
const v12 = S[0 + v11] as number;
const v13 = S[1 - v11] as number;
t0[i] = v12;
t1[i] = v13;
const v14 = Math.abs(v9) + Math.abs(v10);
if (((((2 ** 1022 <= v14 || v14 <= 0) || v7 === 0) || v5 === 0) || !(Math.abs(v7) <=
1.7976931348623157e+308))) {
const v15 = v4 === 0 ? !(v6 - v6 === 0) ? 5 : v6 === 0 ? 4 : 0 : 1;
const v16 = !(v7 - v7 === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v17 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? !(v4 - v4 === 0) ? 5 : v15 : v16;
const v18 = (-(v5 === 0 ? v6 : v4)) / (v5 === 0 ? v4 : 2 * v5);
const v19 = ((v17 === 1 || v17 === 3) && !(Math.abs(v18) < 2 ** 1022)) ? 6 : v17;
const verdict = v19;
t0[i] = (v17 === 1 || v17 === 3) ? v18 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const sphereClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k2 = n[2] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v1 = ex - k1;
const v2 = ey - k2;
const v3 = ez - k3;
const v4 = (((2 * x) * v1) + ((2 * y) * v2)) + ((2 * z) * v3);
const v5 = ((x * x) + (y * y)) + (z * z);
const v6 = (((v1 * v1) + (v2 * v2)) + (v3 * v3)) - v0;
const v7 = (v4 * v4) - ((4 * v5) * v6);
margin[i] = v7;
if ((v7 === 0 || !(((Math.abs(v7) < 2 ** 500 && Math.abs(v4) < 2 ** 500) && 2 ** -500 <
Math.abs(v5))))) {
const v8 = v4 === 0 ? !(v6 - v6 === 0) ? 5 : v6 === 0 ? 4 : 0 : 1;
const v9 = !(v7 - v7 === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v10 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? !(v4 - v4 === 0) ? 5 : v8 : v9;
const v11 = (-(v5 === 0 ? v6 : v4)) / (v5 === 0 ? v4 : 2 * v5);
const v12 = ((v10 === 1 || v10 === 3) && !(Math.abs(v11) < 2 ** 1022)) ? 6 : v10;
const verdict = v12;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const paraboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { t0, t1 } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const k2 = n[2] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ex - k1;
const v1 = ez - k3;
const v2 = (((2 * x) * v0) + ((2 * z) * v1)) - (k0 * y);
const v3 = (x * x) + (z * z);
const v4 = ((v0 * v0) + (v1 * v1)) - (k0 * (ey - k2));
const v5 = (v2 * v2) - ((4 * v3) * v4);
const v6 = (Math.abs(v2) + Math.sqrt(v5)) * (+(v2 < 0) - 0.5);
const v7 = v6 / v3;
const v8 = v4 / v6;
S[0] = v7;
S[1] = v8;
const v9 = +(v8 < v7);
const v10 = S[0 + v9] as number;
const v11 = S[1 - v9] as number;
t0[i] = v10;
t1[i] = v11;
const v12 = Math.abs(v7) + Math.abs(v8);
if (((((2 ** 1022 <= v12 || v12 <= 0) || v5 === 0) || v3 === 0) || !(Math.abs(v5) <=
1.7976931348623157e+308))) {
const v13 = v2 === 0 ? !(v4 - v4 === 0) ? 5 : v4 === 0 ? 4 : 0 : 1;
const v14 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? 3 : v5 < 0 ? 0 : 6;
const v15 = !(v3 - v3 === 0) ? 5 : v3 === 0 ? !(v2 - v2 === 0) ? 5 : v13 : v14;
const v16 = (-(v3 === 0 ? v4 : v2)) / (v3 === 0 ? v2 : 2 * v3);
const v17 = ((v15 === 1 || v15 === 3) && !(Math.abs(v16) < 2 ** 1022)) ? 6 : v15;
const verdict = v17;
t0[i] = (v15 === 1 || v15 === 3) ? v16 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const paraboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const k3 = n[3] as number;
const k0 = n[0] as number;
const k2 = n[2] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ex - k1;
const v1 = ez - k3;
const v2 = (((2 * x) * v0) + ((2 * z) * v1)) - (k0 * y);
const v3 = (x * x) + (z * z);
const v4 = ((v0 * v0) + (v1 * v1)) - (k0 * (ey - k2));
const v5 = (v2 * v2) - ((4 * v3) * v4);
margin[i] = v5;
if ((v5 === 0 || !(((Math.abs(v5) < 2 ** 500 && Math.abs(v2) < 2 ** 500) && 2 ** -500 <
Math.abs(v3))))) {
const v6 = v2 === 0 ? !(v4 - v4 === 0) ? 5 : v4 === 0 ? 4 : 0 : 1;
const v7 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? 3 : v5 < 0 ? 0 : 6;
const v8 = !(v3 - v3 === 0) ? 5 : v3 === 0 ? !(v2 - v2 === 0) ? 5 : v6 : v7;
const v9 = (-(v3 === 0 ? v4 : v2)) / (v3 === 0 ? v2 : 2 * v3);
const v10 = ((v8 === 1 || v8 === 3) && !(Math.abs(v9) < 2 ** 1022)) ? 6 : v8;
const verdict = v10;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

return {
plane: { both: planeBoth, classes: planeClasses },
cylinder: { both: cylinderBoth, classes: cylinderClasses },
cone: { both: coneBoth, classes: coneClasses },
hyperboloid: { both: hyperboloidBoth, classes: hyperboloidClasses },
circle: { both: circleBoth, classes: circleClasses },
square: { both: squareBoth, classes: squareClasses },
sphere: { both: sphereBoth, classes: sphereClasses },
paraboloid: { both: paraboloidBoth, classes: paraboloidClasses },
};
});
