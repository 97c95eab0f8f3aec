// What is made from data: the head and foot of a chapter, the contents, the map of chapters.
import {appendices, chapters, escape, isOriginal, language, otherPages, pageInEnglish} from './book.mjs';
import {minutesOf} from './minutes.mjs';
import {say} from './words.mjs';

const otherLanguage = isOriginal ? 'zh-Hant' : 'en';

const numbered = (number) => chapters.find((chapter) => chapter.number === number);
const linkTo = (chapter) => `<a href="${chapter.page}">${chapter.number} · ${escape(chapter.title)}</a>`;

const needsOf = ({needs}) => needs.length ? needs.map((n) => linkTo(numbered(n))).join(', ') : say('nothing');
const table = (facts) => `<dl>${facts.map(([name, fact]) => `<div><dt>${name}</dt><dd>${fact}</dd></div>`).join('')}</dl>`;

/// The same head for each chapter: minutes, what it builds on, the paper's section, how to run it.
export function chapterHead(chapter) {
  const paper = chapter.paper.map((section) => `<a href="${pageInEnglish('papermap.html')}#s${section}">§${section}</a>`).join(', ');
  const facts = [[say('reading time'), say('minutes', minutesOf(chapter))], [say('builds on'), needsOf(chapter)],
                 [say('in the paper'), paper],
                 [say('program'), `<code>./course run ${chapter.program}${isOriginal ? '' : ` --lang ${language}`}</code>`]];
  return `<div class="chapter-head"><p class="chinese" lang="${otherLanguage}">${chapter.chinese}</p>${table(facts)}</div>`;
}

/// The head of an appendix.
export const appendixHead = (page) =>
  `<div class="chapter-head">${table([[say('reading time'), say('minutes', minutesOf(page))], [say('builds on'), needsOf(page)]])}</div>`;

// Previous and next.
function turn(previous, next) {
  const label = (page) => (page.number ? `${page.number} · ` : '') + escape(page.title);
  return `<nav class="turn" aria-label="${say('turn')}"><a rel="prev" href="${previous.page}"><small>${say('previous')}</small>${label(previous)}</a>` +
         `<a rel="next" href="${next.page}"><small>${say('next')}</small>${label(next)}</a></nav>`;
}

const errata = otherPages.find(({id}) => id === 'errata'), reading = otherPages.find(({id}) => id === 'reading');

export const chapterFoot = ({number}) => turn(numbered(number - 1) ?? reading, numbered(number + 1) ?? appendices[0]);

export function appendixFoot(page) {
  const at = appendices.indexOf(appendices.find(({id}) => id === page.id));
  return turn(appendices[at - 1] ?? chapters.at(-1), appendices[at + 1] ?? errata);
}

/// The contents beside every page; the sections of the page that is open stand under its name.
export function contents(current, sections) {
  const entry = (page, label) => {
    const open = page.page === current;
    const inner = open && sections.length
      ? `<ul>${sections.map(({id, title}) => `<li><a href="#${id}">${title}</a></li>`).join('')}</ul>` : '';
    const inPart = page.id === 'library' && otherPages.some((part) => part.folders && part.page === current);
    if (page.id === 'library' && (open || inPart))
      return `<li><a href="${page.page}"${open ? ' aria-current="page"' : ''}>${label}</a>` +
             list(otherPages.filter((part) => part.folders), (part) => escape(part.short)) + '</li>';
    if (page.id === 'workbook' && otherPages.some((other) => other.isWorkbook && other.page === current))
      return `<li><a href="${page.page}"${open ? ' aria-current="page"' : ''}>${label}</a>` +
             list(otherPages.filter((other) => other.isExercise), (other) => escape(other.short)) + '</li>';
    return `<li><a href="${page.page}"${open ? ' aria-current="page"' : ''}>${label}</a>${inner}</li>`;
  };
  const list = (pages, label) => `<ul>${pages.map((page) => entry(page, label(page))).join('')}</ul>`;
  const title = (page) => escape(page.title);
  const isReference = ({front, letter, isLibrary, isWorkbook}) => !front && !letter && !isLibrary && !isWorkbook;
  const lettered = ({letter, short}) => `<span class="number">${letter}</span> ${escape(short)}`;
  return list(otherPages.filter((page) => page.front), title) +
         `<h2>${say('chapters')}</h2>` + list(chapters, (chapter) => `<span class="number">${chapter.number}</span> ${title(chapter)}`) +
         `<h2>${say('appendices')}</h2>` + list(appendices, lettered) +
         `<h2>${say('your turn')}</h2>` + list([otherPages.find(({id}) => id === 'workbook')], title) +
         `<h2>${say('the library')}</h2>` + list([otherPages.find(({id}) => id === 'library'),
                                       {page: pageInEnglish('namespacefirst__contact.html'), title: say('all names')}],
                                      (page) => page.id ? say('file by file') : title(page)) +
         `<h2>${say('reference')}</h2>` + list(otherPages.filter(isReference), title);
}

// --- the map of chapters ------------------------------------------------------------------------------------------

