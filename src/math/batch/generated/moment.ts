/*
 * The method moment over arrays, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */

import { lazily } from '../../lazily.ts';
import type { Loop, LoopsByKind } from '../straight-loop.ts';

export const LOOPS = lazily((): LoopsByKind => {
const ONE_OR_NAN = Float64Array.of(1, Number.NaN);
const S = new Float64Array(8);

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
const v0 = ex - k3;
const v1 = ey - k4;
const v2 = ez - k5;
const v3 = ((k0 * v0) + (k1 * v1)) + (k2 * v2);
const v4 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v5 = (-v3) / v4;
t0[i] = v5;
t1[i] = Number.NaN;
const v6 = (z * v0) - (x * v2);
const v7 = (x * v1) - (y * v0);
const v8 = (v6 * k2) - (v7 * k1);
S[0] = v8;
S[1] = -v8;
const v9 = +(v4 < 0);
const v10 = S[0 + v9] as number;
S[2] = v4;
S[3] = -v4;
const v11 = S[2 + v9] as number;
const v12 = (y * v2) - (z * v1);
const v13 = (v7 * k0) - (v12 * k2);
S[4] = v13;
S[5] = -v13;
const v14 = S[4 + v9] as number;
const v15 = (v12 * k1) - (v6 * k0);
S[6] = v15;
S[7] = -v15;
const v16 = S[6 + v9] as number;
if (((((!(Math.abs(v5) < 2 ** 511) || !(Math.abs(v4) < 2 ** 511)) || !(Math.abs(k3 + (v10 /
v11)) < 2 ** 511)) || !(Math.abs(k4 + (v14 / v11)) < 2 ** 511)) || !(Math.abs(k5 + (v16 /
v11)) < 2 ** 511))) {
const v17 = v4 === 0 ? !(v3 - v3 === 0) ? 5 : v3 === 0 ? 4 : 0 : !(v5 - v5 === 0) ? 5 : 6;
const verdict = !(v4 - v4 === 0) ? 5 : v17;
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
const v0 = ex - k3;
const v1 = ey - k4;
const v2 = ez - k5;
const v3 = ((k0 * v0) + (k1 * v1)) + (k2 * v2);
const v4 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v5 = (-v3) / v4;
const v6 = (z * v0) - (x * v2);
const v7 = (x * v1) - (y * v0);
const v8 = (v6 * k2) - (v7 * k1);
S[0] = v8;
S[1] = -v8;
const v9 = +(v4 < 0);
const v10 = S[0 + v9] as number;
S[2] = v4;
S[3] = -v4;
const v11 = S[2 + v9] as number;
const v12 = (y * v2) - (z * v1);
const v13 = (v7 * k0) - (v12 * k2);
S[4] = v13;
S[5] = -v13;
const v14 = S[4 + v9] as number;
const v15 = (v12 * k1) - (v6 * k0);
S[6] = v15;
S[7] = -v15;
const v16 = S[6 + v9] as number;
if (((((!(Math.abs(v5) < 2 ** 511) || !(Math.abs(v4) < 2 ** 511)) || !(Math.abs(k3 + (v10 /
v11)) < 2 ** 511)) || !(Math.abs(k4 + (v14 / v11)) < 2 ** 511)) || !(Math.abs(k5 + (v16 /
v11)) < 2 ** 511))) {
const v17 = v4 === 0 ? !(v3 - v3 === 0) ? 5 : v3 === 0 ? 4 : 0 : !(v5 - v5 === 0) ? 5 : 6;
const verdict = !(v4 - v4 === 0) ? 5 : v17;
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
const v4 = Math.abs(v3);
const v5 = (x * x) + (z * z);
const v6 = (z * v1) - (x * v2);
const v7 = 4 * ((v0 * v5) - (v6 * v6));
const v8 = (v4 + Math.sqrt(v7)) * (+(v3 < 0) - 0.5);
const v9 = v8 / v5;
const v10 = ((v1 * v1) + (v2 * v2)) - v0;
const v11 = v10 / v8;
S[0] = v9;
S[1] = v11;
const v12 = +(v11 < v9);
const v13 = S[0 + v12] as number;
const v14 = S[1 - v12] as number;
t0[i] = v13;
t1[i] = v14;
const v15 = Math.abs(v9) + Math.abs(v11);
if (((((((2 ** 1022 <= v15 || v15 <= 0) || v7 === 0) || v5 === 0) || !(Math.abs(v7) <=
1.7976931348623157e+308)) || !(v4 <= 1.7976931348623157e+308)) || !(Math.abs(v10) <=
1.7976931348623157e+308))) {
const v16 = v3 === 0 ? !(v10 - v10 === 0) ? 5 : v10 === 0 ? 4 : 0 : 1;
const v17 = !(v7 - v7 === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v18 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? !(v3 - v3 === 0) ? 5 : v16 : v17;
const v19 = (-(v5 === 0 ? v10 : v3)) / (v5 === 0 ? v3 : 2 * v5);
const v20 = ((v18 === 1 || v18 === 3) && !(Math.abs(v19) < 2 ** 1022)) ? 6 : v18;
const verdict = v20;
t0[i] = (v18 === 1 || v18 === 3) ? v19 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const cylinderClasses: Loop = (n, { count, Ex, Ez, dx, dz }, out, marked) => {
const { margin } = out;
const k0 = n[0] as number;
const v0 = k0 * k0;
const k1 = n[1] as number;
const k3 = n[3] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const z = dz[i] as number;
const v1 = (x * x) + (z * z);
const v2 = ex - k1;
const v3 = ez - k3;
const v4 = (z * v2) - (x * v3);
const v5 = 4 * ((v0 * v1) - (v4 * v4));
margin[i] = v5;
const v6 = Math.abs(v5);
const v7 = ((2 * x) * v2) + ((2 * z) * v3);
const v8 = Math.abs(v1);
const v9 = ((v2 * v2) + (v3 * v3)) - v0;
if ((v5 === 0 || !((((((v6 < 2 ** 500 && Math.abs(v7) < 2 ** 500) && 2 ** -500 < v8) &&
Math.abs(v9) < 2 ** 500) && 2 ** -500 < v6) && v8 < 2 ** 500)))) {
const v10 = v7 === 0 ? !(v9 - v9 === 0) ? 5 : v9 === 0 ? 4 : 0 : 1;
const v11 = !(v5 - v5 === 0) ? 5 : v5 === 0 ? 3 : v5 < 0 ? 0 : 6;
const v12 = !(v1 - v1 === 0) ? 5 : v1 === 0 ? !(v7 - v7 === 0) ? 5 : v10 : v11;
const v13 = (-(v1 === 0 ? v9 : v7)) / (v1 === 0 ? v7 : 2 * v1);
const v14 = ((v12 === 1 || v12 === 3) && !(Math.abs(v13) < 2 ** 1022)) ? 6 : v12;
const verdict = v14;
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
const v6 = Math.abs(v5);
const v7 = (y * v3) - (z * v4);
const v8 = (x * v4) - (y * v2);
const v9 = (z * v2) - (x * v3);
const v10 = 4 * ((v0 * ((v7 * v7) + (v8 * v8))) - (v9 * v9));
const v11 = (v6 + Math.sqrt(v10)) * (+(v5 < 0) - 0.5);
const v12 = ((x * x) + (z * z)) - (v0 * (y * y));
const v13 = v11 / v12;
const v14 = ((v2 * v2) + (v3 * v3)) - (v0 * (v4 * v4));
const v15 = v14 / v11;
S[0] = v13;
S[1] = v15;
const v16 = +(v15 < v13);
const v17 = S[0 + v16] as number;
const v18 = S[1 - v16] as number;
t0[i] = v17;
t1[i] = v18;
const v19 = Math.abs(v13) + Math.abs(v15);
if ((((((((2 ** 1022 <= v19 || v19 <= 0) || v10 === 0) || v12 === 0) || !(Math.abs(v10) <=
1.7976931348623157e+308)) || !(Math.abs(v12) <= 1.7976931348623157e+308)) || !(v6 <=
1.7976931348623157e+308)) || !(Math.abs(v14) <= 1.7976931348623157e+308))) {
const v20 = v5 === 0 ? !(v14 - v14 === 0) ? 5 : v14 === 0 ? 4 : 0 : 1;
const v21 = !(v10 - v10 === 0) ? 5 : v10 === 0 ? 3 : v10 < 0 ? 0 : 6;
const v22 = !(v12 - v12 === 0) ? 5 : v12 === 0 ? !(v5 - v5 === 0) ? 5 : v20 : v21;
const v23 = (-(v12 === 0 ? v14 : v5)) / (v12 === 0 ? v5 : 2 * v12);
const v24 = ((v22 === 1 || v22 === 3) && !(Math.abs(v23) < 2 ** 1022)) ? 6 : v22;
const verdict = v24;
t0[i] = (v22 === 1 || v22 === 3) ? v23 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const coneClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k0 = n[0] as number;
const v0 = k0 * k0;
const k3 = n[3] as number;
const k2 = n[2] as number;
const k1 = n[1] as number;
const v1 = 2 * v0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ez - k3;
const v3 = ey - k2;
const v4 = (y * v2) - (z * v3);
const v5 = ex - k1;
const v6 = (x * v3) - (y * v5);
const v7 = (z * v5) - (x * v2);
const v8 = 4 * ((v0 * ((v4 * v4) + (v6 * v6))) - (v7 * v7));
margin[i] = v8;
const v9 = Math.abs(v8);
const v10 = (((2 * x) * v5) + ((2 * z) * v2)) - ((v1 * y) * v3);
const v11 = ((x * x) + (z * z)) - (v0 * (y * y));
const v12 = Math.abs(v11);
const v13 = ((v5 * v5) + (v2 * v2)) - (v0 * (v3 * v3));
if ((v8 === 0 || !((((((v9 < 2 ** 500 && Math.abs(v10) < 2 ** 500) && 2 ** -500 < v12) &&
Math.abs(v13) < 2 ** 500) && 2 ** -500 < v9) && v12 < 2 ** 500)))) {
const v14 = v10 === 0 ? !(v13 - v13 === 0) ? 5 : v13 === 0 ? 4 : 0 : 1;
const v15 = !(v8 - v8 === 0) ? 5 : v8 === 0 ? 3 : v8 < 0 ? 0 : 6;
const v16 = !(v11 - v11 === 0) ? 5 : v11 === 0 ? !(v10 - v10 === 0) ? 5 : v14 : v15;
const v17 = (-(v11 === 0 ? v13 : v10)) / (v11 === 0 ? v10 : 2 * v11);
const v18 = ((v16 === 1 || v16 === 3) && !(Math.abs(v17) < 2 ** 1022)) ? 6 : v16;
const verdict = v18;
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
const v6 = Math.abs(v5);
const v7 = ((x * x) + (z * z)) - (k0 * (y * y));
const v8 = (y * v3) - (z * v4);
const v9 = (x * v4) - (y * v2);
const v10 = (z * v2) - (x * v3);
const v11 = ((v1 * v7) + (k0 * ((v8 * v8) + (v9 * v9)))) - (v10 * v10);
const v12 = 4 * v11;
const v13 = (v6 + Math.sqrt(v12)) * (+(v5 < 0) - 0.5);
const v14 = v13 / v7;
const v15 = (((v2 * v2) + (v3 * v3)) - (k0 * (v4 * v4))) - v1;
const v16 = v15 / v13;
S[0] = v14;
S[1] = v16;
const v17 = +(v16 < v14);
const v18 = S[0 + v17] as number;
const v19 = S[1 - v17] as number;
t0[i] = v18;
t1[i] = v19;
const v20 = Math.abs(v14) + Math.abs(v16);
if (((((((2 ** 1022 <= v20 || v20 <= 0) || v12 === 0) || v7 === 0) || !(Math.abs(v12) <=
1.7976931348623157e+308)) || !(v6 <= 1.7976931348623157e+308)) || !(Math.abs(v15) <=
1.7976931348623157e+308))) {
const v21 = v5 === 0 ? !(v15 - v15 === 0) ? 5 : v15 === 0 ? 4 : 0 : 1;
const v22 = !(v12 - v12 === 0) ? 5 : v12 === 0 ? 3 : v12 < 0 ? 0 : 6;
const v23 = !(v7 - v7 === 0) ? 5 : v7 === 0 ? !(v5 - v5 === 0) ? 5 : v21 : v22;
const v24 = (-(v7 === 0 ? v15 : v5)) / (v7 === 0 ? v5 : 2 * v7);
const v25 = ((v23 === 1 || v23 === 3) && !(Math.abs(v24) < 2 ** 1022)) ? 6 : v23;
const verdict = v25;
t0[i] = (v23 === 1 || v23 === 3) ? v24 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const hyperboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k1 = n[1] as number;
const v0 = k1 * k1;
const k0 = n[0] as number;
const k4 = n[4] as number;
const k3 = n[3] as number;
const k2 = n[2] as number;
const v1 = 2 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ((x * x) + (z * z)) - (k0 * (y * y));
const v3 = ez - k4;
const v4 = ey - k3;
const v5 = (y * v3) - (z * v4);
const v6 = ex - k2;
const v7 = (x * v4) - (y * v6);
const v8 = (z * v6) - (x * v3);
const v9 = ((v0 * v2) + (k0 * ((v5 * v5) + (v7 * v7)))) - (v8 * v8);
const v10 = 4 * v9;
margin[i] = v10;
const v11 = Math.abs(v10);
const v12 = (((2 * x) * v6) + ((2 * z) * v3)) - ((v1 * y) * v4);
const v13 = Math.abs(v2);
const v14 = (((v6 * v6) + (v3 * v3)) - (k0 * (v4 * v4))) - v0;
if ((v10 === 0 || !((((((v11 < 2 ** 500 && Math.abs(v12) < 2 ** 500) && 2 ** -500 < v13) &&
Math.abs(v14) < 2 ** 500) && 2 ** -500 < v11) && v13 < 2 ** 500)))) {
const v15 = v12 === 0 ? !(v14 - v14 === 0) ? 5 : v14 === 0 ? 4 : 0 : 1;
const v16 = !(v10 - v10 === 0) ? 5 : v10 === 0 ? 3 : v10 < 0 ? 0 : 6;
const v17 = !(v2 - v2 === 0) ? 5 : v2 === 0 ? !(v12 - v12 === 0) ? 5 : v15 : v16;
const v18 = (-(v2 === 0 ? v14 : v12)) / (v2 === 0 ? v12 : 2 * v2);
const v19 = ((v17 === 1 || v17 === 3) && !(Math.abs(v18) < 2 ** 1022)) ? 6 : v17;
const verdict = v19;
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
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v1 = ex - k4;
const v2 = ey - k5;
const v3 = ez - k6;
const v4 = ((k1 * v1) + (k2 * v2)) + (k3 * v3);
const v5 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v6 = (-v4) / v5;
const v7 = (z * v1) - (x * v3);
const v8 = (x * v2) - (y * v1);
const v9 = (v7 * k3) - (v8 * k2);
S[0] = v9;
S[1] = -v9;
const v10 = +(v5 < 0);
const v11 = S[0 + v10] as number;
const v12 = (y * v3) - (z * v2);
const v13 = (v8 * k1) - (v12 * k3);
S[2] = v13;
S[3] = -v13;
const v14 = S[2 + v10] as number;
const v15 = (v12 * k2) - (v7 * k1);
S[4] = v15;
S[5] = -v15;
const v16 = S[4 + v10] as number;
S[6] = v5;
S[7] = -v5;
const v17 = S[6 + v10] as number;
const v18 = (((v11 * v11) + (v14 * v14)) + (v16 * v16)) - (v0 * (v17 * v17));
const v19 = +(0 < v18);
t0[i] = v6 * (ONE_OR_NAN[v19] as number);
t1[i] = Number.NaN;
if ((((((!(Math.abs(v6) < 2 ** 511) || !(Math.abs(v5) < 2 ** 511)) || !(Math.abs(v18) < 2 **
511)) || !(Math.abs(k4 + (v11 / v17)) < 2 ** 511)) || !(Math.abs(k5 + (v14 / v17)) < 2 **
511)) || !(Math.abs(k6 + (v16 / v17)) < 2 ** 511))) {
const v20 = (!(v18 - v18 === 0) || !(v6 - v6 === 0)) ? 5 : 6;
const v21 = v5 === 0 ? !(v4 - v4 === 0) ? 5 : v4 === 0 ? 4 : 0 : (v19 !== 0 && v18 - v18 ===
0) ? 0 : v20;
const verdict = !(v5 - v5 === 0) ? 5 : v21;
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
const v0 = k0 * k0;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v1 = ex - k4;
const v2 = ez - k6;
const v3 = (z * v1) - (x * v2);
const v4 = ey - k5;
const v5 = (x * v4) - (y * v1);
const v6 = (v3 * k3) - (v5 * k2);
S[0] = v6;
S[1] = -v6;
const v7 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v8 = +(v7 < 0);
const v9 = S[0 + v8] as number;
const v10 = (y * v2) - (z * v4);
const v11 = (v5 * k1) - (v10 * k3);
S[2] = v11;
S[3] = -v11;
const v12 = S[2 + v8] as number;
const v13 = (v10 * k2) - (v3 * k1);
S[4] = v13;
S[5] = -v13;
const v14 = S[4 + v8] as number;
S[6] = v7;
S[7] = -v7;
const v15 = S[6 + v8] as number;
const v16 = (((v9 * v9) + (v12 * v12)) + (v14 * v14)) - (v0 * (v15 * v15));
const v17 = +(0 < v16);
margin[i] = 1 * (1 - 2 * v17);
const v18 = ((k1 * v1) + (k2 * v4)) + (k3 * v2);
const v19 = (-v18) / v7;
if ((((((!(Math.abs(v19) < 2 ** 511) || !(Math.abs(v7) < 2 ** 511)) || !(Math.abs(v16) < 2 **
511)) || !(Math.abs(k4 + (v9 / v15)) < 2 ** 511)) || !(Math.abs(k5 + (v12 / v15)) < 2 **
511)) || !(Math.abs(k6 + (v14 / v15)) < 2 ** 511))) {
const v20 = (!(v16 - v16 === 0) || !(v19 - v19 === 0)) ? 5 : 6;
const v21 = v7 === 0 ? !(v18 - v18 === 0) ? 5 : v18 === 0 ? 4 : 0 : (v17 !== 0 && v16 - v16 ===
0) ? 0 : v20;
const verdict = !(v7 - v7 === 0) ? 5 : v21;
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
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ex - k4;
const v1 = ey - k5;
const v2 = ez - k6;
const v3 = ((k1 * v0) + (k2 * v1)) + (k3 * v2);
const v4 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v5 = (-v3) / v4;
const v6 = (x * v1) - (y * v0);
const v7 = (y * v2) - (z * v1);
const v8 = (v6 * k1) - (v7 * k3);
S[0] = v8;
S[1] = -v8;
const v9 = +(v4 < 0);
const v10 = S[0 + v9] as number;
const v11 = 0 - v10;
const v12 = +(0 < v11);
S[2] = v4;
S[3] = -v4;
const v13 = S[2 + v9] as number;
const v14 = k0 * v13;
const v15 = v10 - v14;
const v16 = +(0 < v15);
const v17 = (z * v0) - (x * v2);
const v18 = (v7 * k2) - (v17 * k1);
S[4] = v18;
S[5] = -v18;
const v19 = S[4 + v9] as number;
const v20 = 0 - v19;
const v21 = +(0 < v20);
const v22 = v19 - v14;
const v23 = +(0 < v22);
const v24 = v5 * (ONE_OR_NAN[(((v12 | v16) | v21) | v23)] as number);
t0[i] = v24;
t1[i] = Number.NaN;
const v25 = (v17 * k3) - (v6 * k2);
S[6] = v25;
S[7] = -v25;
const v26 = S[6 + v9] as number;
if (((((((((!(Math.abs(v5) < 2 ** 511) || !(Math.abs(v4) < 2 ** 511)) || !(Math.abs(v11) < 2 **
511)) || !(Math.abs(v15) < 2 ** 511)) || !(Math.abs(v20) < 2 ** 511)) || !(Math.abs(v22) < 2 **
511)) || !(Math.abs(k4 + (v26 / v13)) < 2 ** 511)) || !(Math.abs(k5 + (v10 / v13)) < 2 **
511)) || !(Math.abs(k6 + (v19 / v13)) < 2 ** 511))) {
const v27 = ((((!(v11 - v11 === 0) || !(v15 - v15 === 0)) || !(v20 - v20 === 0)) || !(v22 -
v22 === 0)) || !(v5 - v5 === 0)) ? 5 : 6;
const v28 = ((((v12 !== 0 && v11 - v11 === 0) || (v16 !== 0 && v15 - v15 === 0)) || (v21 !==
0 && v20 - v20 === 0)) || (v23 !== 0 && v22 - v22 === 0)) ? 0 : v27;
const v29 = v4 === 0 ? !(v3 - v3 === 0) ? 5 : v3 === 0 ? 4 : 0 : v28;
const verdict = !(v4 - v4 === 0) ? 5 : v29;
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
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v0 = ey - k5;
const v1 = ex - k4;
const v2 = (x * v0) - (y * v1);
const v3 = ez - k6;
const v4 = (y * v3) - (z * v0);
const v5 = (v2 * k1) - (v4 * k3);
S[0] = v5;
S[1] = -v5;
const v6 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v7 = +(v6 < 0);
const v8 = S[0 + v7] as number;
const v9 = 0 - v8;
const v10 = +(0 < v9);
S[2] = v6;
S[3] = -v6;
const v11 = S[2 + v7] as number;
const v12 = k0 * v11;
const v13 = v8 - v12;
const v14 = +(0 < v13);
const v15 = (z * v1) - (x * v3);
const v16 = (v4 * k2) - (v15 * k1);
S[4] = v16;
S[5] = -v16;
const v17 = S[4 + v7] as number;
const v18 = 0 - v17;
const v19 = +(0 < v18);
const v20 = v17 - v12;
const v21 = +(0 < v20);
margin[i] = 1 * (1 - 2 * (((v10 | v14) | v19) | v21));
const v22 = ((k1 * v1) + (k2 * v0)) + (k3 * v3);
const v23 = (-v22) / v6;
const v24 = (v15 * k3) - (v2 * k2);
S[6] = v24;
S[7] = -v24;
const v25 = S[6 + v7] as number;
if (((((((((!(Math.abs(v23) < 2 ** 511) || !(Math.abs(v6) < 2 ** 511)) || !(Math.abs(v9) < 2 **
511)) || !(Math.abs(v13) < 2 ** 511)) || !(Math.abs(v18) < 2 ** 511)) || !(Math.abs(v20) < 2 **
511)) || !(Math.abs(k4 + (v25 / v11)) < 2 ** 511)) || !(Math.abs(k5 + (v8 / v11)) < 2 **
511)) || !(Math.abs(k6 + (v17 / v11)) < 2 ** 511))) {
const v26 = ((((!(v9 - v9 === 0) || !(v13 - v13 === 0)) || !(v18 - v18 === 0)) || !(v20 -
v20 === 0)) || !(v23 - v23 === 0)) ? 5 : 6;
const v27 = ((((v10 !== 0 && v9 - v9 === 0) || (v14 !== 0 && v13 - v13 === 0)) || (v19 !== 0 &&
v18 - v18 === 0)) || (v21 !== 0 && v20 - v20 === 0)) ? 0 : v26;
const v28 = v6 === 0 ? !(v22 - v22 === 0) ? 5 : v22 === 0 ? 4 : 0 : v27;
const verdict = !(v6 - v6 === 0) ? 5 : v28;
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
const v5 = Math.abs(v4);
const v6 = ((x * x) + (y * y)) + (z * z);
const v7 = (y * v3) - (z * v2);
const v8 = (z * v1) - (x * v3);
const v9 = (x * v2) - (y * v1);
const v10 = (v0 * v6) - (((v7 * v7) + (v8 * v8)) + (v9 * v9));
const v11 = 4 * v10;
const v12 = (v5 + Math.sqrt(v11)) * (+(v4 < 0) - 0.5);
const v13 = v12 / v6;
const v14 = (((v1 * v1) + (v2 * v2)) + (v3 * v3)) - v0;
const v15 = v14 / v12;
S[0] = v13;
S[1] = v15;
const v16 = +(v15 < v13);
const v17 = S[0 + v16] as number;
const v18 = S[1 - v16] as number;
t0[i] = v17;
t1[i] = v18;
const v19 = Math.abs(v13) + Math.abs(v15);
if (((((((2 ** 1022 <= v19 || v19 <= 0) || v11 === 0) || v6 === 0) || !(Math.abs(v11) <=
1.7976931348623157e+308)) || !(v5 <= 1.7976931348623157e+308)) || !(Math.abs(v14) <=
1.7976931348623157e+308))) {
const v20 = v4 === 0 ? !(v14 - v14 === 0) ? 5 : v14 === 0 ? 4 : 0 : 1;
const v21 = !(v11 - v11 === 0) ? 5 : v11 === 0 ? 3 : v11 < 0 ? 0 : 6;
const v22 = !(v6 - v6 === 0) ? 5 : v6 === 0 ? !(v4 - v4 === 0) ? 5 : v20 : v21;
const v23 = (-(v6 === 0 ? v14 : v4)) / (v6 === 0 ? v4 : 2 * v6);
const v24 = ((v22 === 1 || v22 === 3) && !(Math.abs(v23) < 2 ** 1022)) ? 6 : v22;
const verdict = v24;
t0[i] = (v22 === 1 || v22 === 3) ? v23 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const sphereClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k0 = n[0] as number;
const v0 = k0 * k0;
const k3 = n[3] as number;
const k2 = n[2] as number;
const k1 = n[1] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v1 = ((x * x) + (y * y)) + (z * z);
const v2 = ez - k3;
const v3 = ey - k2;
const v4 = (y * v2) - (z * v3);
const v5 = ex - k1;
const v6 = (z * v5) - (x * v2);
const v7 = (x * v3) - (y * v5);
const v8 = (v0 * v1) - (((v4 * v4) + (v6 * v6)) + (v7 * v7));
const v9 = 4 * v8;
margin[i] = v9;
const v10 = Math.abs(v9);
const v11 = (((2 * x) * v5) + ((2 * y) * v3)) + ((2 * z) * v2);
const v12 = Math.abs(v1);
const v13 = (((v5 * v5) + (v3 * v3)) + (v2 * v2)) - v0;
if ((v9 === 0 || !((((((v10 < 2 ** 500 && Math.abs(v11) < 2 ** 500) && 2 ** -500 < v12) &&
Math.abs(v13) < 2 ** 500) && 2 ** -500 < v10) && v12 < 2 ** 500)))) {
const v14 = v11 === 0 ? !(v13 - v13 === 0) ? 5 : v13 === 0 ? 4 : 0 : 1;
const v15 = !(v9 - v9 === 0) ? 5 : v9 === 0 ? 3 : v9 < 0 ? 0 : 6;
const v16 = !(v1 - v1 === 0) ? 5 : v1 === 0 ? !(v11 - v11 === 0) ? 5 : v14 : v15;
const v17 = (-(v1 === 0 ? v13 : v11)) / (v1 === 0 ? v11 : 2 * v1);
const v18 = ((v16 === 1 || v16 === 3) && !(Math.abs(v17) < 2 ** 1022)) ? 6 : v16;
const verdict = v18;
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
const v0 = k0 * k0;
const v1 = 4 * k0;
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
const v4 = (((2 * x) * v2) + ((2 * z) * v3)) - (k0 * y);
const v5 = Math.abs(v4);
const v6 = ey - k2;
const v7 = (x * ((x * v6) - (y * v2))) - (z * ((y * v3) - (z * v6)));
const v8 = (z * v2) - (x * v3);
const v9 = ((v0 * (y * y)) + (v1 * v7)) - (4 * (v8 * v8));
const v10 = (v5 + Math.sqrt(v9)) * (+(v4 < 0) - 0.5);
const v11 = (x * x) + (z * z);
const v12 = v10 / v11;
const v13 = ((v2 * v2) + (v3 * v3)) - (k0 * v6);
const v14 = v13 / v10;
S[0] = v12;
S[1] = v14;
const v15 = +(v14 < v12);
const v16 = S[0 + v15] as number;
const v17 = S[1 - v15] as number;
t0[i] = v16;
t1[i] = v17;
const v18 = Math.abs(v12) + Math.abs(v14);
if ((((((((2 ** 1022 <= v18 || v18 <= 0) || v9 === 0) || v11 === 0) || !(Math.abs(v9) <=
1.7976931348623157e+308)) || !(Math.abs(v11) <= 1.7976931348623157e+308)) || !(v5 <=
1.7976931348623157e+308)) || !(Math.abs(v13) <= 1.7976931348623157e+308))) {
const v19 = v4 === 0 ? !(v13 - v13 === 0) ? 5 : v13 === 0 ? 4 : 0 : 1;
const v20 = !(v9 - v9 === 0) ? 5 : v9 === 0 ? 3 : v9 < 0 ? 0 : 6;
const v21 = !(v11 - v11 === 0) ? 5 : v11 === 0 ? !(v4 - v4 === 0) ? 5 : v19 : v20;
const v22 = (-(v11 === 0 ? v13 : v4)) / (v11 === 0 ? v4 : 2 * v11);
const v23 = ((v21 === 1 || v21 === 3) && !(Math.abs(v22) < 2 ** 1022)) ? 6 : v21;
const verdict = v23;
t0[i] = (v21 === 1 || v21 === 3) ? v22 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const paraboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
const { margin } = out;
const k0 = n[0] as number;
const v0 = k0 * k0;
const v1 = 4 * k0;
const k2 = n[2] as number;
const k1 = n[1] as number;
const k3 = n[3] as number;
let left = 0;
for (let i = 0; i < count; i++) {
const ex = Ex[i] as number;
const ey = Ey[i] as number;
const ez = Ez[i] as number;
const x = dx[i] as number;
const y = dy[i] as number;
const z = dz[i] as number;
const v2 = ey - k2;
const v3 = ex - k1;
const v4 = ez - k3;
const v5 = (x * ((x * v2) - (y * v3))) - (z * ((y * v4) - (z * v2)));
const v6 = (z * v3) - (x * v4);
const v7 = ((v0 * (y * y)) + (v1 * v5)) - (4 * (v6 * v6));
margin[i] = v7;
const v8 = Math.abs(v7);
const v9 = (((2 * x) * v3) + ((2 * z) * v4)) - (k0 * y);
const v10 = (x * x) + (z * z);
const v11 = Math.abs(v10);
const v12 = ((v3 * v3) + (v4 * v4)) - (k0 * v2);
if ((v7 === 0 || !((((((v8 < 2 ** 500 && Math.abs(v9) < 2 ** 500) && 2 ** -500 < v11) &&
Math.abs(v12) < 2 ** 500) && 2 ** -500 < v8) && v11 < 2 ** 500)))) {
const v13 = v9 === 0 ? !(v12 - v12 === 0) ? 5 : v12 === 0 ? 4 : 0 : 1;
const v14 = !(v7 - v7 === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v15 = !(v10 - v10 === 0) ? 5 : v10 === 0 ? !(v9 - v9 === 0) ? 5 : v13 : v14;
const v16 = (-(v10 === 0 ? v12 : v9)) / (v10 === 0 ? v9 : 2 * v10);
const v17 = ((v15 === 1 || v15 === 3) && !(Math.abs(v16) < 2 ** 1022)) ? 6 : v15;
const verdict = v17;
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
