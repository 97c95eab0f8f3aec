// The Markdown of the essays: CommonMark and tables by markdown-it, and what the course adds to them. Here it is only
// read; what each part becomes on its page is said in weave.mjs.
import MarkdownIt from 'markdown-it';

/// Quotes and apostrophes as printers set them; no rule that an essay has no use for and could break by mistake.
export const markdown = new MarkdownIt({html: true, typographer: true, quotes: ['“', '”', '‘', '’']})
    .disable(['code', 'lheading', 'reference', 'replacements', 'autolink']);

// A rule for a part of a line: what its pattern finds is a token of its own.
function inline(type, pattern) {
  markdown.inline.ruler.before('escape', type, (state, silent) => {
    pattern.lastIndex = state.pos;
    const found = pattern.exec(state.src);
    if (!found) return false;
    if (!silent) state.push(type, '', 0).content = found[1];
    state.pos = pattern.lastIndex;
    return true;
  });
}

inline('formula', /\$([^$]+?)\$/y);       // $\vec E \cdot \vec Q$
inline('value', /\{\{([^{}]*)\}\}/y);     // {{plane.contact.time}}
inline('cited', /\[@([\w-]+)\]/y);        // [@hu]
inline('section', /§\s?(\d(?:\.\d)*)/y);  // §1.2

// Plain text ends where a rule may begin: markdown-it's own list of such signs lacks §.
const plain = /[^\n!#$%&*+\-:<=>@[\\\]^_`{}~§]+/y;
markdown.inline.ruler.at('text', (state, silent) => {
  plain.lastIndex = state.pos;
  const [text] = plain.exec(state.src) ?? [];
  if (!text) return false;
  if (!silent) state.pending += text;
  state.pos = plain.lastIndex;
  return true;
});

// Every part of a text knows its line, for complaints; what stands in a table has the line of its row.
markdown.core.ruler.after('inline', 'lines', ({tokens, env}) => {
  let line = env.line;
  for (const {map, children} of tokens) {
    if (map) line = env.line + map[0];
    for (const part of children ?? []) {
      part.meta = {line};
      line += part.type.endsWith('break') ? 1 : part.content.split('\n').length - 1;
    }
  }
});

// A rule for whole lines: the pattern is tried on all that follows the beginning of a line.
function block(type, pattern, keep) {
  const rule = (state, begin, end, silent) => {
    if (state.sCount[begin] - state.blkIndent >= 4) return false;
    pattern.lastIndex = state.bMarks[begin] + state.tShift[begin];
    const found = pattern.exec(state.src);
    if (!found) return false;
    if (silent) return true;
    const after = begin + found[0].replace(/\n$/, '').split('\n').length;
    keep(state, found, [begin, after], state.env.line + begin);
    state.line = after;
    return true;
  };
  markdown.block.ruler.before('fence', type, rule, {alt: ['paragraph', 'blockquote', 'list']});
}

const alone = (type, meta) => (state, found, map, line) =>
  Object.assign(state.push(type, '', 0), {map, block: true, meta: {line, ...meta(found)}});

// Something with words in it that are Markdown themselves.
function around(type, tag, words, state, map, meta) {
  Object.assign(state.push(`${type}_open`, tag, 1), {map, meta});
  Object.assign(state.push('inline', '', 0), {content: words, children: []});
  state.push(`${type}_close`, tag, -1);
}

block('run', /<!-- run ([\w-]+): (.+?) -->$/my, alone('run', ([, name, options]) => ({name, options})));
block('touch', /<!-- touch ([\w-]+) -->$/my, alone('touch', ([, name]) => ({name})));
block('comment', /<!--[^]*?-->$/my, () => {});
block('equation', /\$\$\s*([^]+?)\$\$$/my, alone('equation', ([, tex]) => ({tex})));
block('command', /\\(snippet|folded|files|output) (.+)$/my, alone('command', ([, name, rest]) => ({name, rest})));
block('made', /\{\{([\w-]+)!\}\}$/my, alone('made', ([, name]) => ({name})));
block('answer', /<(\/?)details>$/my, alone('answer', ([, ends]) => ({ends})));
block('summary', /<summary>(.*)<\/summary>$/my, (state, [, words], map) => around('summary', 'summary', words, state, map));

// ![what is seen](picture.svg), and below it {#name} and the caption.
block('figure', /!\[([^\]]*)\]\(([^)\s]+\.svg)\)\n(?:\{#([\w-]+)\}[ ]*)?((?:.+\n?)*)/y, (state, found, map, line) => {
  const [, alternative, target, name = target.replace(/^.*\/|\.svg$/g, ''), caption] = found;
  state.env.page.figures.push(name);
  around('figure', 'figure', caption.trim().replace(/\s*\n\s*/g, ' '), state, map, {alternative, target, name, line});
});