// Does one chapter need another, by itself or by what it needs?
const reaches = (one, other) => numbered(one).needs.some((n) => n === other || reaches(n, other));

const depth = (chapter) => 1 + Math.max(-1, ...chapter.needs.map((n) => depth(numbered(n))));

// Rows by depth; within a row, chapters stand in the order of what they build on, so that few lines cross.
function rowsOf() {
  const rows = [];
  for (const chapter of chapters) (rows[depth(chapter)] ??= []).push(chapter);
  return rows;
}

// As near to where they want to be as they can without touching: pushed apart to the right, and all moved back by what
// that took on average.
function apart(wanted, least, most) {
  const xs = [];
  for (const x of wanted) xs.push(Math.max(x, (xs.at(-1) ?? -Infinity) + least));
  const back = xs.reduce((sum, x, i) => sum + x - wanted[i], 0) / xs.length;
  return xs.map((x, i) => Math.min(Math.max(x - back, i * least), most - (xs.length - 1 - i) * least));
}

function placed(width, card, gap) {
  const places = new Map();
  rowsOf().forEach((row, level) => {
    const wanted = row.map((chapter) => chapter.needs.length && level > 1
      ? chapter.needs.reduce((sum, n) => sum + places.get(n).x, 0) / chapter.needs.length : undefined);
    const step = (width - card.width) / Math.max(1, row.length - 1);
    const even = (i) => row.length === 1 ? (width - card.width) / 2 : i * step;
    const xs = apart(row.map((_, i) => wanted[i] ?? even(i)), card.width + card.apart, width - card.width);
    row.forEach((chapter, i) => places.set(chapter.number, {chapter, x: xs[i], y: level * (card.height + gap)}));
  });
  return places;
}

function linesOf(text, most) {
  const lines = [''];
  for (const word of text.split(' ')) {
    const longer = (lines.at(-1) + ' ' + word).trim();
    if (longer.length > most && lines.at(-1)) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines;
}

function drawMap(name, width, card, gap) {
  const places = placed(width, card, gap);
  const height = Math.max(...[...places.values()].map(({y}) => y)) + card.height;
  const edges = [], cards = [];
  for (const {chapter, x, y} of places.values()) {
    const middle = x + card.width / 2;
    for (const n of chapter.needs.filter((n) => !chapter.needs.some((other) => other !== n && reaches(other, n)))) {
      const from = places.get(n), start = from.x + card.width / 2, top = from.y + card.height;
      edges.push(`<path d="M${start},${top} C${start},${top + gap * 0.6} ${middle},${y - gap * 0.6} ${middle},${y}"/>`);
    }
    const lines = linesOf(chapter.title, card.letters);
    const first = y + card.number + card.line * 1.35;
    cards.push(`<a href="${chapter.page}"><rect x="${x}" y="${y}" width="${card.width}" height="${card.height}" rx="7"/>` +
      `<text class="number" x="${middle}" y="${y + card.number}" font-size="${card.number * 0.8}">${chapter.number}</text>` +
      lines.map((line, i) => `<text x="${middle}" y="${first + i * card.line * 1.2}" font-size="${card.line}">${escape(line)}</text>`).join('') +
      (card.chinese ? `<text class="chinese" lang="${otherLanguage}" x="${middle}" y="${y + card.height - 12}" font-size="13">${chapter.chinese}</text>` : '') +
      '</a>');
  }
  return `<svg class="map ${name}" viewBox="-1 -1 ${width + 2} ${height + 2}" role="group" aria-label="${say('map')}">` +
         `<g class="edges" aria-hidden="true">${edges.join('')}</g>${cards.join('')}</svg>`;
}

/// The map, once for wide pages and once for narrow ones.
export const chapterMap = () => '<div class="chapter-map">' +
  drawMap('wide', 760, {width: 172, apart: 24, height: 92, number: 28, line: 17, letters: 18, chinese: true}, 54) +
  drawMap('narrow', 360, {width: 84, apart: 10, height: 78, number: 24, line: 12, letters: 12}, 34) + '</div>';

/// Every chapter in a line: number, title, question, minutes.
export const chapterList = () => '<ol class="chapters">' + chapters.map((chapter) =>
  `<li><a href="${chapter.page}"><span class="number">${chapter.number}</span><span class="title">${escape(chapter.title)}` +
  ` <span class="chinese" lang="${otherLanguage}">${chapter.chinese}</span></span></a>` +
  `<p>${escape(chapter.question)} <small>${say('minutes', minutesOf(chapter))} · ${say('paper')} ${chapter.paper.map((s) => '§' + s).join(', ')}</small></p></li>`).join('') + '</ol>';

/// The exercises, chapter by chapter.
export const exerciseList = () => '<dl class="exercises">' + chapters.map((chapter) => {
  const own = otherPages.filter(({isExercise, name}) => isExercise && parseInt(name) === chapter.number);
  return `<dt>${linkTo(chapter)}</dt>` + own.map(({page, short}) => `<dd><a href="${page}">${escape(short)}</a></dd>`).join('');
}).join('') + '</dl>';
