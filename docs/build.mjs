// Builds the notes into build/notes/html: every program is run, the essays are woven, Doxygen makes the pages.
import {existsSync, mkdirSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {binaries, build, chapters, data, fromRoot, html, isOriginal, otherPages, stopIfWrong} from './tools/book.mjs';
import {runDoxygen} from './tools/doxygen.mjs';
import {finish} from './tools/finish.mjs';
import {appendixFoot, appendixHead, chapterFoot, chapterHead, chapterList, chapterMap, exerciseList} from './tools/generated.mjs';
import {libraryTable} from './tools/library.mjs';
import {drawFigures} from './tools/drawn.mjs';
import {glossaryText} from './tools/glossary.mjs';
import {museumText} from './tools/museum.mjs';
import {bibliography, errataTable, paperTable} from './tools/tables.mjs';
import {canTouch} from './tools/touch.mjs';
import {runNamed, runPrograms} from './tools/values.mjs';
import {say} from './tools/words.mjs';
import {prose, shown, weave} from './tools/weave.mjs';

stopIfWrong('reading the list of chapters');
const pages = join(build, 'pages');
rmSync(pages, {recursive: true, force: true});
rmSync(html, {recursive: true, force: true});
mkdirSync(pages, {recursive: true});

const here = chapters.filter(({isHere}) => isHere);
runPrograms(here);
for (const [name, line] of Object.entries(isOriginal ? data('paper-map.json').runs : {}))
  if (existsSync(join(binaries, line.split(' ')[0]))) runNamed(name, line);

const missing = here.filter(({source}) => !existsSync(source));
if (!isOriginal) here.forEach(drawFigures);
for (const chapter of here) {
  const title = say('chapter', chapter.number, chapter.title);
  const rest = {id: chapter.id, chapter, title, head: chapterHead(chapter), foot: chapterFoot(chapter)};
  const text = missing.includes(chapter) ? `# ${title} {#${chapter.id.replaceAll('_', '-')}}\n\n${say('being written')}\n`
                                         : weave({...rest, source: chapter.source, original: chapter.original});
  writeFileSync(join(pages, chapter.id + '.md'), text);
}
const inEnglish = () => ({exercises: exerciseList(), bibliography: bibliography(), 'paper-map': paperTable(),
                          errata: errataTable(), library: libraryTable((words) => prose(words, 'library.md'))});
const generated = {map: chapterMap(), chapters: chapterList(), ...(isOriginal ? inEnglish() : {})};
for (const page of otherPages.filter(({isHere}) => isHere)) {
  const text = page.isMuseum ? museumText() : page.id === 'glossary' ? glossaryText() : undefined;
  const frame = page.letter ? {head: appendixHead(page), foot: appendixFoot(page)} : {};
  writeFileSync(join(pages, page.id + '.md'), weave({...page, ...frame, generated, text}));
}
stopIfWrong('weaving the pages');

runDoxygen();
finish();
writeFileSync(join(build, 'shown.json'), JSON.stringify({...shown, equations: [...shown.equations], cited: [...shown.cited],
                                                         missing: missing.map(({folder}) => folder)}, null, 1));
stopIfWrong('making the pages');
if (!canTouch) console.error('note: without figures to touch: clang++, or the C library for WebAssembly (wasi-libc), is missing');
for (const chapter of missing) console.error(`note: chapters/${chapter.folder} has no essay yet`);
console.log(`The notes are in ${fromRoot(join(html, 'index.html'))}: ${here.length - missing.length} chapters, ` +
            `${shown.figures.length} figures, ${shown.snippets.length} listings, ${shown.typed.length} numbers typed with a reason.`);
