// Which single tokens of a C++ file can be changed, and into what. The house's format puts spaces around every binary
// operator, so that a product is told from a pointer and a comparison from a template's brackets.

const swaps = [
  [/ <= /g, ' < '], [/ < /g, ' <= '], [/ >= /g, ' > '], [/ > /g, ' >= '], [/ == /g, ' != '], [/ != /g, ' == '],
  [/ \+ /g, ' - '], [/ - /g, ' + '], [/ \* /g, ' / '], [/ \/ /g, ' * '], [/ && /g, ' || '], [/ \|\| /g, ' && '],
  [/ \+= /g, ' -= '], [/ -= /g, ' += '], [/ \*= /g, ' /= '], [/ & /g, ' | '], [/ << /g, ' >> '], [/ >> /g, ' << '],
  [/\+\+(?=\w)/g, '--'], [/\bmin\(/g, 'max('], [/\bmax\(/g, 'min('], [/\btrue\b/g, 'false'], [/\bfalse\b/g, 'true'],
  [/\bstd::abs\(/g, '('], [/\bstd::sqrt\(/g, '('], [/(?<=[(\s])!(?=[\w(])/g, ''], [/(?<=[(,=?:] ?|return )-(?=[\w(])/g, ''],
  [/\bcontinue;/g, ''], [/\bbreak;/g, ''],
];
const numbers = /(?<![\w.'])(\d+(?:\.\d+)?)(?![\w.'])/g;

const changedNumber = (text) => text === '0' ? '1' : text === '1' ? '2' : text === '0.5' ? '1' : String(Number(text) + 1);

// The code of a file, with everything that is no code (comments, texts, directives, checks at compile time) as blanks.
function codeAlone(text) {
  const blank = (part) => part.replace(/[^\n]/g, ' ');
  return text.replace(/\/\/[^\n]*|\/\*[^]*?\*\/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)'/g, blank)
      .replace(/^#.*$/gm, blank)
      .replace(/\bstatic_assert\([^]*?\);/g, blank)
      .replace(/^\s*(?:template|requires|concept|using|namespace)\b.*$/gm, blank)
      .replace(/std::array<[^>]*>/g, blank);
}

/// All mutants of a text: where a token is, what stands there, and what shall.
export function mutantsOf(text) {
  const code = codeAlone(text), found = [];
  for (const [form, instead] of swaps)
    for (const match of code.matchAll(form)) found.push({at: match.index, from: match[0], to: instead});
  for (const match of code.matchAll(numbers)) found.push({at: match.index, from: match[0], to: changedNumber(match[0])});
  return found.sort((a, b) => a.at - b.at).map((mutant) => ({...mutant, ...lineOf(text, mutant.at)}));
}

// A mutant is known by its line's words and the place in them: so it keeps its name when lines above it come and go.
function lineOf(text, at) {
  const begin = text.lastIndexOf('\n', at) + 1, end = text.indexOf('\n', at);
  const line = text.slice(begin, end < 0 ? undefined : end);
  const indent = line.length - line.trimStart().length;
  return {number: text.slice(0, at).split('\n').length, line: line.trim(), column: at - begin - indent};
}

export const changed = (text, mutant) => text.slice(0, mutant.at) + mutant.to + text.slice(mutant.at + mutant.from.length);

/// A line with the change marked: "a [< -> <=] b".
export const marked = ({line, column, from, to}) =>
  `${line.slice(0, column)}[${from.trim()} -> ${to.trim() || 'nothing'}]${line.slice(column + from.length)}`;
