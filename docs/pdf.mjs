// The print edition: all chapters in one PDF with its figures as vectors, printed by Chromium from the finished pages.
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {executable} from './checks/browser.mjs';
import {build, chapters, html, otherPages, read} from './tools/book.mjs';
import {chapterList, chapterMap} from './tools/generated.mjs';

const back = otherPages.filter((page) => !page.front);

// The body of a finished page, its anchors made its own so that pages can stand in one file.
function bodyOf({id, page}) {
  const text = read(html, page);
  const title = /<h1 class="title">[\s\S]*?<\/h1>/.exec(text)[0];
  const inner = /<div class="textblock">([\s\S]*)<\/div>\s*<\/div><!-- contents -->/.exec(text)[1];
  const body = title + inner.replace(/<nav class="turn"[\s\S]*?<\/nav>/, '');
  const glyphs = /<svg class="glyphs"[\s\S]*?<\/svg>/.exec(text)?.[0] ?? '';
  const own = (name) => `${id}--${name}`;
  return (glyphs + body)
      .replace(/\sid="([^"]+)"/g, (_, name) => ` id="${own(name)}"`)
      .replace(/\b((?:xlink:)?href)=(["'])#([^"']+)\2/g, (_, attribute, quote, name) => `${attribute}=${quote}#${own(name)}${quote}`)
      .replace(/url\(#([^)]+)\)/g, (_, name) => `url(#${own(name)})`)
      .replace(/\bhref="([\w-]+\.html)(?:#([^"]+))?"/g, (whole, target, name) => {
        const other = [...chapters, ...otherPages].find((each) => each.page === target);
        return other ? `href="#${name ? `${other.id}--${name}` : other.id}"` : '';
      })
      .replace(/<details /g, '<details open ');
}

function assemble() {
  const style = (name) => `<style>${read(html, name)}</style>`;
  const entry = (page) => `<li><a href="#${page.id}">${page.number ? `<span class="number">${page.number}</span> ` : ''}${page.title}</a>` +
                          `<span class="page" data-page="${page.id}"></span></li>`;
  const part = (page) => `<article id="${page.id}"><div class="contents"><div class="textblock">${bodyOf(page)}</div></div></article>`;
  const ordered = [otherPages[1], ...chapters, ...back];
  return `<!DOCTYPE html><html lang="en" class="light-mode"><head><meta charset="utf-8"><title>First Contact</title>` +
    ['tabs.css', 'doxygen.css', 'doxygen-awesome.css', 'book.css', 'made.css', 'print.css'].map(style).join('') + '</head><body class="book"><main>' +
    `<section class="title-page"><h1>First Contact</h1><p class="what">Collision detection and tweened animation,<br>chapter by chapter</p>` +
    `<p class="chinese" lang="zh-Hant">碰撞偵測與補間動畫</p>${chapterMap()}<p class="after">After Shing-Min Hu, 胡興民, 〈以補間動畫實作碰撞偵測〉</p></section>` +
    `<section class="toc"><h1>Contents</h1><ul>${ordered.map(entry).join('')}</ul></section>` +
    ordered.map(part).join('') + '</main></body></html>';
}

const book = join(build, 'book.html'), pdf = join(build, 'first-contact.pdf');
writeFileSync(book, assemble());
const browser = await chromium.launch({executablePath: executable(), args: ['--no-sandbox', '--disable-gpu', '--export-tagged-pdf']});
const page = await browser.newPage();
await page.goto(pathToFileURL(book).href);
const footer = '<div style="width:100%;text-align:center;font:9pt Palatino,\'TeX Gyre Pagella\',serif;color:#555"><span class="pageNumber"></span></div>';
await page.pdf({path: pdf, format: 'A4', printBackground: true, displayHeaderFooter: true, headerTemplate: '<span></span>', footerTemplate: footer,
                outline: true, tagged: true, preferCSSPageSize: true});
await browser.close();
console.log(`The print edition is build/notes/first-contact.pdf`);
