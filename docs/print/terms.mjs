// The index: every term of the glossary, with the pages on which a chapter tells of it first.
import {escape, isOriginal} from '../tools/book.mjs';
import {terms} from '../tools/glossary.mjs';
import {say} from '../tools/words.mjs';

const marks = new Map();  // English -> place -> is it told there what it means?

/// Before the chapters are gone through, again.
export const clearMarks = () => terms.forEach(({english}) => marks.set(english, new Map()));

const wordsOf = (part) => part.text().replace(/\s+/g, ' ');

// In another language, the term's name there.
const formOf = ({pattern, chinese}) => isOriginal ? pattern : new RegExp(chinese.split(/、|，/).join('|'));

/// Notes where a chapter first uses each term, and where it sets the term in italics: there it says what it means.
export function markTerms(tree, id) {
  const blocks = tree('.textblock').find('p, li, figcaption, td').toArray().map((element) =>
    ({element, text: wordsOf(tree(element)), told: tree(element).find('em').toArray().map((em) => wordsOf(tree(em)))}));
  for (const term of terms) {
    const {english} = term, pattern = formOf(term);
    const isTold = ({told}) => told.some((text) => pattern.test(text));
    const first = blocks.find(({text}) => pattern.test(text)), explained = blocks.find(isTold);
    for (const block of new Set([first, explained].filter(Boolean))) mark(tree, id, block.element, english, isTold(block));
  }
}

function mark(tree, id, element, english, told) {
  const found = tree(element).attr('data-term') ?? `${id}--term-${tree('[data-term]').length}`;
  if (!tree(element).attr('data-term')) tree(element).attr('data-term', found).prepend(`<span id="${found}"></span>`);
  marks.get(english).set(found, told);
}

function entry({english, chinese}, pages) {
  const places = new Map();  // page -> place; where the term is told is set in bold
  for (const [place, told] of marks.get(english)) {
    const page = pages.get(place) ?? place, before = places.get(page);
    places.set(page, {place, told: told || before?.told});
  }
  const numbers = [...places].sort(([a], [b]) => a - b || 0).map(([page, {place, told}]) =>
    `<a href="#${place}"${told ? ' class="told"' : ''}>${pages.has(place) ? page : '000'}</a>`);
  return `<li>${escape(english)} <span class="chinese" lang="zh-Hant">${escape(chinese)}</span> ${numbers.join(', ')}</li>`;
}

const byName = (a, b) => a.english.localeCompare(b.english, 'en');

/// The index as HTML. What an edition does not tell yet is not in its index.
export function indexText(pages) {
  const letters = new Map();
  for (const term of [...terms].sort(byName).filter(({english}) => isOriginal || marks.get(english).size)) {
    const letter = term.english[0].toUpperCase();
    letters.set(letter, [...letters.get(letter) ?? [], entry(term, pages)]);
  }
  return `<p class="about">${say('about the index')}</p>` + '<div class="columns">' +
         [...letters].map(([letter, entries]) => `<h2 class="letter">${letter}</h2><ul>${entries.join('')}</ul>`).join('') + '</div>';
}
