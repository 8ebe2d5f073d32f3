/*
 * The method moment over arrays, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */

import type { Loop } from '../straight-loop.ts';

const ONE_OR_NAN = Float64Array.of(1, Number.NaN);
const S = new Float64Array(8);

export const planeBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v3 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v4 = (-(((k0 * v0) + (k1 * v1)) + (k2 * v2))) / v3;
t0[i] = v4;
t1[i] = Number.NaN;
const v5 = (z * v0) - (x * v2);
const v6 = (x * v1) - (y * v0);
const v7 = (v5 * k2) - (v6 * k1);
S[0] = v7;
S[1] = -v7;
const v8 = +(v3 < 0);
const v9 = S[0 + v8] as number;
S[2] = v3;
S[3] = -v3;
const v10 = S[2 + v8] as number;
const v11 = (y * v2) - (z * v1);
const v12 = (v6 * k0) - (v11 * k2);
S[4] = v12;
S[5] = -v12;
const v13 = S[4 + v8] as number;
const v14 = (v11 * k1) - (v5 * k0);
S[6] = v14;
S[7] = -v14;
const v15 = S[6 + v8] as number;
if (((((!(Math.abs(v4) < 2 ** 511) || !(Math.abs(v3) < 2 ** 511)) || !(Math.abs(k3 + (v9 /
v10)) < 2 ** 511)) || !(Math.abs(k4 + (v13 / v10)) < 2 ** 511)) || !(Math.abs(k5 + (v15 /
v10)) < 2 ** 511))) open[left++] = i;
}
return left;
};

export const planeClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v3 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v4 = Math.abs((-(((k0 * v0) + (k1 * v1)) + (k2 * v2))) / v3);
const v5 = (z * v0) - (x * v2);
const v6 = (x * v1) - (y * v0);
const v7 = (v5 * k2) - (v6 * k1);
S[0] = v7;
S[1] = -v7;
const v8 = +(v3 < 0);
const v9 = S[0 + v8] as number;
S[2] = v3;
S[3] = -v3;
const v10 = S[2 + v8] as number;
const v11 = (y * v2) - (z * v1);
const v12 = (v6 * k0) - (v11 * k2);
S[4] = v12;
S[5] = -v12;
const v13 = S[4 + v8] as number;
const v14 = (v11 * k1) - (v5 * k0);
S[6] = v14;
S[7] = -v14;
const v15 = S[6 + v8] as number;
if (((((!(v4 < 2 ** 511) || !(Math.abs(v3) < 2 ** 511)) || !(Math.abs(k3 + (v9 / v10)) < 2 **
511)) || !(Math.abs(k4 + (v13 / v10)) < 2 ** 511)) || !(Math.abs(k5 + (v15 / v10)) < 2 **
511))) open[left++] = i;
}
return left;
};

export const cylinderBoth: Loop = (n, { count, Ex, Ez, dx, dz }, out, open) => {
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
const v8 = ((v4 + Math.sqrt(v7)) * 0.5) * (2 * +(v3 < 0) - 1);
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
1.7976931348623157e+308))) open[left++] = i;
}
return left;
};

export const cylinderClasses: Loop = (n, { count, Ex, Ez, dx, dz }, out, open) => {
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
const v7 = Math.abs(v1);
if ((v5 === 0 || !((((((v6 < 2 ** 500 && Math.abs(((2 * x) * v2) + ((2 * z) * v3)) < 2 **
500) && 2 ** -500 < v7) && Math.abs(((v2 * v2) + (v3 * v3)) - v0) < 2 ** 500) && 2 ** -500 <
v6) && v7 < 2 ** 500)))) open[left++] = i;
}
return left;
};

export const coneBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v11 = ((v6 + Math.sqrt(v10)) * 0.5) * (2 * +(v5 < 0) - 1);
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
1.7976931348623157e+308)) || !(Math.abs(v14) <= 1.7976931348623157e+308))) open[left++] = i;
}
return left;
};

