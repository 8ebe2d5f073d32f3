import { Camera, Color, Scene, SRGBColorSpace, WebGLRenderer } from 'three';
import { type Painter, RAY_NEARER, type Strokes } from './painter.ts';
import type { Projection } from './projection.ts';
import { Ribbons } from './ribbons.ts';
import { paint } from './stroke.ts';
import { Surface } from './surface.ts';
import type { Grid } from './tessellation.ts';
import type { Theme } from './theme.ts';

/** Largest ratio of device to CSS px; edges are feathered, so more would only take time. */
const MOST_PIXEL_RATIO = 2;

/**
 * Five draw calls: ground, ray, back walls, front walls, lines of the shape. The ray comes first
 * and writes depth, so a front wall tints it, and a back wall does not.
 */
export class GlPainter implements Painter {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new Camera();
  readonly #ground = new Ribbons(false);
  readonly #ray = new Ribbons(true);
  readonly #surface = new Surface();
  readonly #shape = new Ribbons(false);
  readonly #clear = new Color();
  #size = '';

  /** Null without WebGL, which is tested before three.js, as that writes errors to the console. */
  static on(canvas: HTMLCanvasElement): GlPainter | null {
    try {
      const context = canvas.getContext('webgl2', { alpha: true, antialias: false, depth: true });
      return context && new GlPainter(canvas, context);
    } catch {
      return null;
    }
  }

  private constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.#renderer = new WebGLRenderer({ canvas, context, alpha: true, antialias: false });
    // Objects are painted in the order in which they are added, not sorted by depth.
    this.#renderer.sortObjects = false;
    this.#scene.matrixWorldAutoUpdate = false;
    this.#scene.add(this.#ground.mesh, this.#ray.mesh);
    this.#scene.add(this.#surface.back, this.#surface.front, this.#shape.mesh);
    this.#camera.matrixWorldAutoUpdate = false;
  }

  /** Uploads changed patches. */
  fill(grids: readonly Grid[]): void {
    this.#surface.fill(grids);
  }

  paint(
    strokes: Strokes,
    projection: Projection,
    theme: Theme,
    ratio = Math.min(devicePixelRatio, MOST_PIXEL_RATIO),
  ): void {
    this.#resize(projection.width, projection.height, ratio);
    for (const [ribbons, list, nearer] of [
      [this.#ground, strokes.ground, 0],
      [this.#ray, strokes.ray, RAY_NEARER],
      [this.#shape, strokes.shape, 0],
    ] as const) {
      ribbons.begin(theme, projection.width, projection.height, ratio);
      for (const stroke of list) paint(stroke, projection, ribbons, nearer);
      ribbons.end();
    }
    // On an opaque background faint walls have no banding, unlike 8-bit premultiplied colours.
    this.#renderer.setClearColor(this.#clear.setRGB(...theme.scene, SRGBColorSpace), 1);
    this.#surface.look(projection, theme);
    const camera = this.#camera;
    camera.matrixWorldInverse.fromArray(projection.viewMatrix());
    camera.matrixWorld.copy(camera.matrixWorldInverse).invert();
    camera.projectionMatrix.fromArray(projection.projectionMatrix());
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    this.#renderer.render(this.#scene, camera);
  }

  /** Counts of GPU objects, by which tests find leaks. */
  get memory(): string {
    const { memory, render } = this.#renderer.info;
    return `${memory.geometries} geometries, ${memory.textures} textures, ${render.calls} calls`;
  }

  dispose(): void {
    // Browsers allow few contexts, counting those that are not garbage-collected yet. Losing the
    // context first frees everything at once.
    this.#renderer.forceContextLoss();
    for (const part of [this.#ground, this.#ray, this.#surface, this.#shape]) part.dispose();
    this.#renderer.dispose();
  }

  #resize(width: number, height: number, ratio: number): void {
    const size = `${width} ${height} ${ratio}`;
    if (size === this.#size) return;
    this.#size = size;
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
  }
}
