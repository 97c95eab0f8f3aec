// The pages "file by file": every file of a folder of the library stands on the page of that folder, after the files
// that it includes, with the chapters that tell of it.
import {existsSync, readdirSync, statSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {appendices, chapters, complain, escape, filesBelow, fromRoot, libraryRoot, otherPages, read, root} from './book.mjs';
import {say} from './words.mjs';

const isCode = (name) => /\.(cpp|hpp|inc)$/.test(name);
const order = ['.hpp', '.inc', '.cpp'];
const kind = (name) => order.findIndex((ending) => name.endsWith(ending));

/// The code of a folder, without that of the folders in it.
export const codeIn = (folder) => readdirSync(join(libraryRoot, folder)).sort()
    .filter((name) => isCode(name) && statSync(join(libraryRoot, folder, name)).isFile());

/// Of each part of the library, the header first, the source last. \throws an Error if there is none.
export function filesOf(stem) {
  const folder = dirname(stem), name = basename(stem);
  const files = existsSync(join(libraryRoot, folder)) ? codeIn(folder).filter((file) => file.replace(/\.\w+$/, '') === name) : [];
  if (!files.length) throw new Error(`there is no file common/first_contact/${stem}.*`);
  return files.sort((a, b) => kind(a) - kind(b)).map((file) => join(folder, file));
}

const included = (text) => [...text.matchAll(/^#include "first_contact\/([^"]+)"/gm)].map(([, file]) => file);

/// The code that a page has to show.
const codeOf = (page) => page.folders.flatMap((folder) => codeIn(folder).map((name) => join(folder, name)));

/// Complains about files of the page's folders that are not on it, and about a header that comes before one it includes.
export function checkPage(page, shownFiles) {
  for (const file of codeOf(page))
    if (!shownFiles.includes(file))
      complain(`common/first_contact/${file}`, `stands on no page: say in ${fromRoot(page.source)} what idea it holds, ` +
               `and show it there with \\files ${file.replace(/\.\w+$/, '')}`);
  shownFiles.forEach((file, i) => {
    if (!file.endsWith('.hpp')) return;
    for (const other of included(read(libraryRoot, file)))
      if (shownFiles.indexOf(other) > i) complain(fromRoot(page.source), `${file} includes ${other}, which comes after it`);
  });
}

// Which chapters' programs reach a header, by themselves or through other headers and their sources.
const reach = new Map();
function reachedFrom(files) {
  const reached = new Set(), open = [...files];
  while (open.length) {
    const path = open.pop();
    for (const name of included(read(path))) {
      if (reached.has(name) || !existsSync(join(libraryRoot, name))) continue;
      reached.add(name);
      open.push(join(libraryRoot, name));
      const source = join(libraryRoot, name.replace(/\.hpp$/, '.cpp'));
      if (name.endsWith('.hpp') && existsSync(source)) open.push(source);
    }
  }
  return reached;
}
for (const chapter of chapters)
  reach.set(chapter, reachedFrom(filesBelow(join(root, 'chapters', chapter.folder), (file) => /\.(cpp|hpp)$/.test(file))));

const link = (page) => `<a href="${page.page}">${page.number ? `${page.number} · ` : ''}${escape(page.title)}</a>`;
const links = (list) => list.length === chapters.length ? say('all chapters')
  : list.length > 1 && list.length === chapters.length - 1
  ? say('all chapters but', link(chapters.find((chapter) => !list.includes(chapter))))
  : say(list.length > 1 ? 'in chapters' : 'in one chapter', list.map(link).join(', '));

/// "told in chapter 1 · The plane; used in chapters 2 · The box, 3 · Partitioning": found in the pages and in the sources.
export function whereTold(files, snippets) {
  const names = files.map((file) => `common/first_contact/${file}`);
  const tells = ({id}) => snippets.some(({file, page}) => page === id && names.includes(file));
  const told = chapters.filter(tells), appended = appendices.filter(tells);
  const used = chapters.filter((chapter) => !told.includes(chapter) && files.some((file) => reach.get(chapter).has(file)));
  const rest = told.length && told.length + used.length === chapters.length ? say('all others') : links(used);
  const parts = [told.length && say('told in', links(told)), appended.length && say('told in', appended.map(link).join(', ')),
                 used.length && say('used in', rest)].filter(Boolean);
  return parts.length ? `<p class="told">${parts.join('; ')}</p>` : '';
}

const firstParagraph = (page) => read(page.source).split('\n\n')[1].replaceAll('\n', ' ');

/// The table of the folders on the library's own page. \param says  makes the first sentences of a page HTML
export function libraryTable(says) {
  const rows = otherPages.filter(({folders}) => folders).map((page) => {
    const files = codeOf(page);
    const lines = files.reduce((sum, name) => sum + read(libraryRoot, name).trimEnd().split('\n').length, 0);
    return `<div><dt><a href="${page.page}">${escape(page.short)}</a></dt><dd>${says(firstParagraph(page))} <small>${say('files and lines', files.length, lines.toLocaleString('en'))}` +
           `</small></dd></div>`;
  });
  return `<dl class="folders">${rows.join('')}</dl>`;
}
