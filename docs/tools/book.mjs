// What all tools share: where things are, the chapters, and the list of complaints.
import {existsSync, readFileSync, readdirSync, statSync} from 'node:fs';
import {basename, dirname, join, relative, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const docs = join(root, 'docs');
export const read = (...parts) => readFileSync(join(...parts), 'utf8');
export const data = (name) => JSON.parse(read(docs, name));

/// The language of the edition: node docs/build.mjs --lang zh-TW
const strings = data('strings.json'), atLanguage = process.argv.indexOf('--lang');
export const language = atLanguage < 0 ? 'en' : process.argv[atLanguage + 1] ?? '';
if (!strings[language]) {
  console.error(`notes: --lang ${language}: must be one of ${Object.keys(strings).join(', ')}`);
  process.exit(2);
}
export const isOriginal = language === 'en';

const original = join(root, 'build/notes');
export const build = isOriginal ? original : join(original, language);
export const html = join(build, 'html');
export const binaries = join(root, 'build/dev/bin');

export const fromRoot = (file) => relative(root, file);

/// All files below a folder that pass, sorted, so that every build sees them in one order.
export function filesBelow(folder, passes = () => true) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder).sort().flatMap((name) => {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) return filesBelow(path, passes);
    return passes(path) ? [path] : [];
  });
}

// A page as this edition has it: `original` is its English source, `source` the one that is read. One that is not
// translated is there in English alone: `page` leads to that.
function edition(page) {
  const {titles, short} = strings[language];
  const own = {...page, original: page.source, title: titles[page.id] ?? page.title, short: short[page.id] ?? page.short};
  if (isOriginal) return {...own, isHere: true};
  const source = page.source.replace(/\.md$/, `.${language}.md`), isHere = existsSync(source);
  return {...own, isHere, source: isHere ? source : page.source, page: isHere ? page.page : pageInEnglish(page.page)};
}

/// Where an English page is, as seen from this edition.
export const pageInEnglish = (page) => isOriginal ? page : '../../html/' + page;

export const chapters = data('chapters.json').map((chapter) => edition({
  ...chapter,
  ...(isOriginal ? {} : {title: chapter.chinese, chinese: chapter.title, question: chapter.chineseQuestion}),
  id: chapter.program,
  source: join(root, 'chapters', chapter.folder, chapter.program + '.md'),
  page: chapter.program.replaceAll('_', '-') + '.html',
}));

/// What a student writes: a page each, which stands beside the stub.
export const exercises = filesBelow(join(root, 'chapters'), (file) => file.endsWith('/task.md')).map((source) => {
  const name = basename(dirname(source)), title = read(source).split('\n')[0].replace(/^# /, '');
  return {id: `exercise-${name}`, name, title, source, short: title.replace(/^Exercise /, ''), isWorkbook: true, isExercise: true};
});

/// The library; of the pages below, each with folders shows all files of those folders.
export const libraryRoot = join(root, 'common/first_contact');

/// The file that a listing names: of the library, of a chapter, or of the figures to touch.
export const codeFile = (file) => ['common', 'chapters', 'docs'].map((folder) => join(root, folder, file)).find(existsSync);

/// The pages that are no chapters, in the order of the contents.
export const otherPages = [
  {id: 'index', title: 'First Contact', front: true},
  {id: 'reading', title: 'How to read this', front: true},
  {id: 'primer', title: 'A primer', front: true},
  {id: 'fast-tree', letter: 'A', title: 'Appendix A · How the fast tree works', short: 'How the fast tree works', needs: [3, 4]},
  {id: 'crowds', letter: 'B', title: 'Appendix B · A hundred thousand balls', short: 'A hundred thousand balls', needs: [3, 6]},
  {id: 'jaw', letter: 'C', title: 'Appendix C · A jaw opens', short: 'A jaw opens', needs: [4]},
  {id: 'engines', letter: 'D', title: 'Appendix D · How the engines do it', short: 'How the engines do it', needs: [4]},
  {id: 'touching', letter: 'E', title: 'Appendix E · How a figure to touch works', short: 'How a figure to touch works',
   needs: [1]},
  {id: 'library', title: 'The library, file by file', isLibrary: true},
  {id: 'library-geometry', title: 'Geometry, file by file', short: 'geometry', isLibrary: true, folders: ['geometry']},
  {id: 'library-mesh-io', title: 'Meshes in files, file by file', short: 'mesh_io', isLibrary: true,
   folders: ['files', 'mesh_io']},
  {id: 'library-sweep', title: 'Sweeps, file by file', short: 'sweep', isLibrary: true, folders: ['sweep']},
  {id: 'library-trees', title: 'Trees, file by file', short: 'trees', isLibrary: true, folders: ['trees']},
  {id: 'library-bvh', title: 'The fast tree, file by file', short: 'bvh', isLibrary: true,
   folders: ['bvh/build', 'bvh/kernels', 'bvh/cast', 'bvh']},
  {id: 'library-batch', title: 'Batches, file by file', short: 'batch', isLibrary: true, folders: ['batch']},
  {id: 'library-pairs', title: 'Pairs, file by file', short: 'pairs', isLibrary: true, folders: ['pairs']},
  {id: 'library-response', title: 'Response, file by file', short: 'response', isLibrary: true, folders: ['response']},
  {id: 'library-motion', title: 'Motion, file by file', short: 'motion', isLibrary: true, folders: ['motion']},
  {id: 'library-stage', title: 'The stage, file by file', short: 'stage', isLibrary: true, folders: ['stage']},
  {id: 'workbook', title: 'The workbook', isWorkbook: true},
  ...exercises,
  {id: 'museum', title: 'The museum of published mistakes', isMuseum: true},
  {id: 'instructor', title: 'For the instructor'},
  {id: 'papermap', title: 'Paper map'},
  {id: 'errata', title: 'Errata of the paper'},
  {id: 'glossary', title: 'Glossary 詞彙'},
  {id: 'symbols', title: 'Symbols'},
  {id: 'bibliography', title: 'Bibliography'},
].map((page) => edition({source: join(docs, 'pages', page.id + '.md'), page: page.id + '.html', ...page}));

/// What may be left out: pages like chapters, without exercises.
export const appendices = otherPages.filter(({letter}) => letter);

export const escape = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

export const complaints = [];
/// Notes one fault; the build goes on to find the others, and fails at its end.
export function complain(where, what) {
  complaints.push(`${where}: ${what}`);
}

/// The figure of that path from the root, as this edition has it: in another language it is drawn anew.
export const figureFile = (path) => join(isOriginal ? root : build, path);

/// Prints what was found wrong and ends the program if there was anything.
export function stopIfWrong(doing) {
  if (!complaints.length) return;
  for (const line of complaints) console.error(line);
  console.error(`${doing}: ${complaints.length} fault${complaints.length > 1 ? 's' : ''}`);
  process.exit(1);
}

/// What the last build of the book has shown: the checks need it.
export function shownByBuild() {
  const file = join(build, 'shown.json');
  if (!existsSync(file)) {
    complain('build/notes', 'the book is not built yet: ./course notes');
    stopIfWrong('checking the notes');
  }
  return JSON.parse(read(file));
}

for (const chapter of chapters)
  for (const field of ['number', 'folder', 'program', 'title', 'chinese', 'needs', 'paper', 'question', 'chineseQuestion'])
    if (chapter[field] === undefined) complain('docs/chapters.json', `the chapter "${chapter.title}" has no "${field}"`);
