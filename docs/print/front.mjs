// Title page, colophon and contents of the printed book.
import {escape, read, root} from '../tools/book.mjs';
import {chapterMap} from '../tools/generated.mjs';
import {parts} from './parts.mjs';

/// The version that CMake knows.
export const version = /project\(FirstContact VERSION (\S+)/.exec(read(root, 'CMakeLists.txt'))[1];
export const title = 'First Contact', subtitle = 'Collision detection and tweened animation, chapter by chapter';
export const author = /- name: (.+)/.exec(read(root, 'CITATION.cff'))[1];

export const titlePage = () =>
  `<section class="title-page"><h1>${title}</h1><p class="what">Collision detection and tweened animation,<br>chapter by chapter</p>` +
  `<p class="chinese" lang="zh-Hant">碰撞偵測與補間動畫</p>${chapterMap()}` +
  `<p class="after">${escape(author)}</p><p class="after-whom">after the paper by Shing-Min Hu, <span class="chinese" lang="zh-Hant">胡興民</span></p></section>`;

export const colophon = () => `<section class="colophon"><div>
<p><b>${title}.</b> ${subtitle}. By ${escape(author)}. Version ${version}.</p>
<p>It follows <i>Implementing Collision Detection with Tweened Animation</i> by Shing-Min Hu
(<span class="chinese" lang="zh-Hant">胡興民，〈以補間動畫實作碰撞偵測〉</span>), Department of Digital Game and Animation Design,
Tung-Fung Design University, Kaohsiung, Taiwan. The formulas, figures and programs of the paper are told anew here; what is said of them,
and every mistake in it, is our own.</p>
<p><b>Licence.</b> The text and the figures: Creative Commons Attribution 4.0 International (CC BY 4.0),
https://creativecommons.org/licenses/by/4.0/. Share them and change them, also in a course of your own, if you say from where they are and
what you have changed. The code, also where it stands on these pages: MIT.</p>
<p><b>How it was made.</b> Every number in the text comes from a run of the programs, every listing from their sources, every figure from a
gnuplot script that a program wrote. Doxygen, markdown-it and MathJax made the pages, Chromium printed them. The text is set in STIX Two, the code in Ubuntu Mono,
Chinese in AR PL UMing, the letters of the figures in DejaVu Serif, the formulas in the type of TeX.</p>
<p>With the sources, <span class="shell">./course notes --pdf</span> prints this book again.</p>
</div></section>`;

const number = (pages, place) => `<span class="page">${pages.get(place) ?? ''}</span>`;

function sectionsOf(part, sections, pages) {
  const below = parts.filter(({under}) => under === part.id);
  const lines = part.number || part.letter ? sections : below.map(({id, short, title}) => ({id, title: escape(short ?? title)}));
  if (!lines.length) return '';
  return `<ol class="sections">${lines.map(({id, title}) =>
    `<li><a href="#${id}"><span class="name">${title}</span>${number(pages, id)}</a></li>`).join('')}</ol>`;
}

/// In two levels. \param bodies  the bodies of the parts by id
export const contents = (bodies, pages) => `<section class="toc"><h1>Contents</h1><ul>` +
  parts.filter(({under}) => !under).map((part) =>
    `<li><a href="#${part.id}"><span class="number">${part.number ?? part.letter ?? ''}</span><span class="name">${escape(part.letter ? part.short : part.title)}</span>` +
    `${number(pages, part.id)}</a>${sectionsOf(part, bodies.get(part.id)?.sections ?? [], pages)}</li>`).join('') + '</ul></section>';
