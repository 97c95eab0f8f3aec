// The bibliography, the paper map and the errata: made from their data, which the checks read as well.
import {chapters, data, escape} from './book.mjs';
import {formula} from './formula.mjs';
import {formatted, valueOf} from './values.mjs';
import {prose} from './weave.mjs';
import {say} from './words.mjs';

const byLabel = (a, b) => a.label.localeCompare(b.label, 'en', {numeric: true});

export function bibliography() {
  return data('references.json').map(({group, entries}) =>
    `<h2>${escape(group)}</h2><dl class="references">` + [...entries].sort(byLabel).map(({key, label, text}) =>
      `<div id="${key}"><dt>${escape(label)}</dt><dd>${prose(text, 'references.json')}</dd></div>`).join('') + '</dl>').join('');
}

// --- the paper map ------------------------------------------------------------------------------------------------

const chapterOf = (number) => chapters.find((chapter) => chapter.number === number);
const chapterLink = (number) => `<a href="${chapterOf(number).page}">${number} · ${escape(chapterOf(number).title)}</a>`;
const names = (list, mark) => [list].flat().filter(Boolean).map((name) => `<${mark}>${escape(name)}</${mark}>`).join(mark === 'q' ? '' : ', ');

function where(item) {
  const figure = [item.figure].flat().filter(Boolean)
      .map((path) => `<a href="${figurePage(path)}">${escape(path.split('/')[1])}</a>`).join(', ');
  return `<dl class="where-found"><div><dt>${say('in chapter')}</dt><dd>${[item.chapter].flat().map(chapterLink).join(', ')}</dd></div>` +
         `<div><dt>${say('its code')}</dt><dd>${names(item.function, 'code')}</dd></div>` +
         `<div><dt>${say('its test')}</dt><dd>${names(item.test, 'q')}</dd></div>` +
         (figure ? `<div><dt>${say('its figure')}</dt><dd>${figure}</dd></div>` : '') + '</dl>';
}

const figurePage = (path) => chapters.find(({folder}) => folder === path.split('/')[0])?.page ?? '#';

function row(id, name, what, item) {
  return `<div class="item" id="${id}"><h3>${name}</h3><div class="what">${what}</div>${where(item)}</div>`;
}

const text = (words) => `<p>${prose(words, 'paper-map.json')}</p>`;

function printedNumber(item) {
  let computed = '?';
  try {
    computed = formatted(valueOf(item.value));
  } catch { /* the check says what is wrong */ }
  return `<p>${say('printed and computed', escape(item.printed.replace('-', '−')), `<b>${computed}</b>`)}</p>`;
}

export function paperTable() {
  const map = data('paper-map.json');
  const part = (id, title, rows) => `<h2 id="${id}">${title}</h2><div class="items">${rows.join('')}</div>`;
  return part('sections', say('sections'), map.sections.map((item) => row('s' + item.id, `§${item.id}`, text(item.says), item))) +
         part('equations', say('equations'), map.equations.map((item) =>
           row('e' + item.id, `(${item.id})`, formula(item.tex), item))) +
         part('figures', say('figures'), map.figures.map((item) =>
           row('f' + item.id, say('numbered figure', item.id), text(item.says), item))) +
         part('listings', say('listings'), map.listings.map((item) =>
           row('p' + item.id, say('numbered program', item.id), text(item.says), item))) +
         part('numbers', say('numbers'), map.numbers.map((item, i) =>
           row('n' + (i + 1), escape(item.of), printedNumber(item), item)));
}

// --- the errata ---------------------------------------------------------------------------------------------------

export function errataTable() {
  return '<div class="errata">' + data('errata.json').map((fault, i) => {
    const told = (words) => `<p>${prose(words, 'errata.json')}</p>`;
    return `<section id="erratum-${i + 1}"><h2>${i + 1}. ${prose(fault.title, 'errata.json')}</h2>` +
           `<p class="place">${prose(fault.place, 'errata.json')}</p>` +
           `<dl><div><dt>${say('as printed')}</dt><dd>${told(fault.printed)}</dd></div>` +
           `<div><dt>${say('what happens')}</dt><dd>${told(fault.wrong)}</dd></div>` +
           `<div><dt>${say('remedy')}</dt><dd>${told(fault.remedy)}</dd></div></dl>${where(fault)}</section>`;
  }).join('') + '</div>';
}
