import { Marked, type Token, type Tokens } from 'marked';
import { InvalidInput } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import { type Condition, readConditions } from './condition.ts';
import { formulaParts } from './formula-text.ts';
import type { Block, Inline, Prose } from './prose.ts';
import { isQuantity } from './quantities.ts';

/** A heading with the tokens below it, up to the next heading of its level. */
export interface Section {
  readonly title: string;
  readonly tokens: readonly Token[];
}

/** Tokens split at headings of a level; a part before the first heading has no title. */
export function sectionsOf(tokens: readonly Token[], depth: number): Section[] {
  const sections: { title: string; tokens: Token[] }[] = [{ title: '', tokens: [] }];
  for (const token of tokens) {
    if (token.type === 'heading' && token.depth === depth) {
      sections.push({ title: token.text, tokens: [] });
    } else sections.at(-1)?.tokens.push(token);
  }
  return sections;
}

// An instance of its own, independent of options of the package's global one.
const marked = new Marked({ gfm: true });

export const tokensOf = (text: string): Token[] => marked.lexer(text);

export const sourceOf = (tokens: readonly Token[]): string =>
  tokens
    .map(({ raw }) => raw)
    .join('')
    .trim();

type Fault = (words: string) => void;

/**
 * Tokens as the parts that a lesson may have. HTML is taken as text and of a picture only its
 * words,
 * so that a file reaches the page only as text.
 */
export function proseOf(tokens: readonly Token[], fault: Fault): Prose {
  return tokens.flatMap((token) => blockOf(token, fault));
}

function blockOf(token: Token, fault: Fault): Block[] {
  if (token.type === 'space' || token.type === 'hr') return [];
  if (token.type === 'code') return [{ type: 'code', text: token.text, when: [] }];
  if (token.type === 'list') {
    const { items, ordered } = token as Tokens.List;
    const inside = items.map((item) => inlineOf(item.tokens, fault));
    return [{ type: 'list', ordered, items: inside, when: [] }];
  }
  if (token.type === 'blockquote') return [...proseOf((token as Tokens.Blockquote).tokens, fault)];
  const parts = 'tokens' in token && token.tokens ? token.tokens : [plainOf(token)];
  return [paragraphOf(inlineOf(parts, fault), fault)];
}

const plainOf = ({ raw }: Token): Token => ({ type: 'text', raw, text: raw.trim() });

function paragraphOf(all: readonly Inline[], fault: Fault): Block {
  const { when, inside } = conditionalOf(all, fault);
  const told = inside.filter(({ type }) => type !== 'claims');
  const [only] = told;
  if (told.length === 1 && only?.type === 'formula') {
    return { type: 'display', parts: only.parts, when };
  }
  if (told.length === 1 && only?.type === 'live' && only.quantity === 'slider') {
    return { type: 'slider', when };
  }
  return { type: 'paragraph', inside, when };
}

/** Reads "{when D > 0} Two roots …": words that are shown while the condition holds. */
function conditionalOf(
  all: readonly Inline[],
  fault: Fault,
): { when: readonly Condition[]; inside: readonly Inline[] } {
  const [first, ...rest] = all;
  if (first?.type !== 'text') return { when: [], inside: all };
  const [, words, after = ''] = first.text.match(/^\{when ([^}]*)\}\s*([\s\S]*)$/) ?? [];
  if (words === undefined) return { when: [], inside: all };
  const inside = after === '' ? rest : [...livesOf(after, fault), ...rest];
  try {
    return { when: readConditions(words), inside };
  } catch (error) {
    if (!(error instanceof InvalidInput)) throw error;
    fault(error.message);
    return { when: [], inside };
  }
}

function inlineOf(tokens: readonly Token[], fault: Fault): Inline[] {
  return tokens.flatMap((token): Inline[] => {
    switch (token.type) {
      case 'strong':
      case 'em':
        return [{ type: token.type, inside: inlineOf(token.tokens ?? [], fault) }];
      case 'codespan':
        return [{ type: 'formula', parts: formulaParts(token.text) }];
      case 'br':
        return [{ type: 'break' }];
      case 'link':
        return [linkOf(token as Tokens.Link, fault)];
      case 'html':
        return htmlOf(token.raw, fault);
      case 'text':
        return 'tokens' in token && token.tokens
          ? inlineOf(token.tokens, fault)
          : livesOf(token.text, fault);
      case 'paragraph':
        return inlineOf(token.tokens ?? [], fault);
      default:
        return livesOf('text' in token ? String(token.text) : token.raw, fault);
    }
  });
}

/** A link into Graze, or elsewhere by a safe scheme; any other becomes text. */
function linkOf({ href, tokens }: Tokens.Link, fault: Fault): Inline {
  const inside = inlineOf(tokens, fault);
  if (/^(#\/|https?:\/\/)/i.test(href)) return { type: 'link', href, inside };
  return { type: 'em', inside };
}

function htmlOf(raw: string, fault: Fault): Inline[] {
  const [, comment] = raw.trim().match(/^<!--([\s\S]*)-->$/) ?? [];
  if (comment === undefined) return livesOf(raw, fault);
  const claims = comment.split(';').map((one) => one.trim());
  return [{ type: 'claims', claims: claims.filter(Boolean) }];
}

/** Text with its live numbers, {t1}. Braces without a quantity are text. */
function livesOf(text: string, fault: Fault): Inline[] {
  if (/^\{when [^}]*\}/.test(text)) {
    const end = text.indexOf('}') + 1;
    return [{ type: 'text', text: text.slice(0, end) }, ...livesOf(text.slice(end), fault)];
  }
  return text.split(/(\{[^{}]*\})/).flatMap((part): Inline[] => {
    if (part === '') return [];
    const [, name] = part.match(/^\{([^{}]*)\}$/) ?? [];
    if (name === undefined) return [{ type: 'text', text: part }];
    const quantity = name.trim();
    if (isQuantity(quantity)) return [{ type: 'live', quantity }];
    fault(`${quote(`{${name}}`)} is no number of a page`);
    return [{ type: 'text', text: part }];
  });
}
