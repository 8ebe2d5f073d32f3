type Rgb = readonly [number, number, number];

/** Paper and ink of the theme, 0 … 255. */
export function themeColours(element: Element): readonly [paper: Rgb, ink: Rgb] {
  const style = getComputedStyle(element);
  return [hex(style.getPropertyValue('--scene')), hex(style.getPropertyValue('--ink'))];
}

function hex(text: string): Rgb {
  const value = Number.parseInt(text.trim().slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}
