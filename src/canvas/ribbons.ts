import {
  AddEquation,
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  DynamicDrawUsage,
  GLSL3,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
} from 'three';
import { at, type Pen, type Run, type Stroke } from './stroke.ts';
import type { Theme } from './theme.ts';

// Positions arrive in normalised device coordinates: the CPU has projected them in doubles.
const VERTEX = `
in vec3 position; in vec4 color; in vec3 across; in vec2 dash;
out vec4 ink; out vec3 place; out vec2 pattern;
void main() { ink = color; place = across; pattern = dash; gl_Position = vec4(position, 1.0); }`;

// Edges are feathered over one device pixel by distance, so no multisampling is needed: it costs most where WebGL runs in software.
const FRAGMENT = `
precision highp float;
in vec4 ink; in vec3 place; in vec2 pattern; out vec4 result;
uniform float ratio;
void main() {
  float half_ = place.y;
  float cover = clamp((half_ - abs(place.x)) * ratio + 0.5, 0.0, min(1.0, 2.0 * half_ * ratio));
  if (pattern.y > 0.0) {
    float m = mod(place.z, pattern.y);
    cover *= clamp(min(m, pattern.x - m) * ratio + 0.5, 0.0, 1.0);
  }
  float a = ink.a * cover;
  if (a < 0.004) discard;
  result = vec4(ink.rgb * a, a);
}`;

const POSITION = 3;
const ACROSS = 3;
const DASH = 2;
/** A mitre longer than this many half widths would be a spike. */
const MITRE_LIMIT = 2;

/** Strokes as one mesh of flat ribbons, one draw call. Buffers grow by half and are otherwise reused from frame to frame. */
export class Ribbons implements Pen {
  readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  #vertices = 0;
  #indices = 0;
  #theme!: Theme;
  #width = 1;
  #height = 1;
  #ratio = 1;

