// Title page, colophon and contents of the printed book.
import {escape, isOriginal, language, read, root} from '../tools/book.mjs';
import {chapterMap} from '../tools/generated.mjs';
import {say} from '../tools/words.mjs';
import {parts} from './parts.mjs';

/// The version that CMake knows.
export const version = /project\(FirstContact VERSION (\S+)/.exec(read(root, 'CMakeLists.txt'))[1];
export const title = 'First Contact', subtitle = say('subtitle');
export const author = /- name: (.+)/.exec(read(root, 'CITATION.cff'))[1];
/// What prints this edition.
export const command = './course notes --pdf' + (isOriginal ? '' : ` --lang ${language}`);

export const titlePage = () =>
  `<section class="title-page"><h1>${title}</h1><p class="what">${say('title page')}</p>` +
  (isOriginal ? '<p class="chinese" lang="zh-Hant">碰撞偵測與補間動畫</p>' : '') + chapterMap() +
  `<p class="after">${escape(author)}</p><p class="after-whom">${say('after whom')}</p></section>`;

export const colophon = () => {
  const given = [[title, subtitle, escape(author), version], [], [], [], [command]];
  return `<section class="colophon"><div>${given.map((values, i) => `<p>${say(['colophon', i], ...values)}</p>`).join('\n')}</div></section>`;
};

const number = (pages, place) => `<span class="page">${pages.get(place) ?? ''}</span>`;

function sectionsOf(part, sections, pages) {
  const below = parts.filter(({under}) => under === part.id);
  const lines = part.number || part.letter ? sections : below.map(({id, short, title}) => ({id, title: escape(short ?? title)}));
  if (!lines.length) return '';
  return `<ol class="sections">${lines.map(({id, title}) =>
    `<li><a href="#${id}"><span class="name">${title}</span>${number(pages, id)}</a></li>`).join('')}</ol>`;
}

/// In two levels. \param bodies  the bodies of the parts by id
export const contents = (bodies, pages) => `<section class="toc"><h1>${say('contents')}</h1><ul>` +
  parts.filter(({under}) => !under).map((part) =>
    `<li><a href="#${part.id}"><span class="number">${part.number ?? part.letter ?? ''}</span><span class="name">${escape(part.letter ? part.short : part.title)}</span>` +
    `${number(pages, part.id)}</a>${sectionsOf(part, bodies.get(part.id)?.sections ?? [], pages)}</li>`).join('') + '</ul></section>';
