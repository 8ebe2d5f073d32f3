import { sizeOf } from './zoom.ts';

/** Style properties that are copied into an exported drawing, which has no style sheet. */
const KEPT = [
  'fill',
  'fill-opacity',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-linecap',
  'stroke-linejoin',
  'stroke-opacity',
  'opacity',
  'paint-order',
  'font-family',
  'font-size',
  'font-style',
  'font-weight',
  'text-anchor',
  'dominant-baseline',
  'visibility',
  'display',
] as const;

/** An SVG of the page as a file: with computed styles in each element and a painted background. */
export function svgText(source: SVGSVGElement, background: string): string {
  const { width, height } = sizeOf(source);
  const copy = source.cloneNode(true) as SVGSVGElement;
  inline(source, copy);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', String(width));
  copy.setAttribute('height', String(height));
  if (!copy.hasAttribute('viewBox')) copy.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const paper = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  paper.setAttribute('width', '100%');
  paper.setAttribute('height', '100%');
  paper.setAttribute('fill', background);
  copy.prepend(paper);
  return new XMLSerializer().serializeToString(copy);
}

function inline(from: Element, to: Element): void {
  const style = getComputedStyle(from);
  // Presentation attributes, since the page's content security policy forbids style attributes.
  for (const name of KEPT) to.setAttribute(name, style.getPropertyValue(name));
  to.removeAttribute('class');
  for (let i = 0; i < from.children.length; i++) {
    const [a, b] = [from.children[i], to.children[i]];
    if (a && b) inline(a, b);
  }
}

/** Pixels of the PNG per CSS pixel: 2, for print. */
const PNG_SCALE = 2;

/** The SVG as a PNG; null if the browser refuses to draw it. */
export async function svgPng(source: SVGSVGElement, background: string): Promise<Blob | null> {
  const { width, height } = sizeOf(source);
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(svgText(source, background))}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = width * PNG_SCALE;
  canvas.height = height * PNG_SCALE;
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve));
}
