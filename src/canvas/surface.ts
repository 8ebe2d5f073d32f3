import {
  BackSide,
  type BufferAttribute,
  BufferGeometry,
  FrontSide,
  type Side,
  Vector2,
  Vector3,
} from 'three';
import { roomFor, type ShadedMesh, shadedMesh, uploadPart } from './material.ts';
import type { Projection } from './projection.ts';
import { at } from './stroke.ts';
import type { Grid } from './tessellation.ts';
import type { Theme } from './theme.ts';

const VERTEX = `
uniform mat4 viewMatrix; uniform mat4 projectionMatrix;
in vec3 position; in vec3 normal; in float fade;
out vec3 place; out vec3 up; out float rest;
void main() {
  place = position; up = normal; rest = fade;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;

// A thin wall of coloured glass, which is less transparent at grazing angles.
const FRAGMENT = `
precision highp float;
uniform vec3 eye; uniform vec3 ink; uniform vec2 opacity;
in vec3 place; in vec3 up; in float rest; out vec4 result;
void main() {
  float facing = abs(dot(normalize(up), normalize(eye - place)));
  float a = mix(opacity.x, opacity.y, pow(1.0 - min(facing, 1.0), 2.2)) * rest;
  // Noise of half a level hides banding of 8-bit colours.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  a += (noise - 0.5) / 160.0;
  result = vec4(ink * a, a);
}`;

const SIZES = { position: 3, normal: 3, fade: 1 } as const;

/** All patches as one mesh, drawn twice: back walls, then front walls; without writing depth. */
export class Surface {
  readonly back = wall(BackSide);
  readonly front = wall(FrontSide);

  /** Uploads new patches; the buffers are kept while they are large enough. */
  fill(grids: readonly Grid[]): void {
    const vertices = grids.reduce((sum, grid) => sum + grid.fade.length, 0);
    const quads = grids.reduce((sum, grid) => sum + grid.columns * grid.rows, 0);
    const geometry = this.#room(vertices, 6 * quads);
    const { position, normal, fade } = geometry.attributes as Record<string, BufferAttribute>;
    const index = geometry.index as BufferAttribute;
    let [first, used] = [0, 0];
    for (const grid of grids) {
      position?.array.set(grid.points, 3 * first);
      // NaN must not reach the GPU, also not at vertices that are in no triangle.
      normal?.array.set(
        grid.normals.map((x) => (Number.isNaN(x) ? 0 : x)),
        3 * first,
      );
      fade?.array.set(grid.fade, first);
      used = addTriangles(grid, first, index.array, used);
      first += grid.fade.length;
    }
    uploadPart(geometry, first, used);
    this.back.visible = used > 0;
    this.front.visible = used > 0;
  }

  look(projection: Projection, theme: Theme): void {
    for (const [mesh, { base, rim }] of [
      [this.back, theme.back],
      [this.front, theme.front],
    ] as const) {
      const { eye, ink, opacity } = mesh.material.uniforms;
      eye?.value.set(...projection.eye);
      ink?.value.set(...theme.inks.shape);
      opacity?.value.set(base, rim);
    }
  }

  dispose(): void {
    this.back.geometry.dispose();
    this.back.material.dispose();
    this.front.material.dispose();
  }

  #room(vertices: number, indices: number): BufferGeometry {
    const old = this.back.geometry;
    if ((old.attributes.position?.count ?? 0) >= vertices && (old.index?.count ?? 0) >= indices) {
      return old;
    }
    const geometry = roomFor(vertices, indices, SIZES);
    old.dispose();
    this.back.geometry = geometry;
    this.front.geometry = geometry;
    return geometry;
  }
}

function wall(side: Side): ShadedMesh {
  return shadedMesh(new BufferGeometry(), {
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      eye: { value: new Vector3() },
      ink: { value: new Vector3() },
      opacity: { value: new Vector2() },
    },
    side,
    depthWrite: false,
  });
}

/**
 * Returns how many indices are used after this grid. Triangles at a point without a normal are left
 * out.
 */
function addTriangles(
  grid: Grid,
  first: number,
  index: { [k: number]: number },
  used: number,
): number {
  const { columns, rows, normals, outward } = grid;
  const across = columns + 1;
  let next = used;
  const triangle = (a: number, b: number, c: number) => {
    if (Number.isNaN(at(normals, 3 * a) + at(normals, 3 * b) + at(normals, 3 * c))) return;
    index[next++] = first + a;
    index[next++] = first + (outward ? b : c);
    index[next++] = first + (outward ? c : b);
  };
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const k = j * across + i;
      triangle(k, k + 1, k + across);
      triangle(k + across, k + 1, k + across + 1);
    }
  }
  return next;
}
