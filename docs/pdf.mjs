// The print edition: all chapters in one PDF with its figures as vectors, printed by Chromium from the finished pages.
// It is printed twice: the first time tells on which page each part begins, the second has that in its contents.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {executable} from './checks/browser.mjs';
import {build, chapters, complain, escape, html, otherPages, read, stopIfWrong} from './tools/book.mjs';
import {chapterMap} from './tools/generated.mjs';
import {unresolvedIn} from './tools/references.mjs';
import {treeOf} from './tools/tree.mjs';

const goesOn = (part) => part.isLibrary && part.folder;
const parts = [otherPages.find(({id}) => id === 'reading'), ...chapters, ...otherPages.filter(({front}) => !front)];

// Files that are folded on their page would be half of the book: here their names lead to them.
function nameWholeFiles(tree) {
  tree('details.whole').each((_, element) => {
    const file = tree(element), id = file.attr('id');
    file.replaceWith(`<p class="elsewhere"${id ? ` id="${id}"` : ''}>${file.children('summary').html()}</p>`);
  });
}

// Where a link leads in the book, as #PLACE; nowhere if that page is not in it.
function placeInBook(target, own) {
  if (target.startsWith('#')) return '#' + own(target.slice(1));
  const [, page, name] = /^([\w-]+\.html)(?:#(.+))?$/.exec(target) ?? [];
  const part = parts.find((each) => each.page === page);
  if (!page) return target;
  return part && `#${name ? `${part.id}--${name}` : part.id}`;
}

// The page's anchors made its own, so that pages can stand in one file.
function renameAnchors(tree, id) {
  const own = (name) => `${id}--${name}`;
  tree('*').each((_, {attribs}) => {
    for (const [name, value] of Object.entries(attribs)) {
      const renamed = name === 'id' ? own(value) : /^(xlink:)?href$/.test(name) ? placeInBook(value, own)
                    : value.replace(/url\(#([^)]+)\)/g, (_, target) => `url(#${own(target)})`);
      if (renamed === undefined) delete attribs[name];
      else attribs[name] = renamed;
    }
  });
}

// The body of a finished page.
function bodyOf({id, page, ...part}) {
  const tree = treeOf(read(html, page));
  nameWholeFiles(tree);
  renameAnchors(tree, id);
  tree('nav.turn').remove();
  tree('details').attr('open', '');
  const text = tree('.textblock').html();
  return tree.html('svg.glyphs') + tree.html('h1.title') + (goesOn(part) ? `<div class="columns">${text}</div>` : text);
}

const running = ({number, title}) => (number ? `${number} · ` : '') + title;

// Each part has pages of its own name, with its title at their foot; the folders of the library go on where it ends.
const pageRules = () => parts.map((part) => (goesOn(part) ? '' :
  `@page ${part.id} { @bottom-left { content: ${JSON.stringify(running(part))}; } } `) +
  `#${part.id} { page: ${goesOn(part) ? 'library' : part.id}; }`).join('\n');

function entry(part, pages) {
  const about = part.question ? `<small>${escape(part.question)}</small>` : '';
  return `<li><a href="#${part.id}"><span class="number">${part.number ?? ''}</span><span class="name">${escape(part.title)}${about}</span>` +
         `<span class="page">${pages.get(part.id) ?? ''}</span></a></li>`;
}

function assemble(pages) {
  const style = (name) => `<style>${read(html, name)}</style>`;
  const article = (part) => `<article id="${part.id}"${goesOn(part) ? ' class="goes-on"' : ''}><div class="contents"><div class="textblock">${bodyOf(part)}</div></div></article>`;
  return `<!DOCTYPE html><html lang="en" class="light-mode"><head><meta charset="utf-8"><title>First Contact</title>` +
    ['tabs.css', 'doxygen.css', 'doxygen-awesome.css', 'book.css', 'made.css', 'print.css'].map(style).join('') +
    `<style>@media print { ${pageRules()} }</style></head><body class="book"><main>` +
    `<section class="title-page"><h1>First Contact</h1><p class="what">Collision detection and tweened animation,<br>chapter by chapter</p>` +
    `<p class="chinese" lang="zh-Hant">碰撞偵測與補間動畫</p>${chapterMap()}<p class="after">After Shing-Min Hu, 胡興民, 〈以補間動畫實作碰撞偵測〉</p></section>` +
    `<section class="toc"><h1>Contents</h1><ul>${parts.filter((part) => !goesOn(part)).map((part) => entry(part, pages)).join('')}</ul></section>` +
    parts.map(article).join('') + '</main></body></html>';
}

/// On which page of a PDF each of its named places is. Chromium writes both lists in plain text.
function pagesOf(file) {
  const objects = new Map([...readFileSync(file, 'latin1').matchAll(/^(\d+) 0 obj\n(<<[^]*?)\nendobj/gm)].map(([, id, body]) => [id, body]));
  const references = (text) => [...text.matchAll(/(\d+) 0 R/g)].map(([, id]) => id);
  const leaves = (id) => {
    const kids = /\/Kids \[([^\]]*)\]/.exec(objects.get(id))?.[1];
    return kids ? references(kids).flatMap(leaves) : [id];
  };
  const catalog = [...objects.values()].find((body) => body.includes('/Type /Catalog'));
  const [, tree] = /\/Pages (\d+) 0 R/.exec(catalog), [, names] = /\/Dests (\d+) 0 R/.exec(catalog);
  const order = leaves(tree);
  return new Map([...objects.get(names).matchAll(/\/(\S+) \[(\d+) 0 R/g)].map(([, name, id]) => [name, order.indexOf(id) + 1]));
}

const book = join(build, 'book.html'), pdf = join(build, 'first-contact.pdf');
const flags = ['--no-sandbox', '--disable-gpu', '--export-tagged-pdf'];
const browser = await chromium.launch({executablePath: executable(), args: flags});

// A drawing or a link that refers to what is not there is printed as nothing, and nobody is told.
function checkReferences(text) {
  for (const name of unresolvedIn(treeOf(text))) complain('the print edition', `refers to what is not in it: #${name}`);
  stopIfWrong('assembling the print edition');
}

async function print(pages) {
  const text = assemble(pages);
  checkReferences(text);
  writeFileSync(book, text);
  const page = await browser.newPage();
  await page.goto(pathToFileURL(book).href);
  await page.pdf({path: pdf, printBackground: true, outline: true, tagged: true, preferCSSPageSize: true});
  await page.close();
  return pagesOf(pdf);
}

const first = await print(new Map()), second = await print(first);
await browser.close();
for (const {id} of parts)
  if (!second.has(id) || first.get(id) !== second.get(id)) throw new Error(`the contents have page ${first.get(id)} for ${id}, which is on ${second.get(id)}`);
console.log(`The print edition is build/notes/first-contact.pdf`);
