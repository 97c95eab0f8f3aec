// The print edition: all chapters in one PDF with its figures as vectors, printed by Chromium from the finished pages.
// It is printed again until each page number that stands in it is right: a print tells on which page each place is.
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {executable} from './checks/browsing.mjs';
import {checkPrint} from './checks/print.mjs';
import {build, complain, docs, escape, fromRoot, html, language, read, stopIfWrong} from './tools/book.mjs';
import {unresolvedIn} from './tools/references.mjs';
import {treeOf} from './tools/tree.mjs';
import {say} from './tools/words.mjs';
import {bodyOf} from './print/body.mjs';
import {finishPdf} from './print/finish.mjs';
import {colophon, contents, titlePage} from './print/front.mjs';
import {blanksFor, pagesOf} from './print/pages.mjs';
import {answers, index, parts} from './print/parts.mjs';
import {clearMarks, indexText} from './print/terms.mjs';

const mostPrints = 6, smallestCode = 8;  // points
const book = join(build, 'book.html'), pdf = join(build, 'first-contact.pdf');
const faces = ['stix-two-text/400', 'stix-two-text/400-italic', 'stix-two-text/600', 'stix-two-text/600-italic',
               'ubuntu-mono/400', 'ubuntu-mono/700', 'ubuntu-mono/400-italic'];

// Each part has pages of its own name, with its title at their outer foot; what goes on in another has that one's.
function pageRules() {
  return parts.map(({id, under, number, title}) => {
    const foot = `content: ${JSON.stringify((number ? `${number} · ` : '') + title)};`;
    const rules = `@page ${id}:left { @bottom-right { ${foot} } } @page ${id}:right { @bottom-left { ${foot} } } `;
    return (under ? '' : rules) + `#${id} { page: ${under ?? id}; }`;
  }).join('\n');
}

// The answers, chapter by chapter, and the index are made of what was found in the chapters.
function madeParts(bodies, pages) {
  const given = parts.filter(({id}) => bodies.get(id)?.answers).map(({id, number, title}) =>
    `<section><h2>${say('chapter', number, escape(title))}</h2>${bodies.get(id).answers}</section>`);
  const made = ({title}, text) => ({title: `<h1 class="title">${title}</h1>`, text, glyphs: '', sections: []});
  bodies.set(answers.id, made(answers, given.join('')));
  bodies.set(index.id, made(index, indexText(pages)));
}

function article({id, under, isLibrary}, {title, text, glyphs}, blanks) {
  const inColumns = isLibrary && under ? `<div class="columns">${text}</div>` : text;
  return (blanks.has(id) ? '<div class="blank">&nbsp;</div>' : '') +
         `<article id="${id}"${under ? ' class="goes-on"' : ''}><div class="contents"><div class="textblock">${glyphs}${title}${inColumns}</div></div></article>`;
}

function assemble(pages, blanks) {
  clearMarks();
  const bodies = new Map(parts.filter(({page}) => page).map((part) => [part.id, bodyOf(part, pages)]));
  madeParts(bodies, pages);
  const face = (name) => `<link rel="stylesheet" href="${pathToFileURL(join(docs, 'node_modules/@fontsource', name + '.css')).href}">`;
  const style = (name) => `<style>${read(html, name)}</style>`;
  return `<!DOCTYPE html><html lang="${language}" class="light-mode"><head><meta charset="utf-8"><title>First Contact</title>` + faces.map(face).join('') +
    ['tabs.css', 'doxygen.css', 'doxygen-awesome.css', 'book.css', 'made.css', 'print.css'].map(style).join('') +
    `<style>@media print { ${pageRules()} }</style></head><body class="book"><main>${titlePage()}${colophon()}${contents(bodies, pages)}` +
    parts.map((part) => article(part, bodies.get(part.id), blanks)).join('') + '</main></body></html>';
}

// A drawing or a link that refers to what is not there is printed as nothing, and nobody is told.
function checkReferences(text) {
  for (const name of unresolvedIn(treeOf(text))) complain('the print edition', `refers to what is not in it: #${name}`);
  stopIfWrong('assembling the print edition');
}

// In the page: what a formula says becomes as wide as its drawing; how small is the smallest line of code?
function fitFormulas() {
  for (const said of document.querySelectorAll('.said')) {
    const drawn = said.parentElement.querySelector('svg').getBoundingClientRect().width, own = said.scrollWidth;
    if (own) said.style.transform = `scaleX(${drawn / own})`;
  }
  const lines = [...document.querySelectorAll('.fragment .line, pre .line, pre code')];
  return 0.75 * Math.min(...lines.map((line) => parseFloat(getComputedStyle(line).fontSize)));
}

async function print(browser, pages, blanks) {
  const text = assemble(pages, blanks);
  checkReferences(text);
  writeFileSync(book, text);
  const page = await browser.newPage();
  await page.goto(pathToFileURL(book).href);
  await page.emulateMedia({media: 'print'});
  await page.evaluate(() => document.fonts.ready);
  const code = await page.evaluate(fitFormulas);
  if (code < smallestCode) complain('the print edition', `code of ${code.toFixed(1)} points: must be ${smallestCode} at the least`);
  await page.pdf({path: pdf, printBackground: true, outline: true, tagged: true, preferCSSPageSize: true});
  await page.close();
  return pagesOf(pdf);
}

const same = (a, b) => a.size === b.size && [...a].every(([name, page]) => b.get(name) === page);

const flags = ['--no-sandbox', '--disable-gpu', '--export-tagged-pdf'];
const browser = await chromium.launch({executablePath: executable(), args: flags});
let told = {count: 0, places: new Map()}, blanks = new Set(), isRight = false;
for (let prints = 0; !isRight && prints < mostPrints; ++prints) {
  blanks = blanksFor(told, blanks);
  const printed = await print(browser, told.places, blanks);
  // A place that no link leads to is not told; the index names a page once, and so drops one link or the other.
  const places = new Map([...told.places, ...printed.places]);
  isRight = same(places, told.places);
  told = {count: printed.count, places};
}
await browser.close();
if (!isRight) complain('the print edition', `after ${mostPrints} prints its page numbers still move`);
await finishPdf(pdf);
writeFileSync(join(build, 'places.json'), JSON.stringify(Object.fromEntries(told.places), null, 1));
const said = await checkPrint();
stopIfWrong('checking the print edition');
console.log(`The print edition is ${fromRoot(pdf)}: ${said}`);
