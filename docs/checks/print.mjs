// The printed book, by what is in its PDF: TrueType faces alone, formulas that can be read, pages that are filled, each part
// on the page it should begin on, bookmarks, and who wrote it.
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {PDFDocument} from 'pdf-lib';
import {build, complain, read, root} from '../tools/book.mjs';
import {plottedIn} from '../tools/figure.mjs';
import {treeOf} from '../tools/tree.mjs';
import {bookmarksOf, titleOf} from '../print/finish.mjs';
import {version} from '../print/front.mjs';
import {parts} from '../print/parts.mjs';

const pdf = join(build, 'first-contact.pdf'), where = 'the print edition';
const leastFill = 1 / 3;                        // of a page's height, but for a part's last page
const text = {top: 22 / 297, bottom: 271 / 297};  // of a page: the foot is below
const asText = {encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore']};
const run = (program, ...options) => execFileSync(program, options, asText);

function checkFonts() {
  const fonts = run('pdffonts', pdf).split('\n').slice(2).filter(Boolean);
  for (const line of fonts)
    if (!/ (CID )?TrueType +\S+ +yes /.test(line)) complain(where, `no embedded TrueType face: ${line.trim().replace(/ +/g, ' ')}`);
  return fonts.length;
}

const letters = (words) => words.replace(/\s+/g, '');

// What a formula says is in the text of the PDF, once for each time that it is drawn.
function checkFormulas(tree, words) {
  const all = letters(words), said = tree('.said').toArray().map((element) => letters(tree(element).text()))
      .map((line) => line.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&'));
  for (const line of new Set(said))
    if (!all.includes(line)) complain(where, `the text has no formula ${line}`);
  return said.length;
}

// How far down each page is written on, from 0 to 1.
function fillOf(pages) {
  return pages.map((page) => {
    const [, height] = /height="([\d.]+)"/.exec(page), ends = [...page.matchAll(/yMax="([\d.]+)"/g)].map(([, y]) => y / height);
    const lowest = Math.max(text.top, ...ends.filter((y) => y < text.bottom));
    return (lowest - text.top) / (text.bottom - text.top);
  });
}

function checkFill(places) {
  const pages = run('pdftotext', '-bbox', pdf, '-').split('<page ').slice(1), fill = fillOf(pages);
  const starts = new Set(parts.filter(({under}) => !under).map(({id}) => places.get(id)));
  const first = Math.min(...starts);
  fill.forEach((part, i) => {
    const number = i + 1, isEmpty = part === 0 && /<word /.test(pages[i]);
    const isLast = starts.has(number + 1) || starts.has(number + 2) || number === fill.length;
    if (number >= first && (isEmpty || !isLast && part < leastFill)) complain(where, `page ${number} is filled to ${Math.round(100 * part)} % alone`);
  });
  return fill.reduce((sum, part) => sum + part, 0) / fill.length;
}

// Every point that the figures' own files plot.
function checkPoints(tree) {
  const {figures} = JSON.parse(read(build, 'shown.json')), known = new Set(parts.map(({id}) => id));
  const paths = figures.filter(({page}) => known.has(page)).map(({path}) => path);
  const plotted = paths.reduce((sum, path) => sum + plottedIn(read(root, path)), 0);
  const printed = tree('.drawn > svg use').filter((_, use) => !tree(use).closest('defs').length).length;
  if (plotted !== printed) complain(where, `${printed} plotted points, but the figures' files have ${plotted}`);
  return printed;
}

// What a sentence announces stands on its page, as far as a page can hold both.
function checkTorn(tree, places) {
  for (const element of tree('[data-led]').toArray()) {
    const {id} = element.attribs, from = places.get(element.attribs['data-led']), to = places.get(id);
    if (from !== to) complain(where, `page ${from}: what is announced stands on page ${to}: ${tree(`[id="${element.attribs['data-led']}"]`).parent().text().trim().slice(-60)}`);
  }
}

function checkIndex(tree) {
  tree('#terms li').filter((_, term) => !tree(term).find('a').length)
      .each((_, term) => complain(where, `the index has no page for "${tree(term).text().trim()}"`));
}

function checkOpenings(places) {
  for (const {id, title, onRight} of parts) {
    if (!places.has(id)) complain(where, `"${title}" is not in it`);
    if (onRight && places.get(id) % 2 === 0) complain(where, `"${title}" opens on page ${places.get(id)}, on the left`);
  }
}

const plain = (markup) => markup.replace(/<[^>]*>/g, '').replaceAll('&amp;', '&').trim();

async function checkDocument(tree) {
  const document = await PDFDocument.load(readFileSync(pdf), {updateMetadata: false});
  const titles = [...bookmarksOf(document)].map(titleOf);
  const have = new Set(titles.map(letters));
  for (const heading of tree('article h1.title, article h2').toArray().map((element) => plain(tree(element).text())))
    if (!have.has(letters(heading))) complain(where, `the bookmarks lack "${heading}"`);
  if (!document.getTitle() || !document.getAuthor()) complain(where, 'has no title, or no author');
  if (!document.getSubject().includes(version)) complain(where, 'tells no version');
  if (/chrome/i.test(document.getCreator())) complain(where, 'is said to be made by the browser');
  return {titles: titles.length, pages: document.getPageCount()};
}

export async function checkPrint() {
  const list = join(build, 'places.json');
  if (!existsSync(pdf) || !existsSync(list)) return complain(where, 'is not made yet: ./course notes --pdf') ?? 'not checked';
  const book = join(build, 'book.html'), places = new Map(Object.entries(JSON.parse(read(list))));
  const tree = treeOf(read(book)), fonts = checkFonts(), fill = checkFill(places);
  const formulas = checkFormulas(tree, run('pdftotext', '-raw', pdf, '-'));
  const points = checkPoints(tree);
  checkTorn(tree, places);
  checkOpenings(places);
  checkIndex(tree);
  const {titles, pages} = await checkDocument(tree);
  return `${pages} pages, filled to ${Math.round(100 * fill)} % on average; ${fonts} subsets of TrueType faces, ${formulas} formulas that can be read, ${points} plotted points, ${titles} bookmarks`;
}
