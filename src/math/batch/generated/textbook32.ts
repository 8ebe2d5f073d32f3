/*
 * The method textbook, float32 over arrays, in float32.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */

import type { Loop } from '../straight-loop.ts';

const { fround } = Math;
const ONE_OR_NAN = Float64Array.of(1, Number.NaN);

export const planeBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k0 = fround(n[0] as number);
const k3 = fround(n[3] as number);
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v0 = fround((fround(k0 * fround(ex - k3))) + (fround(k1 * fround(ey - k4))));
const v1 = fround((fround(fround(k0 * x) + fround(k1 * y))) + fround(k2 * z));
const v2 = fround((-(fround(v0 + (fround(k2 * fround(ez - k5)))))) / v1);
t0[i] = v2;
t1[i] = Number.NaN;
if ((!(Math.abs(v2) < 2 ** 63) || !(Math.abs(v1) < 2 ** 63))) open[left++] = i;
}
return left;
};

export const planeClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k0 = fround(n[0] as number);
const k3 = fround(n[3] as number);
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
margin[i] = 1;
const v0 = fround((fround(k0 * fround(ex - k3))) + (fround(k1 * fround(ey - k4))));
const v1 = fround((fround(fround(k0 * x) + fround(k1 * y))) + fround(k2 * z));
const v2 = fround((-(fround(v0 + (fround(k2 * fround(ez - k5)))))) / v1);
if ((!(Math.abs(v2) < 2 ** 63) || !(Math.abs(v1) < 2 ** 63))) open[left++] = i;
}
return left;
};

export const cylinderBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v1 = fround(ex - k1);
const v2 = fround(ez - k3);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * z) * v2)));
const v4 = -v3;
const v5 = fround(fround(x * x) + fround(z * z));
const v6 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) - v0);
const v7 = fround(fround(v3 * v3) - (fround(fround(4 * v5) * v6)));
const v8 = fround(2 * v5);
const v9 = (fround(Math.sqrt(v7))) * (1 - 2 * +(v8 < 0));
const v10 = fround(fround(v4 - v9) / v8);
const v11 = fround(fround(v4 + v9) / v8);
t0[i] = v10;
t1[i] = v11;
const v12 = fround(Math.abs(v10) + Math.abs(v11));
if (((((((2 ** 126 <= v12 || v12 <= 0) || v7 === 0) || v5 === 0) || !(Math.abs(v7) <=
3.4028234663852886e+38)) || !(Math.abs(ey) <= 3.4028234663852886e+38)) || !(Math.abs(y) <=
3.4028234663852886e+38))) open[left++] = i;
}
return left;
};

export const cylinderClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v1 = fround(ex - k1);
const v2 = fround(ez - k3);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * z) * v2)));
const v4 = fround(fround(x * x) + fround(z * z));
const v5 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) - v0);
const v6 = fround(fround(v3 * v3) - (fround(fround(4 * v4) * v5)));
margin[i] = v6;
if ((((v6 === 0 || !(Math.abs(ey) <= 3.4028234663852886e+38)) || !(Math.abs(y) <=
3.4028234663852886e+38)) || !(((Math.abs(v6) < 2 ** 60 && Math.abs(v3) < 2 ** 60) && 2 ** -60 <
Math.abs(v4))))) open[left++] = i;
}
return left;
};

export const coneBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
const v1 = fround(2 * v0);
const k2 = fround(n[2] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround(ex - k1);
const v3 = fround(ez - k3);
const v4 = fround((fround(fround(2 * x) * v2)) + (fround(fround(2 * z) * v3)));
const v5 = fround(ey - k2);
const v6 = fround(v4 - (fround(fround(v1 * y) * v5)));
const v7 = -v6;
const v8 = fround((fround(fround(x * x) + fround(z * z))) - (fround(v0 * fround(y * y))));
const v9 = fround((fround(fround(v2 * v2) + fround(v3 * v3))) - (fround(v0 * fround(v5 * v5))));
const v10 = fround(fround(v6 * v6) - (fround(fround(4 * v8) * v9)));
const v11 = fround(2 * v8);
const v12 = (fround(Math.sqrt(v10))) * (1 - 2 * +(v11 < 0));
const v13 = fround(fround(v7 - v12) / v11);
const v14 = fround(fround(v7 + v12) / v11);
t0[i] = v13;
t1[i] = v14;
const v15 = fround(Math.abs(v13) + Math.abs(v14));
if (((((2 ** 126 <= v15 || v15 <= 0) || v10 === 0) || v8 === 0) || !(Math.abs(v10) <=
3.4028234663852886e+38))) open[left++] = i;
}
return left;
};

