/*
 * The method textbook, float32 over arrays, in float32.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */

import { lazily } from '../../lazily.ts';
import type { Loop, LoopsByKind } from '../straight-loop.ts';

export const LOOPS = lazily((): LoopsByKind => {
const { fround } = Math;
const ONE_OR_NAN = Float64Array.of(1, Number.NaN);

const planeBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v1 = fround(v0 + (fround(k2 * fround(ez - k5))));
const v2 = fround((fround(fround(k0 * x) + fround(k1 * y))) + fround(k2 * z));
const v3 = fround((-v1) / v2);
t0[i] = v3;
t1[i] = Number.NaN;
if ((!(Math.abs(v3) < 2 ** 63) || !(Math.abs(v2) < 2 ** 63))) {
const v4 = v2 === 0 ? !(fround(v1 - v1) === 0) ? 5 : v1 === 0 ? 4 : 0 : !(fround(v3 - v3) ===
0) ? 5 : 6;
const verdict = !(fround(v2 - v2) === 0) ? 5 : v4;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const planeClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v1 = fround(v0 + (fround(k2 * fround(ez - k5))));
const v2 = fround((fround(fround(k0 * x) + fround(k1 * y))) + fround(k2 * z));
const v3 = fround((-v1) / v2);
if ((!(Math.abs(v3) < 2 ** 63) || !(Math.abs(v2) < 2 ** 63))) {
const v4 = v2 === 0 ? !(fround(v1 - v1) === 0) ? 5 : v1 === 0 ? 4 : 0 : !(fround(v3 - v3) ===
0) ? 5 : 6;
const verdict = !(fround(v2 - v2) === 0) ? 5 : v4;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const cylinderBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
3.4028234663852886e+38))) {
const v13 = v3 === 0 ? !(fround(v6 - v6) === 0) ? 5 : v6 === 0 ? 4 : 0 : 1;
const v14 = !(fround(v7 - v7) === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v15 = v5 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v13 : v14;
const v16 = !(fround(v5 - v5) === 0) ? 5 : v15;
const v17 = fround((-(v5 === 0 ? v6 : v3)) / (v5 === 0 ? v3 : v8));
const v18 = ((v16 === 1 || v16 === 3) && !((Math.abs(v17) < 2 ** 126 && !((!(Math.abs(ey) <=
3.4028234663852886e+38) || !(Math.abs(y) <= 3.4028234663852886e+38)))))) ? 6 : v16;
const verdict = v18;
t0[i] = (v16 === 1 || v16 === 3) ? v17 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const cylinderClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
Math.abs(v4))))) {
const v7 = v3 === 0 ? !(fround(v5 - v5) === 0) ? 5 : v5 === 0 ? 4 : 0 : 1;
const v8 = !(fround(v6 - v6) === 0) ? 5 : v6 === 0 ? 3 : v6 < 0 ? 0 : 6;
const v9 = v4 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v7 : v8;
const v10 = !(fround(v4 - v4) === 0) ? 5 : v9;
const v11 = fround((-(v4 === 0 ? v5 : v3)) / (v4 === 0 ? v3 : fround(2 * v4)));
const v12 = ((v10 === 1 || v10 === 3) && !((Math.abs(v11) < 2 ** 126 && !((!(Math.abs(ey) <=
3.4028234663852886e+38) || !(Math.abs(y) <= 3.4028234663852886e+38)))))) ? 6 : v10;
const verdict = v12;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const coneBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
3.4028234663852886e+38))) {
const v16 = v6 === 0 ? !(fround(v9 - v9) === 0) ? 5 : v9 === 0 ? 4 : 0 : 1;
const v17 = !(fround(v10 - v10) === 0) ? 5 : v10 === 0 ? 3 : v10 < 0 ? 0 : 6;
const v18 = v8 === 0 ? !(fround(v6 - v6) === 0) ? 5 : v16 : v17;
const v19 = !(fround(v8 - v8) === 0) ? 5 : v18;
const v20 = fround((-(v8 === 0 ? v9 : v6)) / (v8 === 0 ? v6 : v11));
const v21 = ((v19 === 1 || v19 === 3) && !(Math.abs(v20) < 2 ** 126)) ? 6 : v19;
const verdict = v21;
t0[i] = (v19 === 1 || v19 === 3) ? v20 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const coneClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
Math.abs(v7))))) {
const v10 = v6 === 0 ? !(fround(v8 - v8) === 0) ? 5 : v8 === 0 ? 4 : 0 : 1;
const v11 = !(fround(v9 - v9) === 0) ? 5 : v9 === 0 ? 3 : v9 < 0 ? 0 : 6;
const v12 = v7 === 0 ? !(fround(v6 - v6) === 0) ? 5 : v10 : v11;
const v13 = !(fround(v7 - v7) === 0) ? 5 : v12;
const v14 = fround((-(v7 === 0 ? v8 : v6)) / (v7 === 0 ? v6 : fround(2 * v7)));
const v15 = ((v13 === 1 || v13 === 3) && !(Math.abs(v14) < 2 ** 126)) ? 6 : v13;
const verdict = v15;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const hyperboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v10 = fround(v9 - v1);
const v11 = fround(fround(v6 * v6) - (fround(fround(4 * v8) * v10)));
const v12 = fround(2 * v8);
const v13 = (fround(Math.sqrt(v11))) * (1 - 2 * +(v12 < 0));
const v14 = fround(fround(v7 - v13) / v12);
const v15 = fround(fround(v7 + v13) / v12);
t0[i] = v14;
t1[i] = v15;
const v16 = fround(Math.abs(v14) + Math.abs(v15));
if (((((2 ** 126 <= v16 || v16 <= 0) || v11 === 0) || v8 === 0) || !(Math.abs(v11) <=
3.4028234663852886e+38))) {
const v17 = !(fround(v10 - v10) === 0) ? 5 : v10 === 0 ? 4 : 0;
const v18 = !(fround(v6 - v6) === 0) ? 5 : v6 === 0 ? v17 : 1;
const v19 = !(fround(v11 - v11) === 0) ? 5 : v11 === 0 ? 3 : v11 < 0 ? 0 : 6;
const v20 = !(fround(v8 - v8) === 0) ? 5 : v8 === 0 ? v18 : v19;
const v21 = fround((-(v8 === 0 ? v10 : v6)) / (v8 === 0 ? v6 : v12));
const v22 = ((v20 === 1 || v20 === 3) && !(Math.abs(v21) < 2 ** 126)) ? 6 : v20;
const verdict = v22;
t0[i] = (v20 === 1 || v20 === 3) ? v21 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const hyperboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v9 = fround(v8 - v1);
const v10 = fround(fround(v6 * v6) - (fround(fround(4 * v7) * v9)));
margin[i] = v10;
if ((v10 === 0 || !(((Math.abs(v10) < 2 ** 60 && Math.abs(v6) < 2 ** 60) && 2 ** -60 <
Math.abs(v7))))) {
const v11 = v6 === 0 ? !(fround(v9 - v9) === 0) ? 5 : v9 === 0 ? 4 : 0 : 1;
const v12 = !(fround(v10 - v10) === 0) ? 5 : v10 === 0 ? 3 : v10 < 0 ? 0 : 6;
const v13 = v7 === 0 ? !(fround(v6 - v6) === 0) ? 5 : v11 : v12;
const v14 = !(fround(v7 - v7) === 0) ? 5 : v13;
const v15 = fround((-(v7 === 0 ? v9 : v6)) / (v7 === 0 ? v6 : fround(2 * v7)));
const v16 = ((v14 === 1 || v14 === 3) && !(Math.abs(v15) < 2 ** 126)) ? 6 : v14;
const verdict = v16;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const circleBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v1 = fround(v0 + (fround(k3 * fround(ez - k6))));
const v2 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v3 = fround((-v1) / v2);
const v4 = fround((fround(ex + fround(v3 * x))) - k4);
const v5 = fround((fround(ey + fround(v3 * y))) - k5);
const v6 = fround((fround(ez + fround(v3 * z))) - k6);
const v7 = fround((fround(fround(v4 * v4) + fround(v5 * v5))) + fround(v6 * v6));
const v8 = fround((fround(Math.sqrt(v7))) - k0);
const v9 = +(0 < v8);
t0[i] = v3 * (ONE_OR_NAN[v9] as number);
t1[i] = Number.NaN;
if (((!(Math.abs(v3) < 2 ** 63) || !(Math.abs(v2) < 2 ** 63)) || !(Math.abs(v8) < 2 ** 63))) {
const v10 = (!(fround(v8 - v8) === 0) || !(fround(v3 - v3) === 0)) ? 5 : 6;
const v11 = v2 === 0 ? !(fround(v1 - v1) === 0) ? 5 : v1 === 0 ? 4 : 0 : (v9 !== 0 &&
fround(v8 - v8) === 0) ? 0 : v10;
const verdict = !(fround(v2 - v2) === 0) ? 5 : v11;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const circleClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v1 = fround(v0 + (fround(k3 * fround(ez - k6))));
const v2 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v3 = fround((-v1) / v2);
const v4 = fround((fround(ex + fround(v3 * x))) - k4);
const v5 = fround((fround(ey + fround(v3 * y))) - k5);
const v6 = fround((fround(ez + fround(v3 * z))) - k6);
const v7 = fround((fround(fround(v4 * v4) + fround(v5 * v5))) + fround(v6 * v6));
const v8 = fround((fround(Math.sqrt(v7))) - k0);
const v9 = +(0 < v8);
margin[i] = 1 * (1 - 2 * v9);
if (((!(Math.abs(v3) < 2 ** 63) || !(Math.abs(v2) < 2 ** 63)) || !(Math.abs(v8) < 2 ** 63))) {
const v10 = (!(fround(v8 - v8) === 0) || !(fround(v3 - v3) === 0)) ? 5 : 6;
const v11 = v2 === 0 ? !(fround(v1 - v1) === 0) ? 5 : v1 === 0 ? 4 : 0 : (v9 !== 0 &&
fround(v8 - v8) === 0) ? 0 : v10;
const verdict = !(fround(v2 - v2) === 0) ? 5 : v11;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const squareBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v3 = fround(v2 + (fround(k3 * fround(ez - k6))));
const v4 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v5 = fround((-v3) / v4);
const v6 = fround(ey + fround(v5 * y));
const v7 = fround(k5 - v6);
const v8 = +(0 < v7);
const v9 = fround(v6 - v0);
const v10 = +(0 < v9);
const v11 = fround(ez + fround(v5 * z));
const v12 = fround(k6 - v11);
const v13 = +(0 < v12);
const v14 = fround(v11 - v1);
const v15 = +(0 < v14);
const v16 = v5 * (ONE_OR_NAN[(((v8 | v10) | v13) | v15)] as number);
t0[i] = v16;
t1[i] = Number.NaN;
if ((((((!(Math.abs(v5) < 2 ** 63) || !(Math.abs(v4) < 2 ** 63)) || !(Math.abs(v7) < 2 **
63)) || !(Math.abs(v9) < 2 ** 63)) || !(Math.abs(v12) < 2 ** 63)) || !(Math.abs(v14) < 2 **
63))) {
const v17 = ((((!(fround(v7 - v7) === 0) || !(fround(v9 - v9) === 0)) || !(fround(v12 -
v12) === 0)) || !(fround(v14 - v14) === 0)) || !(fround(v5 - v5) === 0)) ? 5 : 6;
const v18 = ((((v8 !== 0 && fround(v7 - v7) === 0) || (v10 !== 0 && fround(v9 - v9) === 0)) ||
(v13 !== 0 && fround(v12 - v12) === 0)) || (v15 !== 0 && fround(v14 - v14) === 0)) ? 0 : v17;
const v19 = v4 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v3 === 0 ? 4 : 0 : v18;
const verdict = !(fround(v4 - v4) === 0) ? 5 : v19;
t0[i] = Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const squareClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v3 = fround(v2 + (fround(k3 * fround(ez - k6))));
const v4 = fround((fround(fround(k1 * x) + fround(k2 * y))) + fround(k3 * z));
const v5 = fround((-v3) / v4);
const v6 = fround(ey + fround(v5 * y));
const v7 = fround(k5 - v6);
const v8 = +(0 < v7);
const v9 = fround(v6 - v0);
const v10 = +(0 < v9);
const v11 = fround(ez + fround(v5 * z));
const v12 = fround(k6 - v11);
const v13 = +(0 < v12);
const v14 = fround(v11 - v1);
const v15 = +(0 < v14);
margin[i] = 1 * (1 - 2 * (((v8 | v10) | v13) | v15));
if ((((((!(Math.abs(v5) < 2 ** 63) || !(Math.abs(v4) < 2 ** 63)) || !(Math.abs(v7) < 2 **
63)) || !(Math.abs(v9) < 2 ** 63)) || !(Math.abs(v12) < 2 ** 63)) || !(Math.abs(v14) < 2 **
63))) {
const v16 = ((((!(fround(v7 - v7) === 0) || !(fround(v9 - v9) === 0)) || !(fround(v12 -
v12) === 0)) || !(fround(v14 - v14) === 0)) || !(fround(v5 - v5) === 0)) ? 5 : 6;
const v17 = ((((v8 !== 0 && fround(v7 - v7) === 0) || (v10 !== 0 && fround(v9 - v9) === 0)) ||
(v13 !== 0 && fround(v12 - v12) === 0)) || (v15 !== 0 && fround(v14 - v14) === 0)) ? 0 : v16;
const v18 = v4 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v3 === 0 ? 4 : 0 : v17;
const verdict = !(fround(v4 - v4) === 0) ? 5 : v18;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const sphereBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v9 = fround(v8 - v0);
const v10 = fround(fround(v5 * v5) - (fround(fround(4 * v7) * v9)));
const v11 = fround(2 * v7);
const v12 = (fround(Math.sqrt(v10))) * (1 - 2 * +(v11 < 0));
const v13 = fround(fround(v6 - v12) / v11);
const v14 = fround(fround(v6 + v12) / v11);
t0[i] = v13;
t1[i] = v14;
const v15 = fround(Math.abs(v13) + Math.abs(v14));
if (((((2 ** 126 <= v15 || v15 <= 0) || v10 === 0) || v7 === 0) || !(Math.abs(v10) <=
3.4028234663852886e+38))) {
const v16 = v5 === 0 ? !(fround(v9 - v9) === 0) ? 5 : v9 === 0 ? 4 : 0 : 1;
const v17 = !(fround(v10 - v10) === 0) ? 5 : v10 === 0 ? 3 : v10 < 0 ? 0 : 6;
const v18 = v7 === 0 ? !(fround(v5 - v5) === 0) ? 5 : v16 : v17;
const v19 = !(fround(v7 - v7) === 0) ? 5 : v18;
const v20 = fround((-(v7 === 0 ? v9 : v5)) / (v7 === 0 ? v5 : v11));
const v21 = ((v19 === 1 || v19 === 3) && !(Math.abs(v20) < 2 ** 126)) ? 6 : v19;
const verdict = v21;
t0[i] = (v19 === 1 || v19 === 3) ? v20 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const sphereClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
const v8 = fround(v7 - v0);
const v9 = fround(fround(v5 * v5) - (fround(fround(4 * v6) * v8)));
margin[i] = v9;
if ((v9 === 0 || !(((Math.abs(v9) < 2 ** 60 && Math.abs(v5) < 2 ** 60) && 2 ** -60 <
Math.abs(v6))))) {
const v10 = v5 === 0 ? !(fround(v8 - v8) === 0) ? 5 : v8 === 0 ? 4 : 0 : 1;
const v11 = !(fround(v9 - v9) === 0) ? 5 : v9 === 0 ? 3 : v9 < 0 ? 0 : 6;
const v12 = v6 === 0 ? !(fround(v5 - v5) === 0) ? 5 : v10 : v11;
const v13 = !(fround(v6 - v6) === 0) ? 5 : v12;
const v14 = fround((-(v6 === 0 ? v8 : v5)) / (v6 === 0 ? v5 : fround(2 * v6)));
const v15 = ((v13 === 1 || v13 === 3) && !(Math.abs(v14) < 2 ** 126)) ? 6 : v13;
const verdict = v15;
margin[i] = verdict === 0 ? -1 : 1;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const paraboloidBoth: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
3.4028234663852886e+38))) {
const v13 = v3 === 0 ? !(fround(v6 - v6) === 0) ? 5 : v6 === 0 ? 4 : 0 : 1;
const v14 = !(fround(v7 - v7) === 0) ? 5 : v7 === 0 ? 3 : v7 < 0 ? 0 : 6;
const v15 = v5 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v13 : v14;
const v16 = !(fround(v5 - v5) === 0) ? 5 : v15;
const v17 = fround((-(v5 === 0 ? v6 : v3)) / (v5 === 0 ? v3 : v8));
const v18 = ((v16 === 1 || v16 === 3) && !(Math.abs(v17) < 2 ** 126)) ? 6 : v16;
const verdict = v18;
t0[i] = (v16 === 1 || v16 === 3) ? v17 : Number.NaN;
t1[i] = Number.NaN;
if (verdict !== 0) marked[left++] = i + verdict * 2 ** 28;
}
}
return left;
};

const paraboloidClasses: Loop = (n, { count, Ex, Ey, Ez, dx, dy, dz }, out, marked) => {
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
Math.abs(v4))))) {
const v7 = v3 === 0 ? !(fround(v5 - v5) === 0) ? 5 : v5 === 0 ? 4 : 0 : 1;
const v8 = !(fround(v6 - v6) === 0) ? 5 : v6 === 0 ? 3 : v6 < 0 ? 0 : 6;
const v9 = v4 === 0 ? !(fround(v3 - v3) === 0) ? 5 : v7 : v8;
const v10 = !(fround(v4 - v4) === 0) ? 5 : v9;
const v11 = fround((-(v4 === 0 ? v5 : v3)) / (v4 === 0 ? v3 : fround(2 * v4)));
const v12 = ((v10 === 1 || v10 === 3) && !(Math.abs(v11) < 2 ** 126)) ? 6 : v10;
const verdict = v12;
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
