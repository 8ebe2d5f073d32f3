import { type BufferAttribute, type BufferGeometry, FrontSide } from 'three';
import { roomFor, type ShadedMesh, shadedMesh, uploadPart } from './material.ts';
import { at, type Pen, type Run, type Stroke } from './stroke.ts';
import type { Theme } from './theme.ts';

// Positions arrive in normalised device coordinates: the CPU has projected them in doubles.
const VERTEX = `
in vec3 position; in vec4 color; in vec3 across; in vec2 dash;
out vec4 ink; out vec3 place; out vec2 pattern;
void main() { ink = color; place = across; pattern = dash; gl_Position = vec4(position, 1.0); }`;

// Edges are feathered over one device pixel by distance, so no multisampling is needed: it costs
// most where WebGL runs in software.
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

const SIZES = { position: 3, across: 3, dash: 2, color: 4 } as const;
const FIRST_ROOM = 4096;
/** The triangles between two points of a ribbon, each with a vertex on either side. */
const QUAD = [0, 1, 2, 2, 1, 3] as const;
/** Longest mitre, in half widths of the line; a longer one would be a spike. */
const MITRE_LIMIT = 2;

/** Draws strokes as one mesh of ribbons in one call. Buffers are reused, and grow by half. */
export class Ribbons implements Pen {
  readonly mesh: ShadedMesh;
  #vertices = 0;
  #indices = 0;
  #theme!: Theme;
  #width = 1;
  #height = 1;
  #ratio = 1;
  // The buffers' arrays, as fields for the inner loop.
  #position!: Float32Array;
  #across!: Float32Array;
  #dash!: Float32Array;
  #color!: Uint8ClampedArray;

  constructor(writesDepth: boolean) {
    this.mesh = shadedMesh(allocate(FIRST_ROOM), {
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ratio: { value: 1 } },
      side: FrontSide,
      depthWrite: writesDepth,
    });
    this.#open(this.mesh.geometry);
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
    for (let k = 0, v = first; k < points - 1; k++, v += 2) {
      for (const corner of QUAD) index[this.#indices++] = v + corner;
    }
  }

  end(): void {
    const { geometry, material } = this.mesh;
    uploadPart(geometry, this.#vertices, this.#indices);
    this.mesh.visible = this.#indices > 0;
    (material.uniforms.ratio as { value: number }).value = this.#ratio;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  /** Adds two vertices on the mitre line of a point, half the width and the feather away. */
  #addPoint(run: Run, k: number, length: number, stroke: Stroke): void {
    const { count, closed, data } = run;
    const here = k % count;
    const before = closed ? (here + count - 1) % count : Math.max(here - 1, 0);
    const after = closed ? (here + 1) % count : Math.min(here + 1, count - 1);
    const [ax, ay] = normal(data, before === here ? after : before, here, before === here ? -1 : 1);
    const [bx, by] = normal(data, here, after === here ? before : after, after === here ? -1 : 1);
    const squared = Math.max((ax + bx) ** 2 + (ay + by) ** 2, 4 / MITRE_LIMIT ** 2);
    const half = (stroke.width * this.#theme.scale) / 2;
    const reach = half + 1 / this.#ratio;
    // (a + b) · 2/|a + b|² is the mitre: its component along either normal is 1.
    const mx = (2 * reach * (ax + bx)) / squared;
    const my = (2 * reach * (ay + by)) / squared;
    const d = 4 * here;
    const opacity = stroke.alpha * at(data, d + 3);
    for (let side = -1; side <= 1; side += 2) {
      const v = this.#vertices++;
      const x = at(data, d) + side * mx;
      const y = at(data, d + 1) + side * my;
      write3(
        this.#position,
        v,
        (2 * x) / this.#width - 1,
        1 - (2 * y) / this.#height,
        at(data, d + 2),
      );
      write3(this.#across, v, side * reach, half, length);
      this.#style(v, stroke, opacity);
    }
  }

  #style(v: number, { ink, dash }: Stroke, opacity: number): void {
    const { scale, inks } = this.#theme;
    this.#dash[2 * v] = dash ? dash[0] * scale : 0;
    this.#dash[2 * v + 1] = dash ? (dash[0] + dash[1]) * scale : 0;
    const color = inks[ink];
    write3(this.#color, v, color[0] * 255, color[1] * 255, color[2] * 255, 4);
    this.#color[4 * v + 3] = opacity * 255;
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
    this.#open(grown);
  }

  #open(geometry: BufferGeometry): void {
    const array = (name: string) => (geometry.attributes[name] as BufferAttribute).array;
    this.#position = array('position') as Float32Array;
    this.#across = array('across') as Float32Array;
    this.#dash = array('dash') as Float32Array;
    this.#color = array('color') as Uint8ClampedArray;
  }
}

function write3(
  list: { [k: number]: number },
  v: number,
  x: number,
  y: number,
  z: number,
  stride = 3,
): void {
  list[stride * v] = x;
  list[stride * v + 1] = y;
  list[stride * v + 2] = z;
}

function allocate(vertices: number): BufferGeometry {
  return roomFor(vertices, 3 * vertices, SIZES);
}

/** Unit normal of the piece from point i to j; `sign` is −1 if the piece is reversed. */
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