export const coneClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
const v1 = fround(2 * v0);
const k2 = fround(n[2] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround(ex - k1);
const v3 = fround(ez - k3);
const v4 = fround((fround(fround(2 * x) * v2)) + (fround(fround(2 * z) * v3)));
const v5 = fround(ey - k2);
const v6 = fround(v4 - (fround(fround(v1 * y) * v5)));
const v7 = fround((fround(fround(x * x) + fround(z * z))) - (fround(v0 * fround(y * y))));
const v8 = fround((fround(fround(v2 * v2) + fround(v3 * v3))) - (fround(v0 * fround(v5 * v5))));
const v9 = fround(fround(v6 * v6) - (fround(fround(4 * v7) * v8)));
margin[i] = v9;
if ((v9 === 0 || !(((Math.abs(v9) < 2 ** 60 && Math.abs(v6) < 2 ** 60) && 2 ** -60 <
Math.abs(v7))))) open[left++] = i;
}
return left;
};

export const hyperboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k2 = fround(n[2] as number);
const k4 = fround(n[4] as number);
const k0 = fround(n[0] as number);
const v0 = fround(2 * k0);
const k3 = fround(n[3] as number);
const k1 = fround(n[1] as number);
const v1 = fround(k1 * k1);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround(ex - k2);
const v3 = fround(ez - k4);
const v4 = fround((fround(fround(2 * x) * v2)) + (fround(fround(2 * z) * v3)));
const v5 = fround(ey - k3);
const v6 = fround(v4 - (fround(fround(v0 * y) * v5)));
const v7 = -v6;
const v8 = fround((fround(fround(x * x) + fround(z * z))) - (fround(k0 * fround(y * y))));
const v9 = fround((fround(fround(v2 * v2) + fround(v3 * v3))) - (fround(k0 * fround(v5 * v5))));
const v10 = fround(fround(v6 * v6) - (fround(fround(4 * v8) * fround(v9 - v1))));
const v11 = fround(2 * v8);
const v12 = (fround(Math.sqrt(v10))) * (1 - 2 * +(v11 < 0));
const v13 = fround(fround(v7 - v12) / v11);
const v14 = fround(fround(v7 + v12) / v11);
t0[i] = v13;
t1[i] = v14;
const v15 = fround(Math.abs(v13) + Math.abs(v14));
if (((((2 ** 126 <= v15 || v15 <= 0) || v10 === 0) || v8 === 0) || !(Math.abs(v10) <=
3.4028234663852886e+38))) open[left++] = i;
}
return left;
};

export const hyperboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k2 = fround(n[2] as number);
const k4 = fround(n[4] as number);
const k0 = fround(n[0] as number);
const v0 = fround(2 * k0);
const k3 = fround(n[3] as number);
const k1 = fround(n[1] as number);
const v1 = fround(k1 * k1);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround(ex - k2);
const v3 = fround(ez - k4);
const v4 = fround((fround(fround(2 * x) * v2)) + (fround(fround(2 * z) * v3)));
const v5 = fround(ey - k3);
const v6 = fround(v4 - (fround(fround(v0 * y) * v5)));
const v7 = fround((fround(fround(x * x) + fround(z * z))) - (fround(k0 * fround(y * y))));
const v8 = fround((fround(fround(v2 * v2) + fround(v3 * v3))) - (fround(k0 * fround(v5 * v5))));
const v9 = fround(fround(v6 * v6) - (fround(fround(4 * v7) * fround(v8 - v1))));
margin[i] = v9;
if ((v9 === 0 || !(((Math.abs(v9) < 2 ** 60 && Math.abs(v6) < 2 ** 60) && 2 ** -60 <
Math.abs(v7))))) open[left++] = i;
}
return left;
};

