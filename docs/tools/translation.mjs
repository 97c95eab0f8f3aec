// A page in another language stands beside its English one, plane.zh-TW.md beside plane.md, block by block. A block with
// words stands under the mark of the English block that it was made from, <!-- 1a2b3c4d -->; a block without is the same.
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {complain, fromRoot, isOriginal, read, root} from './book.mjs';

const markOf = (block) => createHash('sha256').update(block).digest('hex').slice(0, 8);

/// The blocks of a page, each with the line on which it begins: what stands between empty lines, a fence as one.
export function blocksOf(text) {
  const blocks = [];
  let open, inFence = false;
  text.split('\n').forEach((line, i) => {
    if (!open && line.trim()) blocks.push(open = {line: i + 1, lines: []});
    if (/^```/.test(line)) inFence = !inFence;
    if (!line.trim() && !inFence) open = undefined;
    open?.lines.push(line);
  });
  return blocks.map(({line, lines}) => {
    const [, mark] = /^<!-- ([0-9a-f]{8}) -->$/.exec(lines[0]) ?? [];
    return {line, mark, text: (mark ? lines.slice(1) : lines).join('\n').trimEnd()};
  });
}

// What a block is, by its first letters; that of a picture, a listing or a heading is the same in each language.
const frames = [
  ['heading', /^#+ /], ['picture', /^!\[[^\]]*\](\(.*\)\n\{#.*?\})/], ['formula', /^(\$\$[^]*\$\$)$/], ['listing', /^(\\\w+ [^|]*)/],
  ['command', /^(```[^]*)$/], ['comment', /^(<!--[^]*)$/], ['answer', /^(<\/?details>[^]*)$/], ['made', /^(\{\{[\w-]+!\}\})$/],
  ['table', /^\| /], ['question', /^\*\*\d+\.\*\*/], ['list', /^(?:-|\d+\.) /],
];

function frameOf(text, language) {
  for (const [kind, pattern] of frames) {
    const found = pattern.exec(text);
    if (found) return {kind, frame: (kind === 'heading' ? found[0] : found[1] ?? '').replace(/\\text\{[^}]*\}/g, '\\text').replaceAll(` --lang ${language}`, '')};
  }
  return {kind: 'text', frame: ''};
}

const hasWords = ({kind}, text) => kind === 'formula' ? text.includes('\\text{') : kind === 'listing' ? text.includes(' | ')
                                                      : !['command', 'comment', 'answer', 'made'].includes(kind);

// What words stand around, and must be the same whatever their order: formulas, values, links, what is cited, code, numbers.
const pieces = [/\$\$[^]+?\$\$/g, /\$[^$]+\$/g, /\{\{[^{}]*\}\}/g, /\]\([^)\s]+\)/g, /\[@[\w-]+\]/g, /`[^`]+`/g, /§\s?\d(?:\.\d)*/g, /\d+(?:[.,]\d+)*/g];

function piecesOf(text) {
  const found = [];
  for (const pattern of pieces)
    text = text.replace(pattern, (piece) => (found.push(piece.replace(/\\text\{[^}]*\}/g, '\\text')), ' '));
  return found.sort();
}

function missing(from, of) {
  const left = [...of];
  return from.filter((piece) => {
    const at = left.indexOf(piece);
    if (at >= 0) left.splice(at, 1);
    return at < 0;
  });
}

// The English block of that mark, if git remembers it.
function remembered(mark, file) {
  const git = (...words) => execFileSync('git', words, {cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
  try {
    for (const commit of git('log', '-n', '100', '--format=%H', '--', file).split('\n').filter(Boolean)) {
      const block = blocksOf(git('show', `${commit}:${file}`)).find(({text}) => markOf(text) === mark);
      if (block) return block.text;
    }
  } catch { /* an archive has no history */ }
  return undefined;
}

function checkMark(block, english, where, file) {
  const mark = markOf(english.text);
  if (block.mark === mark) return;
  if (!block.mark) return complain(where, `a block with words must stand under the mark of its English one, <!-- ${mark} -->`);
  const before = remembered(block.mark, file);
  complain(where, `its English block is another by now. When this one says so too, mark it <!-- ${mark} -->.` +
                  (before ? `\n  was: ${before}` : '') + `\n  is:  ${english.text}`);
}

function checkBlock(block, english, where, file, language) {
  const own = frameOf(block.text, language), asked = frameOf(english.text, language);
  if (own.kind !== asked.kind || own.frame !== asked.frame)
    return complain(where, `must be the ${asked.kind} ${asked.frame || english.text.split('\n')[0]} (${file}:${english.line})`);
  if (!hasWords(asked, english.text)) return;
  checkMark(block, english, where, file);
  const [asks, has] = [piecesOf(english.text), piecesOf(block.text)];
  const lost = missing(asks, has), added = has.filter((piece) => !asks.includes(piece));  // one may be said again
  if (lost.length + added.length)
    complain(where, `must have what its English block has (${file}:${english.line}): ` +
                    [...lost.map((piece) => `${piece} is missing`), ...added.map((piece) => `${piece} is not there`)].join(', '));
}

/// Complains of each block that does not match its English one.
export function checkTranslation(translated, original, names) {
  const {source, file, language} = names;
  translated.slice(0, original.length).forEach((block, i) => checkBlock(block, original[i], `${source}:${block.line}`, file, language));
  if (translated.length !== original.length)
    complain(source, `has ${translated.length} blocks, its English page ${original.length} (${file})`);
}

/// The text of a page of this edition: without marks, its headings under the names that the English ones have.
export function asPage(source, original, nameOf) {
  if (isOriginal || source === original) return read(source);
  const english = blocksOf(read(original)), own = blocksOf(read(source)), language = /\.([\w-]+)\.md$/.exec(source)[1];
  checkTranslation(own, english, {source: fromRoot(source), file: fromRoot(original), language});
  return own.map(({text}, i) => {
    const heading = /^##+ (.*)$/.exec(english[i]?.text ?? '');
    return heading ? `${text} {#${nameOf(heading[1])}}` : text;
  }).join('\n\n') + '\n';
}
