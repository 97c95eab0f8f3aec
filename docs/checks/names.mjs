// Nothing is used before it is told: a name of the project that an open listing uses stands in the text or in a listing
// before it, in this chapter or in one that it needs, or in the primer.
import {join} from 'node:path';
import {chapters, complain, docs, filesBelow, fromRoot, libraryRoot, read, root} from '../tools/book.mjs';
import {codeOf} from '../tools/cost.mjs';

const word = /\b[A-Za-z_]\w*\b/g;
const isCode = (file) => /\.(cpp|hpp)$/.test(file) && !/\/(exercises|workbook)\//.test(file);
const withoutWords = (code) => code.replace(/\/\/.*$/gm, '').replace(/"(?:[^"\\]|\\.)*"/g, '""');
const declared = [/\b(?:class|struct|concept)\s+([A-Za-z_]\w*)/g,
                  /^[\w:<>,&* ]+?[ &*>]([a-z_]\w*)\(/gm,
                  /^(?:inline )?constexpr [\w:<>]+ (\w+)/gm];
const ofLanguage = new Set(('if for while return switch operator sizeof main size begin end min max data first last add move ' +
                            'abs sqrt empty back front all_of any_of vector').split(' '));

// The types, functions and constants that the sources of the project declare.
function ownNames() {
  const files = [...filesBelow(libraryRoot, isCode), ...filesBelow(join(root, 'chapters'), isCode)];
  const found = files.map((file) => withoutWords(read(file)))
      .flatMap((code) => declared.flatMap((pattern) => [...code.matchAll(pattern)].map(([, name]) => name)));
  return new Set(found.filter((name) => name.length > 1 && !name.endsWith('_') && !ofLanguage.has(name)));
}

// What a listing makes itself: functions and types that it defines, variables, and parts that it binds.
function madeIn(code) {
  const made = [/(?:\bauto&?|[\w>\]&*])\s+([A-Za-z_]\w*)\s*[=({;,):]/g, /::([A-Za-z_]\w*)\(/g, /\b(?:class|struct|using)\s+(\w+)/g];
  const bound = [...code.matchAll(/\[([\w, ]+)\]/g)].flatMap(([, names]) => names.split(/,\s*/));
  return new Set([...made.flatMap((pattern) => [...code.matchAll(pattern)].map(([, name]) => name)), ...bound]);
}

const needed = ({needs}) => needs.flatMap((n) => [n, ...needed(chapters[n - 1])]);

export function checkNames() {
  const names = ownNames(), toldBy = new Map(), primer = read(docs, 'pages/primer.md').match(word);
  let listings = 0;
  for (const chapter of chapters) {
    const told = new Set([...primer, ...needed(chapter).flatMap((n) => [...toldBy.get(n) ?? []])]), text = read(chapter.source);
    let at = 0;
    for (const {0: line, 1: file, 2: tag, index} of text.matchAll(/^\\(?:snippet|folded) (\S+) (\w+)(?: \| .*)?$/gm)) {
      for (const [, code] of text.slice(at, index).matchAll(/`([^`]+)`/g)) code.match(word)?.forEach((name) => told.add(name));
      const code = withoutWords(codeOf(file, tag)), used = new Set(code.match(word)), made = madeIn(code);
      const untold = [...used].filter((name) => names.has(name) && !told.has(name) && !made.has(name));
      if (untold.length && line.startsWith('\\snippet')) complain(`${fromRoot(chapter.source)}, ${tag}`, `nobody has told of ${untold.join(', ')}`);
      used.forEach((name) => told.add(name));
      at = index + line.length;
      listings += line.startsWith('\\snippet');
    }
    toldBy.set(chapter.number, told);
  }
  return `${listings} open listings use names that are told before`;
}
