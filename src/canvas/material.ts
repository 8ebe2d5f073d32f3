import {
  AddEquation,
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  DynamicDrawUsage,
  GLSL3,
  type IUniform,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  type Side,
} from 'three';

interface Options {
  readonly vertexShader: string;
  readonly fragmentShader: string;
  readonly uniforms: Record<string, IUniform>;
  readonly side: Side;
  readonly depthWrite: boolean;
}

export type ShadedMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** A mesh with its own shader, which blends premultiplied sRGB colours over the picture. */
export function shadedMesh(geometry: BufferGeometry, options: Options): ShadedMesh {
  const material = new RawShaderMaterial({
    ...options,
    glslVersion: GLSL3,
    transparent: true,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
  });
  const mesh = new Mesh(geometry, material);
  // Positions are final and in view, so three.js need not transform or cull.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** An empty geometry for so many vertices and indices; `sizes`: numbers per vertex. */
export function roomFor(
  vertices: number,
  indices: number,
  sizes: Readonly<Record<string, number>>,
): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const [name, size] of Object.entries(sizes)) {
    // Colours are bytes: four times less to upload.
    const attribute =
      name === 'color'
        ? new BufferAttribute(new Uint8ClampedArray(vertices * size), size, true)
        : new BufferAttribute(new Float32Array(vertices * size), size);
    geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
  }
  const index = new BufferAttribute(new Uint32Array(indices), 1);
  geometry.setIndex(index.setUsage(DynamicDrawUsage));
  return geometry;
}

/** Sends the part of a geometry that is in use to the GPU, and draws only that. */
export function uploadPart(geometry: BufferGeometry, vertices: number, indices: number): void {
  geometry.setDrawRange(0, indices);
  const send = (attribute: BufferAttribute, count: number) => {
    attribute.clearUpdateRanges();
    if (count === 0) return;
    attribute.addUpdateRange(0, count);
    attribute.needsUpdate = true;
  };
  for (const attribute of Object.values(geometry.attributes) as BufferAttribute[]) {
    send(attribute, vertices * attribute.itemSize);
  }
  if (geometry.index) send(geometry.index, indices);
}