export const coneClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v11 = Math.abs(((x * x) + (z * z)) - (v0 * (y * y)));
const v12 = Math.abs(((v5 * v5) + (v2 * v2)) - (v0 * (v3 * v3)));
if ((v8 === 0 || !((((((v9 < 2 ** 500 && Math.abs(v10) < 2 ** 500) && 2 ** -500 < v11) && v12 <
2 ** 500) && 2 ** -500 < v9) && v11 < 2 ** 500)))) open[left++] = i;
}
return left;
};

export const hyperboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v13 = ((v6 + Math.sqrt(v12)) * 0.5) * (2 * +(v5 < 0) - 1);
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
1.7976931348623157e+308))) open[left++] = i;
}
return left;
};

export const hyperboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
Math.abs(v14) < 2 ** 500) && 2 ** -500 < v11) && v13 < 2 ** 500)))) open[left++] = i;
}
return left;
};

export const circleBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v4 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v5 = (-(((k1 * v1) + (k2 * v2)) + (k3 * v3))) / v4;
const v6 = (z * v1) - (x * v3);
const v7 = (x * v2) - (y * v1);
const v8 = (v6 * k3) - (v7 * k2);
S[0] = v8;
S[1] = -v8;
const v9 = +(v4 < 0);
const v10 = S[0 + v9] as number;
const v11 = (y * v3) - (z * v2);
const v12 = (v7 * k1) - (v11 * k3);
S[2] = v12;
S[3] = -v12;
const v13 = S[2 + v9] as number;
const v14 = (v11 * k2) - (v6 * k1);
S[4] = v14;
S[5] = -v14;
const v15 = S[4 + v9] as number;
S[6] = v4;
S[7] = -v4;
const v16 = S[6 + v9] as number;
const v17 = (((v10 * v10) + (v13 * v13)) + (v15 * v15)) - (v0 * (v16 * v16));
t0[i] = v5 * (ONE_OR_NAN[+(0 < v17)] as number);
t1[i] = Number.NaN;
if ((((((!(Math.abs(v5) < 2 ** 511) || !(Math.abs(v4) < 2 ** 511)) || !(Math.abs(v17) < 2 **
511)) || !(Math.abs(k4 + (v10 / v16)) < 2 ** 511)) || !(Math.abs(k5 + (v13 / v16)) < 2 **
511)) || !(Math.abs(k6 + (v15 / v16)) < 2 ** 511))) open[left++] = i;
}
return left;
};

export const circleClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
margin[i] = 1 * (1 - 2 * +(0 < v16));
const v17 = Math.abs((-(((k1 * v1) + (k2 * v4)) + (k3 * v2))) / v7);
if ((((((!(v17 < 2 ** 511) || !(Math.abs(v7) < 2 ** 511)) || !(Math.abs(v16) < 2 ** 511)) ||
!(Math.abs(k4 + (v9 / v15)) < 2 ** 511)) || !(Math.abs(k5 + (v12 / v15)) < 2 ** 511)) ||
!(Math.abs(k6 + (v14 / v15)) < 2 ** 511))) open[left++] = i;
}
return left;
};