export const circleBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
const k3 = fround(n[3] as number);
const k6 = fround(n[6] as number);
const k0 = fround(n[0] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v0 = fround((fround(k1 * fround(ex - k4))) + (fround(k2 * fround(ey - k5))));
const v1 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v2 = fround((-(fround(v0 + (fround(k3 * fround(ez - k6)))))) / v1);
const v3 = fround((fround(ex + fround(v2 * x))) - k4);
const v4 = fround((fround(ey + fround(v2 * y))) - k5);
const v5 = fround((fround(ez + fround(v2 * z))) - k6);
const v6 = fround((fround(fround(v3 * v3) + fround(v4 * v4))) + fround(v5 * v5));
const v7 = fround((fround(Math.sqrt(v6))) - k0);
t0[i] = v2 * (ONE_OR_NAN[+(0 < v7)] as number);
t1[i] = Number.NaN;
if (((!(Math.abs(v2) < 2 ** 63) || !(Math.abs(v1) < 2 ** 63)) || !(Math.abs(v7) < 2 **
63))) open[left++] = i;
}
return left;
};

export const circleClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
const k3 = fround(n[3] as number);
const k6 = fround(n[6] as number);
const k0 = fround(n[0] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v0 = fround((fround(k1 * fround(ex - k4))) + (fround(k2 * fround(ey - k5))));
const v1 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v2 = fround((-(fround(v0 + (fround(k3 * fround(ez - k6)))))) / v1);
const v3 = fround((fround(ex + fround(v2 * x))) - k4);
const v4 = fround((fround(ey + fround(v2 * y))) - k5);
const v5 = fround((fround(ez + fround(v2 * z))) - k6);
const v6 = fround((fround(fround(v3 * v3) + fround(v4 * v4))) + fround(v5 * v5));
const v7 = fround((fround(Math.sqrt(v6))) - k0);
margin[i] = 1 * (1 - 2 * +(0 < v7));
if (((!(Math.abs(v2) < 2 ** 63) || !(Math.abs(v1) < 2 ** 63)) || !(Math.abs(v7) < 2 **
63))) open[left++] = i;
}
return left;
};

export const squareBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
const k3 = fround(n[3] as number);
const k6 = fround(n[6] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k5 + k0);
const v1 = fround(k6 + k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround((fround(k1 * fround(ex - k4))) + (fround(k2 * fround(ey - k5))));
const v3 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v4 = fround((-(fround(v2 + (fround(k3 * fround(ez - k6)))))) / v3);
const v5 = fround(ey + fround(v4 * y));
const v6 = fround(k5 - v5);
const v7 = fround(v5 - v0);
const v8 = fround(ez + fround(v4 * z));
const v9 = fround(k6 - v8);
const v10 = fround(v8 - v1);
const v11 = (((+(0 < v6) | +(0 < v7)) | +(0 < v9)) | +(0 < v10));
t0[i] = v4 * (ONE_OR_NAN[v11] as number);
t1[i] = Number.NaN;
if ((((((!(Math.abs(v4) < 2 ** 63) || !(Math.abs(v3) < 2 ** 63)) || !(Math.abs(v6) < 2 **
63)) || !(Math.abs(v7) < 2 ** 63)) || !(Math.abs(v9) < 2 ** 63)) || !(Math.abs(v10) < 2 **
63))) open[left++] = i;
}
return left;
};

export const squareClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k4 = fround(n[4] as number);
const k2 = fround(n[2] as number);
const k5 = fround(n[5] as number);
const k3 = fround(n[3] as number);
const k6 = fround(n[6] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k5 + k0);
const v1 = fround(k6 + k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v2 = fround((fround(k1 * fround(ex - k4))) + (fround(k2 * fround(ey - k5))));
const v3 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v4 = fround((-(fround(v2 + (fround(k3 * fround(ez - k6)))))) / v3);
const v5 = fround(ey + fround(v4 * y));
const v6 = fround(k5 - v5);
const v7 = fround(v5 - v0);
const v8 = fround(ez + fround(v4 * z));
const v9 = fround(k6 - v8);
const v10 = fround(v8 - v1);
const v11 = (((+(0 < v6) | +(0 < v7)) | +(0 < v9)) | +(0 < v10));
margin[i] = 1 * (1 - 2 * v11);
if ((((((!(Math.abs(v4) < 2 ** 63) || !(Math.abs(v3) < 2 ** 63)) || !(Math.abs(v6) < 2 **
63)) || !(Math.abs(v7) < 2 ** 63)) || !(Math.abs(v9) < 2 ** 63)) || !(Math.abs(v10) < 2 **
63))) open[left++] = i;
}
return left;
};

