// Every chapter has its essay, in the one order: the question, a figure, mathematics, code, output, what goes wrong, as
// printed and corrected, cost, exercises with folded answers, further reading; links what a student is to write; and asks a
// question at the end of each section that teaches.
import {existsSync} from 'node:fs';
import {chapters, complain, exercises, fromRoot, read, shownByBuild} from '../tools/book.mjs';
import {faultsOfMuseum} from '../tools/museum.mjs';

const order = ['What it prints', 'What goes wrong', 'As printed, and as corrected', 'What it costs', 'Exercises',
               'Further reading'];

const parts = [
  ['a figure', /^!\[/m], ['a displayed formula', /^\$\$/m], ['code', /^\\snippet /m], ['its output', /^\\output /m],
  ['a looked-up number', /\{\{\w+[.@]/], ['a reference', /\[@/],
];

function checkEssay(chapter) {
  const name = fromRoot(chapter.source), text = read(chapter.source);
  let at = 0;
  for (const heading of order) {
    const found = text.indexOf(`\n## ${heading}\n`);
    if (found < 0) complain(name, `there is no section "${heading}"`);
    else if (found < at) complain(name, `the section "${heading}" comes too early`);
    else at = found;
  }
  for (const [part, pattern] of parts)
    if (!pattern.test(text)) complain(name, `there is no ${part}`);
  const count = (pattern) => text.match(pattern)?.length ?? 0;
  const exercises = count(/^\*\*\d+\.\*\*/gm), asked = count(/^\*\*Ask yourself\.\*\*/gm), answers = count(/^<details>$/gm);
  if (exercises < 3) complain(name, `${exercises} exercises: there should be three at the least`);
  if (asked < 3) complain(name, `${asked} questions on the way: there should be three at the least`);
  if (exercises + asked !== answers) complain(name, `${exercises + asked} questions, but ${answers} folded answers`);
  if (!/^\*\*To search for:\*\* /m.test(text)) complain(name, 'does not say what to search for');
}

const asksNothing = new Set(['What it prints', 'As printed, and as corrected', 'Exercises', 'The whole program',
                             'Further reading', 'Your own ball']);

// Each section that teaches ends with a question of understanding.
function checkQuestions(chapter) {
  const [, ...sections] = read(chapter.source).replace(/<!--[^]*?-->/g, '').split(/^## /m);
  for (const section of sections) {
    const name = section.split('\n')[0];
    if (!asksNothing.has(name) && !/^\*\*Ask yourself\.\*\*(?:(?!<\/details>)[^])*<\/details>\s*$/m.test(section))
      complain(fromRoot(chapter.source), `the section "${name}" does not end with a question`);
  }
}

// Each exercise of the workbook is linked where its idea is fresh, in its own chapter.
function checkExercises(chapter) {
  const text = read(chapter.source), own = exercises.filter(({name}) => parseInt(name) === chapter.number);
  if (own.length < 3) complain(fromRoot(chapter.source), `${own.length} exercises to write: there should be three at the least`);
  for (const {name} of own)
    if (!text.includes(`](exercises/${name}/task.md)`)) complain(fromRoot(chapter.source), `exercise ${name} is not linked`);
}

export function checkEssays() {
  const museum = faultsOfMuseum();
  for (const fault of museum.faults) complain('docs/museum.json', fault);
  for (const chapter of chapters) {
    if (existsSync(chapter.source)) checkEssay(chapter), checkExercises(chapter), checkQuestions(chapter);
    else complain(fromRoot(chapter.source), 'is missing');
  }
  const typed = shownByBuild().typed;
  for (const {where, number, reason} of typed) console.log(`  ${where}: ${number} typed: ${reason}`);
  return `${chapters.length} chapters, ${museum.count} exhibits each with a test, ${typed.length} numbers typed by hand with a reason`;
}
