// A finished page of the site as a part of the printed book.
import {escape, html, read} from '../tools/book.mjs';
import {treeOf} from '../tools/tree.mjs';
import {say} from '../tools/words.mjs';
import {markTerms} from './terms.mjs';
import {answers, partOf, placeInBook} from './parts.mjs';
import {said} from './said.mjs';

// Files that are folded on their page would be half of the book: here their names lead to them.
function nameWholeFiles(tree) {
  tree('details.whole').each((_, element) => {
    const file = tree(element), id = file.attr('id');
    file.replaceWith(`<p class="elsewhere"${id ? ` id="${id}"` : ''}>${file.children('summary').html()}</p>`);
  });
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

// Outlines are no text: what a formula says is laid over it, unseen.
function sayFormulas(tree) {
  tree('mjx-assistive-mml').each((_, element) => {
    const text = said(tree(element).find('math')[0]), formula = tree(element).parent();
    tree(element).remove();
    formula.prepend('<span class="said"></span>').children('.said').html(escape(text));
  });
}

const things = '.equation, .fragment, .with-copy, table, pre, figure, ul, ol, .listing, div.where';

// A sentence that ends in a colon, or is not at its end, stays with what it announces; what goes on after a formula, with the
// formula. Both ends are marked, for the check.
function joinSentences(tree, id) {
  const marks = [];
  tree('.textblock p:not(.elsewhere)').filter((_, p) => tree(p).next().is(things)).each((i, p) => {
    const next = tree(p).next(), isOpen = /[^.!?)”"’]$/.test(tree(p).text().trim()) || next.is('.equation');
    if (!isOpen) return;
    const from = `${id}--leads-${i}`, to = next.attr('id') ?? `${id}--led-${i}`;
    tree(p).addClass('leads').append(`<span id="${from}"></span>`);
    next.attr('id', to).attr('data-led', from);
    marks.push(from, to);
  });
  tree('.equation + p').filter((_, p) => /^[a-z]/.test(tree(p).text().trim())).addClass('goes-on-here');
  tree('.textblock').prepend(`<div class="marks" aria-hidden="true">${marks.map((mark) => `<a href="#${mark}"></a>`).join('')}</div>`);
}

const notReferred = '.chapter-head, .where-found, .told, .fragment, .where, summary, svg, nav, .chapter-map, .elsewhere';

// Who holds the book in their hands has no link to press: what is elsewhere has its page.
function tellPages(tree, id, pages) {
  tree('p a[href^="#"], li a[href^="#"], td a[href^="#"], dd a[href^="#"], figcaption a[href^="#"]').each((_, element) => {
    const link = tree(element), place = link.attr('href').slice(1);
    if (link.closest(notReferred).length || link.is('.section, .cite') || partOf(place) === id) return;
    link.after(`<span class="on-page"> ${say('on page', pages.get(place) ?? '000')}</span>`);
  });
}

// The answers of a chapter, which stand at the end of the book; the questions lead there.
function takeAnswers(tree, id) {
  const heading = tree('h2').filter((_, h2) => tree(h2).attr('id') === `${id.replaceAll('_', '-')}-answers`);
  if (!heading.length) return '';
  const taken = heading.nextUntil('h2, nav');
  const text = taken.toArray().map((element) => tree.html(element)).join('');
  taken.remove();
  heading.remove();
  return text;
}

// "Answer 3", a line of its own on the page, here ends the question.
function leadToAnswers(tree, given, pages) {
  const places = new Set(given('[id]').toArray().map(({attribs}) => attribs.id));
  tree('p > a').filter((_, {attribs}) => places.has(attribs.href?.slice(1))).each((_, link) => {
    const place = link.attribs.href.slice(1), line = tree(link).parent(), isAlone = line.text() === tree(link).text();
    const question = isAlone ? line.prev('p') : line;
    (isAlone ? line : tree(link)).remove();
    question.append(` <a class="on-page" href="#${place}">${say('answer on page', pages.get(place) ?? '000')}</a>`);
  });
}

/// {title, text, glyphs, answers, sections} of a part. \param pages  on which page each place was in the last print
export function bodyOf({id, page, number, letter}, pages) {
  const tree = treeOf(read(html, page));
  nameWholeFiles(tree);
  tree('nav.turn, .touch').remove();
  tree('details').attr('open', '');
  sayFormulas(tree);
  const given = treeOf(`<div id="given">${takeAnswers(tree, id)}</div>`);
  for (const each of [tree, given]) renameAnchors(each, id);
  joinSentences(tree, id);
  leadToAnswers(tree, given, pages);
  if (number || letter) markTerms(tree, id);
  tellPages(tree, id, pages);
  tellPages(given, answers.id, pages);
  const sections = tree('.textblock h2[id]').toArray().map((h2) => ({id: h2.attribs.id, title: tree(h2).html()}));
  return {title: tree.html('h1.title'), text: tree('.textblock').html(), glyphs: tree.html('svg.glyphs'),
          answers: given(`#${id}--given`).html() ?? '', sections};
}
