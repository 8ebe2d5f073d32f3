/*
 * One ray by the method textbook, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import type { Vec3 } from '../../vec3.ts';
import { CONTAINED, NONE, ONE, TANGENT, TWO, UNDECIDED } from '../batch.ts';
import type { Pieces, PutForm, PutNormal, PutPoint, PutRoots } from '../one-ray.ts';

const plane: PutForm = ({ vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = (vectors.N as Vec3)[0];
const k1 = (vectors.N as Vec3)[1];
const k2 = (vectors.N as Vec3)[2];
const k3 = (vectors.P as Vec3)[0];
const k4 = (vectors.P as Vec3)[1];
const k5 = (vectors.P as Vec3)[2];
const v0 = ((k0 * (ex - k3)) + (k1 * (ey - k4))) + (k2 * (ez - k5));
const v1 = ((k0 * x) + (k1 * y)) + (k2 * z);
const v2 = (-v0) / v1;
s[0] = v0;
s[1] = v1;
s[2] = v2;
s[6] = ex + (v2 * x);
s[7] = ey + (v2 * y);
s[8] = ez + (v2 * z);
};

const cylinder: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ez = E[2];
const x = d[0];
const z = d[2];
const k0 = scalars.r as number;
const k1 = (vectors.C as Vec3)[0];
const k3 = (vectors.C as Vec3)[2];
const v0 = (x * x) + (z * z);
const v1 = ex - k1;
const v2 = ez - k3;
const v3 = ((2 * x) * v1) + ((2 * z) * v2);
const v4 = ((v1 * v1) + (v2 * v2)) - (k0 * k0);
s[0] = v0;
s[1] = v3;
s[2] = v4;
s[3] = (v3 * v3) - ((4 * v0) * v4);
};

const cone: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = scalars.c as number;
const k1 = (vectors.V as Vec3)[0];
const k2 = (vectors.V as Vec3)[1];
const k3 = (vectors.V as Vec3)[2];
const v0 = k0 * k0;
const v1 = ((x * x) + (z * z)) - (v0 * (y * y));
const v2 = ex - k1;
const v3 = ez - k3;
const v4 = ey - k2;
const v5 = (((2 * x) * v2) + ((2 * z) * v3)) - (((2 * v0) * y) * v4);
const v6 = ((v2 * v2) + (v3 * v3)) - (v0 * (v4 * v4));
s[0] = v1;
s[1] = v5;
s[2] = v6;
s[3] = (v5 * v5) - ((4 * v1) * v6);
};

const hyperboloid: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = scalars.a as number;
const k1 = scalars.r as number;
const k2 = (vectors.C as Vec3)[0];
const k3 = (vectors.C as Vec3)[1];
const k4 = (vectors.C as Vec3)[2];
const v0 = ((x * x) + (z * z)) - (k0 * (y * y));
const v1 = ex - k2;
const v2 = ez - k4;
const v3 = ey - k3;
const v4 = (((2 * x) * v1) + ((2 * z) * v2)) - (((2 * k0) * y) * v3);
const v5 = (((v1 * v1) + (v2 * v2)) - (k0 * (v3 * v3))) - (k1 * k1);
s[0] = v0;
s[1] = v4;
s[2] = v5;
s[3] = (v4 * v4) - ((4 * v0) * v5);
};

const circle: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = scalars.r as number;
const k1 = (vectors.N as Vec3)[0];
const k2 = (vectors.N as Vec3)[1];
const k3 = (vectors.N as Vec3)[2];
const k4 = (vectors.C as Vec3)[0];
const k5 = (vectors.C as Vec3)[1];
const k6 = (vectors.C as Vec3)[2];
const v0 = ((k1 * (ex - k4)) + (k2 * (ey - k5))) + (k3 * (ez - k6));
const v1 = ((k1 * x) + (k2 * y)) + (k3 * z);
const v2 = (-v0) / v1;
const v3 = ex + (v2 * x);
const v4 = ey + (v2 * y);
const v5 = ez + (v2 * z);
const v6 = v3 - k4;
const v7 = v4 - k5;
const v8 = v5 - k6;
const v9 = (Math.sqrt(((v6 * v6) + (v7 * v7)) + (v8 * v8))) - k0;
s[0] = v0;
s[1] = v1;
s[2] = v2;
s[6] = v3;
s[7] = v4;
s[8] = v5;
s[9] = v9;
};

const sphere: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = scalars.r as number;
const k1 = (vectors.C as Vec3)[0];
const k2 = (vectors.C as Vec3)[1];
const k3 = (vectors.C as Vec3)[2];
const v0 = ((x * x) + (y * y)) + (z * z);
const v1 = ex - k1;
const v2 = ey - k2;
const v3 = ez - k3;
const v4 = (((2 * x) * v1) + ((2 * y) * v2)) + ((2 * z) * v3);
const v5 = (((v1 * v1) + (v2 * v2)) + (v3 * v3)) - (k0 * k0);
s[0] = v0;
s[1] = v4;
s[2] = v5;
s[3] = (v4 * v4) - ((4 * v0) * v5);
};

const paraboloid: PutForm = ({ scalars, vectors }, E, d, s) => {
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
const k0 = scalars.k as number;
const k1 = (vectors.V as Vec3)[0];
const k2 = (vectors.V as Vec3)[1];
const k3 = (vectors.V as Vec3)[2];
const v0 = (x * x) + (z * z);
const v1 = ex - k1;
const v2 = ez - k3;
const v3 = (((2 * x) * v1) + ((2 * z) * v2)) - (k0 * y);
const v4 = ((v1 * v1) + (v2 * v2)) - (k0 * (ey - k2));
s[0] = v0;
s[1] = v3;
s[2] = v4;
s[3] = (v3 * v3) - ((4 * v0) * v4);
};

const point: PutPoint = (E, d, s, root) => {
const t = s[4 + root] as number;
const ex = E[0];
const ey = E[1];
const ez = E[2];
const x = d[0];
const y = d[1];
const z = d[2];
s[6] = ex + (t * x);
s[7] = ey + (t * y);
s[8] = ez + (t * z);
};

const cylinderNormal: PutNormal = ({ vectors }, s) => {
const p0 = s[6] as number;
const p2 = s[8] as number;
const k1 = (vectors.C as Vec3)[0];
const k3 = (vectors.C as Vec3)[2];
s[9] = p0 - k1;
s[10] = 0;
s[11] = p2 - k3;
};

const coneNormal: PutNormal = ({ scalars, vectors }, s) => {
const p0 = s[6] as number;
const p1 = s[7] as number;
const p2 = s[8] as number;
const k0 = scalars.c as number;
const k1 = (vectors.V as Vec3)[0];
const k2 = (vectors.V as Vec3)[1];
const k3 = (vectors.V as Vec3)[2];
s[9] = p0 - k1;
s[10] = (-(k0 * k0)) * (p1 - k2);
s[11] = p2 - k3;
};

const hyperboloidNormal: PutNormal = ({ scalars, vectors }, s) => {
const p0 = s[6] as number;
const p1 = s[7] as number;
const p2 = s[8] as number;
const k0 = scalars.a as number;
const k2 = (vectors.C as Vec3)[0];
const k3 = (vectors.C as Vec3)[1];
const k4 = (vectors.C as Vec3)[2];
s[9] = p0 - k2;
s[10] = (-k0) * (p1 - k3);
s[11] = p2 - k4;
};

const sphereNormal: PutNormal = ({ vectors }, s) => {
const p0 = s[6] as number;
const p1 = s[7] as number;
const p2 = s[8] as number;
const k1 = (vectors.C as Vec3)[0];
const k2 = (vectors.C as Vec3)[1];
const k3 = (vectors.C as Vec3)[2];
s[9] = p0 - k1;
s[10] = p1 - k2;
s[11] = p2 - k3;
};

const paraboloidNormal: PutNormal = ({ scalars, vectors }, s) => {
const p0 = s[6] as number;
const p2 = s[8] as number;
const k0 = scalars.k as number;
const k1 = (vectors.V as Vec3)[0];
const k3 = (vectors.V as Vec3)[2];
s[9] = p0 - k1;
s[10] = -(k0 * 0.5);
s[11] = p2 - k3;
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
s[4] = (-C) / B;
return ONE;
}
if (D - D !== 0) {
return UNDECIDED;
}
if (D === 0) {
s[4] = (-B) / (2 * A);
return TANGENT;
}
if (D < 0) {
return NONE;
}
const v0 = -B;
const v1 = Math.sqrt(D);
const v2 = 2 * A;
const v3 = (v0 - v1) / v2;
const v4 = (v0 + v1) / v2;
s[4] = v4 < v3 ? v4 : v3;
s[5] = v4 < v3 ? v3 : v4;
return TWO;
};

export const ONE_RAY: Pieces = {
forms: {
plane: plane,
cylinder: cylinder,
cone: cone,
hyperboloid: hyperboloid,
circle: circle,
sphere: sphere,
paraboloid: paraboloid,
},
point,
normals: {
cylinder: cylinderNormal,
cone: coneNormal,
hyperboloid: hyperboloidNormal,
sphere: sphereNormal,
paraboloid: paraboloidNormal,
},
roots,
};
