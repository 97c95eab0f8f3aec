// Every line of the programs and of the mathematical library stands on some page, and what the library teaches (its
// tagged code) in some chapter. What need not is between
//   // notes: aside, because ...          and          // notes: end
import {join} from 'node:path';
import {complain, filesBelow, fromRoot, read, root, shownByBuild} from '../tools/book.mjs';

const mostAside = 0.05;  // of all lines
const teaching = ['geometry', 'mesh_io', 'sweep', 'trees', 'bvh', 'batch', 'pairs', 'response', 'motion', 'stage']
    .map((folder) => join(root, 'common/first_contact', folder));
// What would give an answer away is read by the judge alone, and tested: tests/CMakeLists.txt, "workbook".
const givesAway = /\/exercises\/\w+\/(probes\.hpp|wrong\/)/;
const isCode = (file) => /\.(cpp|hpp|inc)$/.test(file);
const tagOf = (line) => /^\s*\/\/! \[(\w+)\]$/.exec(line)?.[1];

// The lines of a file with what is known of each: its tags, and whether it is set aside.
function linesOf(file) {
  const open = new Set();
  let aside = '';
  const lines = read(file).split('\n').map((text, i) => {
    const tag = tagOf(text);
    if (tag) open.has(tag) ? open.delete(tag) : open.add(tag);
    const begins = /^\s*\/\/ notes: aside, because (.+)$/.exec(text)?.[1];
    const ends = /^\s*\/\/ notes: end$/.test(text);
    if (begins) aside = begins;
    const line = {number: i + 1, tags: [...open], aside, counts: !tag && !begins && !ends && text.trim() !== ''};
    if (ends) aside = '';
    return line;
  });
  if (open.size) complain(fromRoot(file), `the tag ${[...open]} is not closed`);
  if (aside) complain(fromRoot(file), 'what was set aside does not end');
  return lines;
}

function spans(numbers) {
  const parts = [];
  for (const n of numbers) {
    if (parts.length && parts.at(-1)[1] === n - 1) parts.at(-1)[1] = n;
    else parts.push([n, n]);
  }
  return parts.map(([a, b]) => a === b ? a : `${a}-${b}`).join(', ');
}

// Counts the lines of some files, and complains about those that are on no page and not set aside.
function count(files, isShown) {
  let lines = 0, aside = 0;
  for (const file of files) {
    const name = fromRoot(file), missing = [];
    for (const line of linesOf(file)) {
      if (!line.counts) continue;
      ++lines;
      if (isShown(name, line)) continue;
      if (line.aside) ++aside;
      else missing.push(line.number);
    }
    if (missing.length) complain(name, `on no page: lines ${spans(missing)}`);
  }
  return {lines, aside};
}

export function checkCode() {
  const shown = shownByBuild().snippets;
  const isShown = (file, line) => shown.some((each) => each.file === file && (!each.tag || line.tags.includes(each.tag)));
  const ofChapters = filesBelow(join(root, 'chapters'), (file) => isCode(file) && !givesAway.test(file));
  const ofLibrary = teaching.flatMap((folder) => filesBelow(folder, isCode));
  const chapters = count(ofChapters, isShown), library = count(ofLibrary, isShown);
  for (const file of ofLibrary)  // what is taught stands in an essay as well, not only on the pages file by file
    for (const tag of new Set(linesOf(file).flatMap(({tags}) => tags)))
      if (!shown.some((each) => each.file === fromRoot(file) && !each.page.startsWith('library') &&
                               (!each.tag || each.tag === tag)))
        complain(fromRoot(file), `in no chapter: the code of the tag ${tag}`);
  for (const file of [...ofChapters, ...ofLibrary])
    for (const reason of new Set(linesOf(file).map((line) => line.aside).filter(Boolean)))
      console.log(`  ${fromRoot(file)}: set aside, because ${reason}`);
  const lines = chapters.lines + library.lines, aside = chapters.aside + library.aside;
  if (aside > mostAside * lines) complain('code', `${aside} of ${lines} lines are set aside: more than ${100 * mostAside} %`);
  return `all ${lines} lines, ${chapters.lines} of the programs and ${library.lines} of the library, stand on a page; ` +
         `${aside} set aside (${(100 * aside / lines).toFixed(1)} %)`;
}
