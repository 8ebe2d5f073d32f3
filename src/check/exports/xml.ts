/** Text within XML; what XML 1.0 cannot hold is left out. */
export const xmlText = (text: string): string =>
  text
    // biome-ignore lint/suspicious/noControlCharactersInRegex: XML 1.0 has no such characters.
    .replace(/[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]|\p{Surrogate}/gu, '')
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;');

/** Text as HTML within XML: escaped for both, a paragraph for each line. */
export const htmlInXml = (text: string): string =>
  xmlText(
    text
      .split('\n')
      .map((line) => `<p>${xmlText(line)}</p>`)
      .join(''),
  );