  constructor(writesDepth: boolean) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ratio: { value: 1 } },
      transparent: true,
      depthWrite: writesDepth,
      blending: CustomBlending,
      blendEquation: AddEquation,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
    this.mesh = new Mesh(allocate(2048), material);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
  }

  begin(theme: Theme, width: number, height: number, ratio: number): void {
    this.#vertices = 0;
    this.#indices = 0;
    this.#theme = theme;
    this.#width = width;
    this.#height = height;
    this.#ratio = ratio;
  }

  draw(run: Run, stroke: Stroke): void {
    const first = this.#vertices;
    const points = run.closed ? run.count + 1 : run.count;
    this.#reserve(first + 2 * points);
    let length = 0;
    for (let k = 0; k < points; k++) {
      if (k > 0) length += distance(run, k - 1, k % run.count);
      this.#addPoint(run, k, length, stroke);
    }
    const index = this.mesh.geometry.index?.array as Uint32Array;
    for (let k = 0; k < points - 1; k++) {
      const v = first + 2 * k;
      index.set([v, v + 1, v + 2, v + 2, v + 1, v + 3], this.#indices);
      this.#indices += 6;
    }
  }

  end(): void {
    const { geometry, material } = this.mesh;
    geometry.setDrawRange(0, this.#indices);
    this.mesh.visible = this.#indices > 0;
    for (const attribute of Object.values(geometry.attributes) as BufferAttribute[]) {
      upload(attribute, this.#vertices * attribute.itemSize);
    }
    if (geometry.index) upload(geometry.index, this.#indices);
    (material.uniforms.ratio as { value: number }).value = this.#ratio;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  /** Two vertices on the mitre line of a point, half a width and the feather away from it. */
  #addPoint(run: Run, k: number, length: number, stroke: Stroke): void {
    const { count, closed, data } = run;
    const here = k % count;
    const before = closed ? (here + count - 1) % count : Math.max(here - 1, 0);
    const after = closed ? (here + 1) % count : Math.min(here + 1, count - 1);
    const [ax, ay] = normal(data, before === here ? after : before, here, before === here ? -1 : 1);
    const [bx, by] = normal(data, here, after === here ? before : after, after === here ? -1 : 1);
    const squared = Math.max((ax + bx) ** 2 + (ay + by) ** 2, 4 / MITRE_LIMIT ** 2);
    const scale = this.#theme.scale;
    const half = (stroke.width * scale) / 2;
    const reach = half + 1 / this.#ratio;
    // (a + b) · 2/|a + b|² is the mitre: its component along either normal is 1.
    const [mx, my] = [(2 * (ax + bx)) / squared, (2 * (ay + by)) / squared];
    const [x, y, depth] = [at(data, 4 * here), at(data, 4 * here + 1), at(data, 4 * here + 2)];
    const attributes = this.mesh.geometry.attributes as Record<string, BufferAttribute>;
    const color = this.#theme.inks[stroke.ink];
    const [on, off] = stroke.dash ?? [0, 0];
    for (const side of [-1, 1]) {
      const v = this.#vertices++;
      const px = x + side * reach * mx;
      const py = y + side * reach * my;
      (attributes.position as BufferAttribute).array.set(
        [(2 * px) / this.#width - 1, 1 - (2 * py) / this.#height, depth],
        v * POSITION,
      );
      (attributes.across as BufferAttribute).array.set([side * reach, half, length], v * ACROSS);
      (attributes.dash as BufferAttribute).array.set([on * scale, (on + off) * scale], v * DASH);
      (attributes.color as BufferAttribute).array.set(
        [
          color[0] * 255,
          color[1] * 255,
          color[2] * 255,
          stroke.alpha * at(data, 4 * here + 3) * 255,
        ],
        v * 4,
      );
    }
  }

  #reserve(vertices: number): void {
    const old = this.mesh.geometry;
    const room = (old.attributes.position as BufferAttribute).count;
    if (vertices <= room) return;
    const grown = allocate(Math.ceil(vertices * 1.5));
    for (const [name, attribute] of Object.entries(grown.attributes)) {
      (attribute as BufferAttribute).array.set((old.attributes[name] as BufferAttribute).array);
    }
    grown.index?.array.set(old.index?.array ?? []);
    old.dispose();
    this.mesh.geometry = grown;
  }
}

function allocate(vertices: number): BufferGeometry {
  const geometry = new BufferGeometry();
  const add = (name: string, attribute: BufferAttribute) =>
    geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
  add('position', new BufferAttribute(new Float32Array(vertices * POSITION), POSITION));
  add('across', new BufferAttribute(new Float32Array(vertices * ACROSS), ACROSS));
  add('dash', new BufferAttribute(new Float32Array(vertices * DASH), DASH));
  add('color', new BufferAttribute(new Uint8ClampedArray(vertices * 4), 4, true));
  geometry.setIndex(
    new BufferAttribute(new Uint32Array(vertices * 3), 1).setUsage(DynamicDrawUsage),
  );
  return geometry;
}

/** Only the part in use goes to the GPU. */
function upload(attribute: BufferAttribute, count: number): void {
  attribute.clearUpdateRanges();
  if (count === 0) return;
  attribute.addUpdateRange(0, count);
  attribute.needsUpdate = true;
}

/** The unit normal of the piece from point i to point j; `sign` −1 when it is walked backwards. */
function normal(data: readonly number[], i: number, j: number, sign: number): [number, number] {
  const dx = at(data, 4 * j) - at(data, 4 * i);
  const dy = at(data, 4 * j + 1) - at(data, 4 * i + 1);
  const length = Math.hypot(dx, dy) || 1;
  return [(-sign * dy) / length, (sign * dx) / length];
}

function distance(run: Run, i: number, j: number): number {
  const { data } = run;
  return Math.hypot(at(data, 4 * j) - at(data, 4 * i), at(data, 4 * j + 1) - at(data, 4 * i + 1));
}
