// What stands in the printed book, in its order, and how a link within it is written.
import {appendices, chapters, otherPages} from '../tools/book.mjs';
import {say} from '../tools/words.mjs';

const page = (id) => otherPages.find((each) => each.id === id);
const filesOfLibrary = otherPages.filter(({isLibrary, folders}) => isLibrary && folders);
const exercises = otherPages.filter(({isExercise}) => isExercise);
const back = otherPages.filter(({front, letter, isLibrary, isWorkbook}) =>
  !front && !letter && !isLibrary && !isWorkbook);

/// The answers and the index are made here; `under` is the part that a part goes on in, without a new page.
export const answers = {id: 'answers', title: say('answers')}, index = {id: 'terms', title: say('index')};

/// An edition in another language prints what of it is there.
export const parts = [
  {...page('reading'), onRight: true},
  page('primer'),
  ...chapters.map((chapter) => ({...chapter, onRight: true})),
  ...appendices.map((part) => ({...part, onRight: true})),
  {...page('library'), onRight: true}, ...filesOfLibrary.map((part) => ({...part, under: 'library'})),
  {...page('workbook'), onRight: true}, ...exercises.map((part) => ({...part, under: 'workbook'})),
  ...back.slice(0, 1), {...answers, isHere: true, onRight: true}, ...back.slice(1), {...index, isHere: true},
].filter(({isHere}) => isHere);

/// Where a link leads in the book, as #PLACE; nowhere if that page is not in it.
export function placeInBook(target, own) {
  if (target.startsWith('#')) return '#' + own(target.slice(1));
  const [, name, anchor] = /^([\w-]+\.html)(?:#(.+))?$/.exec(target) ?? [];
  const part = parts.find((each) => each.page === name);
  if (!name) return target;
  return part && `#${anchor ? `${part.id}--${anchor}` : part.id}`;
}

/// The part that a place is in.
export const partOf = (place) => place.split('--')[0];