export const squareBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v3 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v4 = (-(((k1 * v0) + (k2 * v1)) + (k3 * v2))) / v3;
const v5 = (x * v1) - (y * v0);
const v6 = (y * v2) - (z * v1);
const v7 = (v5 * k1) - (v6 * k3);
S[0] = v7;
S[1] = -v7;
const v8 = +(v3 < 0);
const v9 = S[0 + v8] as number;
const v10 = 0 - v9;
S[2] = v3;
S[3] = -v3;
const v11 = S[2 + v8] as number;
const v12 = k0 * v11;
const v13 = v9 - v12;
const v14 = (z * v0) - (x * v2);
const v15 = (v6 * k2) - (v14 * k1);
S[4] = v15;
S[5] = -v15;
const v16 = S[4 + v8] as number;
const v17 = 0 - v16;
const v18 = ((+(0 < v10) | +(0 < v13)) | +(0 < v17));
const v19 = v16 - v12;
t0[i] = v4 * (ONE_OR_NAN[(v18 | +(0 < v19))] as number);
t1[i] = Number.NaN;
const v20 = (v14 * k3) - (v5 * k2);
S[6] = v20;
S[7] = -v20;
const v21 = S[6 + v8] as number;
if (((((((((!(Math.abs(v4) < 2 ** 511) || !(Math.abs(v3) < 2 ** 511)) || !(Math.abs(v10) < 2 **
511)) || !(Math.abs(v13) < 2 ** 511)) || !(Math.abs(v17) < 2 ** 511)) || !(Math.abs(v19) < 2 **
511)) || !(Math.abs(k4 + (v21 / v11)) < 2 ** 511)) || !(Math.abs(k5 + (v9 / v11)) < 2 **
511)) || !(Math.abs(k6 + (v16 / v11)) < 2 ** 511))) open[left++] = i;
}
return left;
};

export const squareClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
S[2] = v6;
S[3] = -v6;
const v10 = S[2 + v7] as number;
const v11 = k0 * v10;
const v12 = v8 - v11;
const v13 = (z * v1) - (x * v3);
const v14 = (v4 * k2) - (v13 * k1);
S[4] = v14;
S[5] = -v14;
const v15 = S[4 + v7] as number;
const v16 = 0 - v15;
const v17 = v15 - v11;
const v18 = (((+(0 < v9) | +(0 < v12)) | +(0 < v16)) | +(0 < v17));
margin[i] = 1 * (1 - 2 * v18);
const v19 = Math.abs((-(((k1 * v1) + (k2 * v0)) + (k3 * v3))) / v6);
const v20 = (v13 * k3) - (v2 * k2);
S[6] = v20;
S[7] = -v20;
const v21 = S[6 + v7] as number;
if (((((((((!(v19 < 2 ** 511) || !(Math.abs(v6) < 2 ** 511)) || !(Math.abs(v9) < 2 ** 511)) ||
!(Math.abs(v12) < 2 ** 511)) || !(Math.abs(v16) < 2 ** 511)) || !(Math.abs(v17) < 2 ** 511)) ||
!(Math.abs(k4 + (v21 / v10)) < 2 ** 511)) || !(Math.abs(k5 + (v8 / v10)) < 2 ** 511)) ||
!(Math.abs(k6 + (v15 / v10)) < 2 ** 511))) open[left++] = i;
}
return left;
};

export const sphereBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v12 = ((v5 + Math.sqrt(v11)) * 0.5) * (2 * +(v4 < 0) - 1);
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
1.7976931348623157e+308))) open[left++] = i;
}
return left;
};

export const sphereClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v13 = Math.abs((((v5 * v5) + (v3 * v3)) + (v2 * v2)) - v0);
if ((v9 === 0 || !((((((v10 < 2 ** 500 && Math.abs(v11) < 2 ** 500) && 2 ** -500 < v12) &&
v13 < 2 ** 500) && 2 ** -500 < v10) && v12 < 2 ** 500)))) open[left++] = i;
}
return left;
};

export const paraboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v10 = ((v5 + Math.sqrt(v9)) * 0.5) * (2 * +(v4 < 0) - 1);
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
1.7976931348623157e+308)) || !(Math.abs(v13) <= 1.7976931348623157e+308))) open[left++] = i;
}
return left;
};

export const paraboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
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
const v9 = Math.abs((((2 * x) * v3) + ((2 * z) * v4)) - (k0 * y));
const v10 = Math.abs((x * x) + (z * z));
if ((v7 === 0 || !((((((v8 < 2 ** 500 && v9 < 2 ** 500) && 2 ** -500 < v10) && Math.abs(((v3 *
v3) + (v4 * v4)) - (k0 * v2)) < 2 ** 500) && 2 ** -500 < v8) && v10 < 2 **
500)))) open[left++] = i;
}
return left;
};
