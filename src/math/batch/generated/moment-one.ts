/*
 * One ray by the method moment, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import type { Vec3 } from '../../vec3.ts';
import type { OneRay, PutForm } from '../one-ray.ts';
import { ONE_RAY as stable } from './stable-one.ts';

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
const v3 = k0 * k0;
const v4 = (z * v1) - (x * v2);
s[0] = v0;
s[1] = ((2 * x) * v1) + ((2 * z) * v2);
s[2] = ((v1 * v1) + (v2 * v2)) - v3;
s[3] = 4 * ((v3 * v0) - (v4 * v4));
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
const v1 = ex - k1;
const v2 = ez - k3;
const v3 = ey - k2;
const v4 = (((2 * x) * v1) + ((2 * z) * v2)) - (((2 * v0) * y) * v3);
const v5 = (y * v2) - (z * v3);
const v6 = (x * v3) - (y * v1);
const v7 = (z * v1) - (x * v2);
const v8 = 4 * ((v0 * ((v5 * v5) + (v6 * v6))) - (v7 * v7));
s[0] = ((x * x) + (z * z)) - (v0 * (y * y));
s[1] = v4;
s[2] = ((v1 * v1) + (v2 * v2)) - (v0 * (v3 * v3));
s[3] = v8;
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
const v5 = k1 * k1;
const v6 = (((v1 * v1) + (v2 * v2)) - (k0 * (v3 * v3))) - v5;
const v7 = (y * v2) - (z * v3);
const v8 = (x * v3) - (y * v1);
const v9 = (z * v1) - (x * v2);
const v10 = ((v5 * v0) + (k0 * ((v7 * v7) + (v8 * v8)))) - (v9 * v9);
s[0] = v0;
s[1] = v4;
s[2] = v6;
s[3] = 4 * v10;
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
const v5 = k0 * k0;
const v6 = (y * v3) - (z * v2);
const v7 = (z * v1) - (x * v3);
const v8 = (x * v2) - (y * v1);
const v9 = (v5 * v0) - (((v6 * v6) + (v7 * v7)) + (v8 * v8));
s[0] = v0;
s[1] = v4;
s[2] = (((v1 * v1) + (v2 * v2)) + (v3 * v3)) - v5;
s[3] = 4 * v9;
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
const v0 = ex - k1;
const v1 = ez - k3;
const v2 = ey - k2;
const v3 = (x * ((x * v2) - (y * v0))) - (z * ((y * v1) - (z * v2)));
const v4 = (z * v0) - (x * v1);
const v5 = (((k0 * k0) * (y * y)) + ((4 * k0) * v3)) - (4 * (v4 * v4));
s[0] = (x * x) + (z * z);
s[1] = (((2 * x) * v0) + ((2 * z) * v1)) - (k0 * y);
s[2] = ((v0 * v0) + (v1 * v1)) - (k0 * v2);
s[3] = v5;
};

export const ONE_RAY: OneRay = {
forms: {
cylinder: cylinder,
cone: cone,
hyperboloid: hyperboloid,
sphere: sphere,
paraboloid: paraboloid,
},
roots: stable.roots,
};
