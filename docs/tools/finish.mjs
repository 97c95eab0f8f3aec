// Doxygen's pages become the book's: tokens in their place, contents beside them, landmarks, and the style of formulas
// and figures.
import {rmSync, writeFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {chapters, filesBelow, html, otherPages, read} from './book.mjs';
import {figureStyle, forLetters} from './figure.mjs';
import {formulaStyle, shareGlyphs} from './formula.mjs';
import {contents} from './generated.mjs';
import {buildTouch, colourVariables, touchLinks} from './touch.mjs';
import {treeOf} from './tree.mjs';
import {say} from './words.mjs';
import {tokens} from './weave.mjs';

const ours = new Map([...chapters, ...otherPages].map((page) => [page.id.replaceAll('_', '-'), page]));

// Each token is a paragraph to Doxygen. It may be the beginning or the end of something that a listing stands in, so it is
// put in its place as letters are.
function withTokens(page) {
  if (!page.includes('\uE000')) return page;
  const tree = treeOf(page);
  tree('p').filter((_, paragraph) => /^\uE000\d+\uE001$/.test(tree(paragraph).text().trim()))
      .each((_, paragraph) => { tree(paragraph).replaceWith(tree(paragraph).contents()); });
  return tree.html().replace(/\uE000(\d+)\uE001/g, (_, n) => tokens[n]);
}

// Doxygen begins sections at <h1>; here that is the page's title, and sections follow below it.
function lowerHeadings(tree) {
  tree('h1, h2, h3, h4, h5').has('> a.anchor[id]').each((_, heading) => {
    const anchor = tree(heading).children('a.anchor').first(), id = anchor.attr('id');
    anchor.remove();
    heading.name = `h${+heading.name[1] + 1}`;
    tree(heading).attr('id', id).html(tree(heading).html().trim());
  });
}

function setTitle(tree) {
  if (!tree('div.title').length)  // Doxygen's lists of names have none
    tree('div.contents').first().before(`<div class="header"><div class="title">${say('all names')}</div></div>`);
  const title = tree('div.title').first();
  title.replaceWith(`<h1 class="title">${title.html().trim()}</h1>`);
}

// The marks of \snippet, where a whole file is shown.
function withoutMarks(tree) {
  tree('.line').filter((_, line) => /^\s*\/\/! \[\w+\]$/.test(tree(line).text().replaceAll('&#160;', ' ')))
      .each((_, line) => {
        if (line.next?.data === '\n') tree(line.next).remove();
        tree(line).remove();
      });
}

// Doxygen takes a name of JavaScript for one of the library's.
function withoutForeignLinks(tree) {
  const ofScripts = tree('.where').filter((_, where) => tree(where).text().endsWith('.js'));
  ofScripts.add(ofScripts.closest('summary')).next('div.fragment').find('a')
      .each((_, link) => { tree(link).replaceWith(tree(link).html()); });
}

function mend(tree) {
  lowerHeadings(tree);
  setTitle(tree);
  withoutMarks(tree);
  withoutForeignLinks(tree);
  tree('th:empty').each((_, cell) => { cell.name = 'td'; });  // the corner of a table heads nothing
  tree('div.summary').remove();
  tree('p').has('> a.anchor:only-child:empty').remove();
  const isShort = (_, listing) => tree(listing).find('.line').length < 18;
  tree('div.fragment').filter(isShort).addClass('short');  // on paper in one piece
  for (const attribute of ['cellspacing', 'cellpadding', 'border', 'frameborder']) tree(`[${attribute}]`).removeAttr(attribute);
  tree('#MSearchField').attr('aria-label', say('search'));
  tree('iframe').attr('title', say('search results'));
}

const sectionsOf = (tree) =>
  tree('.textblock h2[id]').toArray().map((heading) => ({id: heading.attribs.id, title: tree(heading).html()}));

/// Doxygen names a page after its label; ours have the names that links use.
export function finish() {
  for (const path of filesBelow(html, (file) => file.endsWith('.html'))) {
    const name = basename(path);
    if (path.includes('/search/')) continue;
    const tree = treeOf(withTokens(read(path)));
    mend(tree);
    tree('#contents').html(contents(name, ours.has(name.replace('.html', '')) ? sectionsOf(tree) : []));
    shareGlyphs(tree);
    if (tree('.touch').length) tree('head').append(touchLinks);
    writeFileSync(path, tree.html());
  }
  rmSync(join(html, 'doxygen.svg'), {force: true});  // no page shows it, and it draws what it does not have
  writeFileSync(join(html, 'made.css'), [formulaStyle(), figureStyle(), colourVariables(forLetters)].join('\n'));
  buildTouch();
}
