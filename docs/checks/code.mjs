// Every line of the programs, and of the library's tagged teaching code, stands on some page. What need not is between
//   // notes: aside, because ...          and          // notes: end
import {join} from 'node:path';
import {build, complain, filesBelow, fromRoot, read, root} from '../tools/book.mjs';

const mostAside = 0.05;  // of all lines
const teaching = ['geometry', 'sweep', 'partition', 'response', 'motion'].map((folder) => join(root, 'common/first_contact', folder));
const isCode = (file) => /\.(cpp|hpp)$/.test(file);
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

export function checkCode() {
  const shown = JSON.parse(read(build, 'shown.json')).snippets;
  const isShown = (file, line) => shown.some((each) => each.file === file && (!each.tag || line.tags.includes(each.tag)));
  let lines = 0, aside = 0, untagged = 0, library = 0;
  for (const file of filesBelow(join(root, 'chapters'), isCode)) {
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
  for (const file of teaching.flatMap((folder) => filesBelow(folder, isCode))) {
    const name = fromRoot(file), missing = new Set();
    for (const line of linesOf(file)) {
      if (!line.counts) continue;
      if (file.endsWith('.cpp')) ++library;
      if (line.tags.length) ++lines;
      else if (file.endsWith('.cpp')) ++untagged;
      if (!line.tags.length || isShown(name, line)) continue;
      if (line.aside) ++aside;
      else line.tags.forEach((tag) => missing.add(tag));
    }
    for (const tag of missing) complain(name, `on no page: the code of the tag ${tag}`);
  }
  for (const file of [...filesBelow(join(root, 'chapters'), isCode), ...teaching.flatMap((folder) => filesBelow(folder, isCode))])
    for (const reason of new Set(linesOf(file).map((line) => line.aside).filter(Boolean)))
      console.log(`  ${fromRoot(file)}: set aside, because ${reason}`);
  if (aside > mostAside * lines) complain('code', `${aside} of ${lines} lines are set aside: more than ${100 * mostAside} %`);
  return `${lines} lines, ${aside} set aside; ${untagged} of the library's ${library} lines are outside any tag`;
}
