// Doxygen's pages become the book's: tokens in their place, contents beside them, landmarks, and the style of formulas
// and figures.
import {writeFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {chapters, complain, filesBelow, html, otherPages, read} from './book.mjs';
import {figureStyle} from './figure.mjs';
import {formulaStyle, shareGlyphs} from './formula.mjs';
import {contents} from './generated.mjs';
import {tokens} from './weave.mjs';

const ours = new Map([...chapters, ...otherPages].map((page) => [page.id.replaceAll('_', '-'), page]));

function placeTokens(page, name) {
  const placed = page
      .replace(/<p\b[^>]*>\s*\uE000(\d+)\uE001\s*<\/p>/g, (_, n) => tokens[n].html)
      .replace(/\uE000(\d+)\uE001/g, (_, n) => {
        if (tokens[n].block) complain(name, `a block stands within a paragraph: ${tokens[n].html.slice(0, 60)}`);
        return tokens[n].html;
      });
  return placed;
}

const sectionsOf = (page) =>
  [...page.matchAll(/<h1><a class="anchor" id="([^"]+)"><\/a>\s*([^<]+?)\s*<\/h1>/g)].map(([, id, title]) => ({id, title}));

// Doxygen begins sections at <h1>; here that is the page's title, and sections follow below it.
function landmarks(page) {
  return page
      .replace(/<(h[1-5])><a class="anchor" id="([^"]+)"><\/a>\s*([\s\S]*?)<\/\1>/g, (_, level, id, title) => {
        const lower = `h${+level[1] + 1}`;
        return `<${lower} id="${id}">${title.trim()}</${lower}>`;
      })
      .replace(/<div class="title">([\s\S]*?)\s*<\/div>/, '<h1 class="title">$1</h1>')
      .replace(/\s*<div class="summary">[\s\S]*?<\/div>/, '')
      .replace(/<p ?><a class="anchor" id="[^"]*"><\/a><\/p>\s*/, '')
      .replace(/<div class="line">(?:<a [^>]*><\/a>)?(?: |&#160;)*<span class="comment">\/\/! \[\w+\]<\/span><\/div>\n?/g, '')
      .replace(/<div class="fragment">(?=((?:<div class="line">.*<\/div>\n?)+))/g, (whole, lines) =>
        lines.split('<div class="line">').length <= 18 ? '<div class="fragment short">' : whole)  // on paper in one piece
      .replace(/(<table class="markdownTable">)\s*(<tr class="markdownTableHead">[\s\S]*?<\/tr>)/g, '$1<thead>$2</thead>')
      .replace(/ (cellspacing|cellpadding|border|frameborder)="\d+"/g, '')
      .replace('id="MSearchField"', 'id="MSearchField" aria-label="Search titles and names"')
      .replace(/<iframe /g, '<iframe title="Search results" ');
}

/// Doxygen names a page after its label; ours have the names that links use.
export function finish() {
  for (const path of filesBelow(html, (file) => file.endsWith('.html'))) {
    const name = basename(path);
    if (path.includes('/search/')) continue;
    let page = placeTokens(read(path), name);
    const sections = ours.has(name.replace('.html', '')) ? sectionsOf(page) : [];
    if (!page.includes('<div class="title">'))  // Doxygen's lists of names have none
      page = page.replace('<div class="contents">', '<div class="header"><div class="title">All names</div></div><div class="contents">');
    page = landmarks(page).replace('<!--contents-->', contents(name, sections));
    writeFileSync(path, shareGlyphs(page));
  }
  writeFileSync(join(html, 'made.css'), formulaStyle() + '\n' + figureStyle());
}