export const sphereBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k2 = fround(n[2] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v1 = fround(ex - k1);
const v2 = fround(ey - k2);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * y) * v2)));
const v4 = fround(ez - k3);
const v5 = fround(v3 + (fround(fround(2 * z) * v4)));
const v6 = -v5;
const v7 = fround((fround(fround(x * x) + fround(y * y))) + fround(z * z));
const v8 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) + fround(v4 * v4));
const v9 = fround(fround(v5 * v5) - (fround(fround(4 * v7) * fround(v8 - v0))));
const v10 = fround(2 * v7);
const v11 = (fround(Math.sqrt(v9))) * (1 - 2 * +(v10 < 0));
const v12 = fround(fround(v6 - v11) / v10);
const v13 = fround(fround(v6 + v11) / v10);
t0[i] = v12;
t1[i] = v13;
const v14 = fround(Math.abs(v12) + Math.abs(v13));
if (((((2 ** 126 <= v14 || v14 <= 0) || v9 === 0) || v7 === 0) || !(Math.abs(v9) <=
3.4028234663852886e+38))) open[left++] = i;
}
return left;
};

export const sphereClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k2 = fround(n[2] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const v0 = fround(k0 * k0);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v1 = fround(ex - k1);
const v2 = fround(ey - k2);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * y) * v2)));
const v4 = fround(ez - k3);
const v5 = fround(v3 + (fround(fround(2 * z) * v4)));
const v6 = fround((fround(fround(x * x) + fround(y * y))) + fround(z * z));
const v7 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) + fround(v4 * v4));
const v8 = fround(fround(v5 * v5) - (fround(fround(4 * v6) * fround(v7 - v0))));
margin[i] = v8;
if ((v8 === 0 || !(((Math.abs(v8) < 2 ** 60 && Math.abs(v5) < 2 ** 60) && 2 ** -60 <
Math.abs(v6))))) open[left++] = i;
}
return left;
};

export const paraboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { t0, t1 } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const k2 = fround(n[2] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v0 = fround(ex - k1);
const v1 = fround(ez - k3);
const v2 = fround((fround(fround(2 * x) * v0)) + (fround(fround(2 * z) * v1)));
const v3 = fround(v2 - fround(k0 * y));
const v4 = -v3;
const v5 = fround(fround(x * x) + fround(z * z));
const v6 = fround((fround(fround(v0 * v0) + fround(v1 * v1))) - (fround(k0 * fround(ey - k2))));
const v7 = fround(fround(v3 * v3) - (fround(fround(4 * v5) * v6)));
const v8 = fround(2 * v5);
const v9 = (fround(Math.sqrt(v7))) * (1 - 2 * +(v8 < 0));
const v10 = fround(fround(v4 - v9) / v8);
const v11 = fround(fround(v4 + v9) / v8);
t0[i] = v10;
t1[i] = v11;
const v12 = fround(Math.abs(v10) + Math.abs(v11));
if (((((2 ** 126 <= v12 || v12 <= 0) || v7 === 0) || v5 === 0) || !(Math.abs(v7) <=
3.4028234663852886e+38))) open[left++] = i;
}
return left;
};

export const paraboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, open) => {
const { margin } = out;
const k1 = fround(n[1] as number);
const k3 = fround(n[3] as number);
const k0 = fround(n[0] as number);
const k2 = fround(n[2] as number);
let left = 0;
for (let i = 0; i < count; i++) {
const ex = fround(Ex[i] as number);
const ey = fround(Ey[i] as number);
const ez = fround(Ez[i] as number);
const x = fround(dx[i] as number);
const y = fround(dy[i] as number);
const z = fround(dz[i] as number);
const v0 = fround(ex - k1);
const v1 = fround(ez - k3);
const v2 = fround((fround(fround(2 * x) * v0)) + (fround(fround(2 * z) * v1)));
const v3 = fround(v2 - fround(k0 * y));
const v4 = fround(fround(x * x) + fround(z * z));
const v5 = fround((fround(fround(v0 * v0) + fround(v1 * v1))) - (fround(k0 * fround(ey - k2))));
const v6 = fround(fround(v3 * v3) - (fround(fround(4 * v4) * v5)));
margin[i] = v6;
if ((v6 === 0 || !(((Math.abs(v6) < 2 ** 60 && Math.abs(v3) < 2 ** 60) && 2 ** -60 <
Math.abs(v4))))) open[left++] = i;
}
return left;
};
