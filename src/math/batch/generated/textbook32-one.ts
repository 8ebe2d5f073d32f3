/*
 * One ray by the method textbook, float32, in float32.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import type { Vec3 } from '../../vec3.ts';
import { CONTAINED, NONE, ONE, TANGENT, TWO, UNDECIDED } from '../batch.ts';
import type { OneRay, PutForm, PutRoots } from '../one-ray.ts';

const { fround } = Math;

const cylinder: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = fround(E[0]);
const ez = fround(E[2]);
const x = fround(d[0]);
const z = fround(d[2]);
const k0 = fround(scalars.r as number);
const k1 = fround((vectors.C as Vec3)[0]);
const k3 = fround((vectors.C as Vec3)[2]);
const v0 = fround(fround(x * x) + fround(z * z));
const v1 = fround(ex - k1);
const v2 = fround(ez - k3);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * z) * v2)));
const v4 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) - fround(k0 * k0));
const v5 = fround(fround(v3 * v3) - (fround(fround(4 * v0) * v4)));
s[0] = v0;
s[1] = v3;
s[2] = v4;
s[3] = v5;
};

const cone: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = fround(E[0]);
const ey = fround(E[1]);
const ez = fround(E[2]);
const x = fround(d[0]);
const y = fround(d[1]);
const z = fround(d[2]);
const k0 = fround(scalars.c as number);
const k1 = fround((vectors.V as Vec3)[0]);
const k2 = fround((vectors.V as Vec3)[1]);
const k3 = fround((vectors.V as Vec3)[2]);
const v0 = fround(k0 * k0);
const v1 = fround((fround(fround(x * x) + fround(z * z))) - (fround(v0 * fround(y * y))));
const v2 = fround(ex - k1);
const v3 = fround(ez - k3);
const v4 = fround((fround(fround(2 * x) * v2)) + (fround(fround(2 * z) * v3)));
const v5 = fround(ey - k2);
const v6 = fround(v4 - (fround((fround(fround(2 * v0) * y)) * v5)));
const v7 = fround((fround(fround(v2 * v2) + fround(v3 * v3))) - (fround(v0 * fround(v5 * v5))));
const v8 = fround(fround(v6 * v6) - (fround(fround(4 * v1) * v7)));
s[0] = v1;
s[1] = v6;
s[2] = v7;
s[3] = v8;
};

const hyperboloid: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = fround(E[0]);
const ey = fround(E[1]);
const ez = fround(E[2]);
const x = fround(d[0]);
const y = fround(d[1]);
const z = fround(d[2]);
const k0 = fround(scalars.a as number);
const k1 = fround(scalars.r as number);
const k2 = fround((vectors.C as Vec3)[0]);
const k3 = fround((vectors.C as Vec3)[1]);
const k4 = fround((vectors.C as Vec3)[2]);
const v0 = fround((fround(fround(x * x) + fround(z * z))) - (fround(k0 * fround(y * y))));
const v1 = fround(ex - k2);
const v2 = fround(ez - k4);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * z) * v2)));
const v4 = fround(ey - k3);
const v5 = fround(v3 - (fround((fround(fround(2 * k0) * y)) * v4)));
const v6 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) - (fround(k0 * fround(v4 * v4))));
const v7 = fround(v6 - fround(k1 * k1));
const v8 = fround(fround(v5 * v5) - (fround(fround(4 * v0) * v7)));
s[0] = v0;
s[1] = v5;
s[2] = v7;
s[3] = v8;
};

const sphere: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = fround(E[0]);
const ey = fround(E[1]);
const ez = fround(E[2]);
const x = fround(d[0]);
const y = fround(d[1]);
const z = fround(d[2]);
const k0 = fround(scalars.r as number);
const k1 = fround((vectors.C as Vec3)[0]);
const k2 = fround((vectors.C as Vec3)[1]);
const k3 = fround((vectors.C as Vec3)[2]);
const v0 = fround((fround(fround(x * x) + fround(y * y))) + fround(z * z));
const v1 = fround(ex - k1);
const v2 = fround(ey - k2);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * y) * v2)));
const v4 = fround(ez - k3);
const v5 = fround(v3 + (fround(fround(2 * z) * v4)));
const v6 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) + fround(v4 * v4));
const v7 = fround(v6 - fround(k0 * k0));
const v8 = fround(fround(v5 * v5) - (fround(fround(4 * v0) * v7)));
s[0] = v0;
s[1] = v5;
s[2] = v7;
s[3] = v8;
};

const paraboloid: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = fround(E[0]);
const ey = fround(E[1]);
const ez = fround(E[2]);
const x = fround(d[0]);
const y = fround(d[1]);
const z = fround(d[2]);
const k0 = fround(scalars.k as number);
const k1 = fround((vectors.V as Vec3)[0]);
const k2 = fround((vectors.V as Vec3)[1]);
const k3 = fround((vectors.V as Vec3)[2]);
const v0 = fround(fround(x * x) + fround(z * z));
const v1 = fround(ex - k1);
const v2 = fround(ez - k3);
const v3 = fround((fround(fround(2 * x) * v1)) + (fround(fround(2 * z) * v2)));
const v4 = fround(v3 - fround(k0 * y));
const v5 = fround((fround(fround(v1 * v1) + fround(v2 * v2))) - (fround(k0 * fround(ey - k2))));
const v6 = fround(fround(v4 * v4) - (fround(fround(4 * v0) * v5)));
s[0] = v0;
s[1] = v4;
s[2] = v5;
s[3] = v6;
};

const roots: PutRoots = (s) => {
s[4] = Number.NaN;
s[5] = Number.NaN;
const A = s[0] as number;
const B = s[1] as number;
const C = s[2] as number;
const D = s[3] as number;
if (A - A !== 0) {
return UNDECIDED;
}
if (A === 0) {
if (B - B !== 0) {
return UNDECIDED;
}
if (B === 0) {
if (C - C !== 0) {
return UNDECIDED;
}
if (C === 0) {
return CONTAINED;
}
return NONE;
}
s[4] = fround((-C) / B);
return ONE;
}
if (D - D !== 0) {
return UNDECIDED;
}
if (D === 0) {
s[4] = fround((-B) / fround(2 * A));
return TANGENT;
}
if (D < 0) {
return NONE;
}
const v0 = -B;
const v1 = fround(Math.sqrt(D));
const v2 = fround(2 * A);
const v3 = fround(fround(v0 - v1) / v2);
const v4 = fround(fround(v0 + v1) / v2);
s[4] = v4 < v3 ? v4 : v3;
s[5] = v4 < v3 ? v3 : v4;
return TWO;
};

export const ONE_RAY: OneRay = {
forms: {
cylinder: cylinder,
cone: cone,
hyperboloid: hyperboloid,
sphere: sphere,
paraboloid: paraboloid,
},
roots,
};
