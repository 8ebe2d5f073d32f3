/** Largest number of characters and lines of a program: a longer text blocks the editor. */
export const LONGEST_PROGRAM = 100_000;
const MOST_LINES = 10_000;

/** Why a text is too long to be a program; '' if it is not. */
export function tooLong(text: string): string {
  const may = (size: number, what: string, most: number): string =>
    size > most ? `it has ${size} ${what}, and a program may have up to ${most}` : '';
  return (
    may(text.length, 'characters', LONGEST_PROGRAM) ||
    may(text.split('\n').length, 'lines', MOST_LINES)
  );
}

/** CommonJS and classes: what a plain script does without. */
const MODULE = /\b(?:module|exports|require|class)\b/;

/**
 * A program as students write it, as the body of a function: what it exports, defines or assigns to
 * module.exports under the name `intersect` is found, as is a default export, the only function of
 * module.exports, and a class with a method `intersect`. Line numbers do not change.
 */
export function asScript(source: string): string {
  const script = withoutExports(source);
  if (!MODULE.test(source)) return script;
  const [, named = ''] = /\bclass\s+(\w+)[\s\S]*?\bintersect\s*\(/.exec(source) ?? [];
  const own = named ? `typeof ${named} === 'function' ? ${named} : undefined` : 'undefined';
  return (
    `var graze_module = { exports: {} }; var graze_found = (function (module, exports, require) ` +
    `{ {${script}\n; return [typeof intersect === 'undefined' ? undefined : intersect, ` +
    `graze_default, ${own}]; } })(graze_module, graze_module.exports, ${REQUIRE}); ` +
    `graze_default = (${PICK})(graze_found, graze_module.exports);`
  );
}

/** Nothing can be required in the sandbox, and that is said. */
const REQUIRE =
  "function (name) { throw new Error(String(name) + ' cannot be required: a program stands ' + " +
  "'alone here'); }";

/** The function to call: a value, a method of a value, or of a new object of a class. */
const PICK = `function (found, exported) {
  var all = [found[0], found[1], exported.intersect, exported.default, exported, found[2]];
  for (var i = 0; i < all.length; i++) {
    var one = all[i];
    if (one === undefined || one === null) continue;
    if (typeof one.intersect === 'function') return one.intersect.bind(one);
    if (typeof one !== 'function') continue;
    if (one.prototype && typeof one.prototype.intersect === 'function') {
      var made = new one();
      return made.intersect.bind(made);
    }
    if (String(one).indexOf('class') !== 0) return one;
  }
}`.replace(/\s+/g, ' ');

/**
 * The program without `export`, since it runs inside a function. The default export counts as
 * `intersect` if nothing has that name (the sandbox knows it as `graze_default`).
 */
const withoutExports = (source: string): string =>
  source
    .replace(
      /^([ \t]*)export[ \t]+default[ \t]+(?=(?:async[ \t]+)?function[ \t]+intersect\b)/gm,
      '$1',
    )
    .replace(/^([ \t]*)export[ \t]+default[ \t]+/gm, '$1graze_default = ')
    .replace(/^([ \t]*)export[ \t]+(?=async\b|function\b|const\b|let\b|var\b|class\b)/gm, '$1')
    .replace(/^[ \t]*export[ \t]*\{[^}\n]*\}[ \t]*;?/gm, '');

/** Whether a text looks like TypeScript, whose types have to be taken away before it runs. */
export const looksTyped = (source: string): boolean => TYPESCRIPT.test(source);

const TYPES = 'number|string|boolean|void|any|unknown|Vec3|Vector3|Ray|Shape|Hit|readonly';
const TYPESCRIPT = new RegExp(
  [
    `[\\w)\\]}?]\\s*:\\s*(?:${TYPES})\\b`,
    '\\)\\s*:\\s*[A-Z]\\w*(?:<[^>]*>)?(?:\\[\\])*\\s*(?:\\{|=>)',
    '\\bprivate\\s+|\\bpublic\\s+|!\\.|!\\[|\\bsatisfies\\b',
    '^\\s*(?:export\\s+)?(?:interface|type|enum|declare)\\s+\\w',
    '^\\s*import\\s+type\\b',
    '\\bas\\s+(?:const|number|string|any|unknown)\\b',
  ].join('|'),
  'm',
);
const IMPORT = /^\s*import\b(?!\s*\()/m;

/** Advice for a program that cannot start, if its text shows the cause; '' otherwise. */
export function adviceFor(source: string, message: string): string {
  const syntax = message.startsWith('syntax error');
  if (syntax && IMPORT.test(source)) {
    return 'A program stands alone here: write what it imports into it.';
  }
  return '';
}
