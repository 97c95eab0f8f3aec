// The museum: published mistakes, each with what went wrong, where, its code in our words, its picture, what a player saw,
// what kills it, and the chapter that explains it. Those of the workbook's catalogue say of themselves what they are.
import {join} from 'node:path';
import {chapters, data, exercises, filesBelow, fromRoot, read, root} from './book.mjs';
import {say} from './words.mjs';

/// The lines "// Key: words" at the head of a known wrong answer.
function headOf(file) {
  const head = {};
  let key = '';
  for (const line of read(file).split('\n')) {
    if (!line.startsWith('//')) break;
    const found = /^\/\/ ([A-Z][a-z ]{1,10}): (.*)$/.exec(line);
    if (found) head[key = found[1]] = found[2];
    else if (key) head[key] += ' ' + line.replace(/^\/\/ ?/, '');
  }
  return head;
}

/// All wrong answers that somebody has shipped, by "1a/name".
export const shipped = () => new Map(exercises.flatMap(({name, source}) =>
  filesBelow(join(source, '..', 'wrong')).map((file) => [`${name}/${file.split('/').at(-1).replace('.hpp', '')}`, {file, head: headOf(file)}])
      .filter(([, {head}]) => head['Seen in'])));

/// Where a test of this name stands, or nothing.
const tests = filesBelow(join(root, 'tests'), (file) => file.endsWith('.cpp')).map((file) => read(file).replace(/"\s*\n\s*"/g, ''));
export const hasTest = (name) => tests.some((text) => text.includes(`"${name}"`));

// What the essay says that is seen.
function pictureOf(picture) {
  if (!picture) return '';
  const path = `../../figures/${picture}.svg`;
  for (const {source, number, title} of chapters) {
    const text = read(source), at = text.indexOf(`](${path})`);
    if (at >= 0) return `![${text.slice(text.lastIndexOf('![', at) + 2, at)}](${path})\n{#${picture.replaceAll('/', '-').replaceAll('_', '-')}} ${say('picture from', number, title)}\n\n`;
  }
  throw new Error(`museum.json: ${picture} stands in no essay`);
}

// The catalogue's words: sections of the paper lead to it, and its numbers are said to be no run's.
const verbatim = (words) => words.replace(/the paper, (\d(?:\.\d)+)/g, 'the paper, §$1').replaceAll('^', '\\^')
    .replace(/(?<![\w.§#/])\d+\.\d+(?![\w.])/g, '{{typed $& | in the words of the catalogue}}');

function exhibit(entry, known) {
  const chapter = chapters.find(({program}) => program === entry.chapter);
  const own = entry.code ? undefined : known.get(entry.wrong);
  if (!entry.code && !own) throw new Error(`museum.json: ${entry.wrong} is no wrong answer that says where it was seen`);
  const exercise = own && exercises.find(({name}) => name === entry.wrong.split('/')[0]);
  const told = own ? own.head['Looks like'] : entry.wrong, what = told[0].toUpperCase() + told.slice(1);
  const where = own ? own.head['Seen in'] : entry.sources.join('; ');
  const code = own ? fromRoot(own.file).replace('chapters/', '') : entry.code.join(' ').trim();
  const killed = own ? say('killed by exercise', `[${exercise.title}](../../${fromRoot(exercise.source)})`)
                     : say('killed by test', verbatim(entry.killed));
  return `## ${entry.title}\n\n**${say('went wrong')}** ${verbatim(what)}\n\n**${say('seen in')}** ${verbatim(where)}.\n\n**${say('player saw')}** ${verbatim(entry.saw)}\n\n` +
         pictureOf(entry.picture) + `\\folded ${code} | ${say('code in our words')}\n` +
         (entry.with ?? []).map((key) => `\\folded ${fromRoot(known.get(key).file).replace('chapters/', '')} | ${say('same elsewhere')}\n`).join('') +
         `\n**${say('killed by')}** ${killed}\n\n` +
         `**${say('explained in')}** [${chapter.title}](../../${fromRoot(chapter.source)})\n\n`;
}

/// The page, as its author would have written it.
export function museumText() {
  const known = shipped();
  return read(root, 'docs/pages/museum.md') + '\n' + data('museum.json').map((entry) => exhibit(entry, known)).join('');
}

/// What of the museum is not as it should be.
export function faultsOfMuseum() {
  const entries = data('museum.json'), faults = [];
  for (const entry of entries)
    if (entry.code && !hasTest(entry.killed)) faults.push(`${entry.title}: there is no test "${entry.killed}"`);
  for (const key of shipped().keys())
    if (!entries.some(({wrong, code, with: also}) => !code && (wrong === key || also?.includes(key)))) faults.push(`${key} was seen somewhere, and is not shown`);
  return {count: entries.length, faults};
}
