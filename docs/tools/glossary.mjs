// The terms of the glossary, and where a text uses them.
import {appendices, chapters, docs, read} from './book.mjs';

// "bounding volume hierarchy, BVH" is found by either name; what stands in brackets is for the reader alone.
const namesOf = (english) => english.replace(/ \([^)]*\)/g, '').split(/, | \/ /).map((name) => name.trim());
const escaped = (name) => name.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
const plural = (name) => name.includes(' of ') ? escaped(name).replace(' of ', 's? of ') : /ex$/.test(name) ? escaped(name).replace(/ex$/, '(ex|ices)')
                                          : escaped(name).replace(/x$/, 'x(es)?').replace(/y$/, '(y|ies)') + '(s|es)?';
const patternOf = (english) => new RegExp(`(?<![\\w-])(${namesOf(english).map(plural).join('|')})(?![\\w-])`,
                                          /[a-z]/.test(english) ? 'i' : '');

const source = read(docs, 'pages/glossary.md'), row = /^\| (?!English)([^|]+?) \| ([^|]+?) \| [^|]+ \| \|$/gm;

/// {english, chinese, pattern that finds it}
export const terms = [...source.matchAll(row)].map(([, english, chinese]) => ({english, chinese, pattern: patternOf(english)}));

// The text of a page as one line of words.
const words = (page) => read(page.source).replace(/<!--[^]*?-->/g, '').replace(/^\\.*$/gm, '').replace(/\s+/g, ' ').replace(/[*_]/g, '');
const pages = [...chapters, ...appendices].map((page) => ({name: page.number ?? page.letter, text: words(page)}));

/// The chapter, or the appendix, in which a term appears first; undefined if it is in none.
export const firstOf = ({pattern}) => pages.find(({text}) => pattern.test(text))?.name;

/// The page of the glossary, with the chapters in its last column.
export const glossaryText = () => source.replace(row, (line, english) =>
  line.replace(/ \|$/, ` ${firstOf({pattern: patternOf(english)}) ?? ''} |`));
