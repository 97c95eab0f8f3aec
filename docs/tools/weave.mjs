// An essay as its author writes it becomes a page for Doxygen: numbers looked up, formulas set, figures inlined,
// listings named. Doxygen reads its headings, for the search, and its listings, for their links; all else is finished
// HTML, travels through Doxygen as a token, and is put in its place later.
import {existsSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';
import {
  chapters, codeFile, complain, data, docs, escape, figureFile, fromRoot, isOriginal, language, otherPages, pageInEnglish,
  read, root,
} from './book.mjs';
import {cost} from './cost.mjs';
import {inlineFigure} from './figure.mjs';
import {formula} from './formula.mjs';
import {checkPage, filesOf, whereTold} from './library.mjs';
import {markdown} from './markdown.mjs';
import {typedNumbers} from './typed.mjs';
import {canTouch} from './touch.mjs';
import {asPage} from './translation.mjs';
import {formatted, runNamed, valueOf} from './values.mjs';
import {say} from './words.mjs';

export const tokens = [];
const token = (html) => `\n\n\uE000${tokens.push(html) - 1}\uE001\n\n`;

/// What the checks ask about afterwards.
export const shown = {snippets: [], figures: [], equations: new Map(), outputs: [], typed: [], cited: new Set(), touch: []};

/// What a heading is called in links: made from its English words in every language.
export const slug = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '');

// A long path may break after a slash.
const shownPath = (path) => escape(path).replaceAll('/', '/<wbr>');

export const references = data('references.json').flatMap((group) => group.entries);

class Page {
  constructor(id, source, prefix, text = read(source)) {
    Object.assign(this, {id, source, prefix, text, figures: [], filesShown: []});
    this.name = fromRoot(source);
  }

  where(line) {
    return `${this.name}:${line}`;
  }

  attempt(line, what, instead = '') {
    try {
      return what();
    } catch (error) {
      complain(this.where(line), error.message.split('\n')[0]);
      return instead;
    }
  }

  // {{plane.contact.time}}, {{plane.contact.time:.3f}}, {{typed 0.07 | why}}, {{cost root: file tag}};
  // within a table a | is \|.
  number(body, line, inFormula) {
    return this.attempt(line, () => {
      const typed = /^typed\s+(.*?)\s*\|\s*(.+)$/.exec(body);
      if (typed) {
        shown.typed.push({where: this.where(line), number: typed[1], reason: typed[2]});
        return inFormula ? typed[1] : typed[1].replace(/^-/, '−');
      }
      if (/^cost /i.test(body)) {
        const words = cost(body.slice(5));
        return body.startsWith('C') ? words[0].toUpperCase() + words.slice(1) : words;
      }
      const [name, form] = body.split(':');
      return formatted(valueOf(name.trim()), form?.trim(), inFormula);
    }, '?');
  }

  // Also {{figure touch}} and {{eq 1.2.3}}, which lead there.
  value(body, line) {
    const [, kind, name] = /^(figure|eq) ([\w.-]+)$/.exec(body) ?? [];
    if (kind === 'figure') return `<a href="#figure-${name}">${say('to figure')}&nbsp;${this.figureNumber(name, line)}</a>`;
    return kind ? `<a href="#eq-${name}">(${name})</a>` : this.number(body, line, false);
  }

  filled(text, line, inFormula) {
    return text.replace(/\{\{([^{}]*)\}\}/g, (_, body) => this.number(body, line, inFormula));
  }

  set(tex, line, display) {
    return this.attempt(line, () => formula(this.filled(tex, line, true), display), '<code>?</code>');
  }

  figureNumber(name, line) {
    const at = this.figures.indexOf(name);
    if (at < 0) complain(this.where(line), `there is no figure ${name} on this page`);
    return (this.prefix ? this.prefix + '.' : '') + (at + 1);
  }

  cited(key, line) {
    const entry = references.find((each) => each.key === key);
    if (!entry) complain(this.where(line), `the bibliography has no ${key}`);
    shown.cited.add(key);
    return `<a class="cite" href="${pageInEnglish('bibliography.html')}#${key}">${escape(entry?.label ?? key)}</a>`;
  }

  // To another essay, as one who reads the sources finds it, or within the page.
  link(target, line) {
    if (!/^(#|[^:#]+\.md(#|$))/.test(target)) return target;
    const [file, anchor] = target.split('#');
    if (!file) return target;
    const path = resolve(dirname(this.source), file);
    const page = [...chapters, ...otherPages].find((each) => each.original === path);
    if (!page) complain(this.where(line), `the link ${target} leads to no page`);
    return (page?.page ?? file) + (anchor ? '#' + anchor : '');
  }

  // A caption or a label.
  asHtml(text, line) {
    return markdown.renderInline(text, {page: this, line});
  }

  figure({alternative, target, name, line}) {
    const path = fromRoot(resolve(dirname(this.source), target));
    shown.figures.push({path, page: this.id});
    if (alternative.length < 20) complain(this.where(line), `the figure ${name} needs an alternative text that tells what is seen`);
    const svg = this.attempt(line, () => this.pictures(path, `${this.id}-${name}`.replaceAll('_', '-'), alternative));
    return `<figure id="figure-${name}"><div class="drawn">${svg}</div><figcaption><b>${say('figure')}&nbsp;${this.figureNumber(name, line)}.</b> `;
  }

  // The picture, and, where the chapter draws it moving as well, that one: the style sheet shows one of the two.
  pictures(path, prefix, alternative) {
    const moving = path.replace(/\.svg$/, '-animated.svg'), still = inlineFigure(path, prefix, alternative);
    if (!existsSync(figureFile(moving))) return still;
    shown.figures.push({path: moving, page: this.id});
    return still.replace('<svg', '<svg class="rests"') +
           inlineFigure(moving, prefix + '-moves', alternative).replace('<svg', '<svg class="moves"');
  }

  // A place that docs/touch/main.js fills; hidden until then.
  touch({name}) {
    if (!canTouch || !isOriginal) return '';
    shown.touch.push({name, page: this.id});
    return `<figure class="touch" id="touch-${name}" data-figure="${name}" hidden></figure>`;
  }

  equation({tex, line}) {
    const tag = /\\tag\{([^}]+)\}/.exec(tex)?.[1];
    const set = this.set(tex.replace(/\\tag\{[^}]+\}/, '').trim(), line, true);
    if (!tag) return `<div class="equation">${set}</div>`;
    if (shown.equations.has(tag)) complain(this.where(line), `equation (${tag}) stands twice`);
    shown.equations.set(tag, this.id);
    return `<div class="equation" id="eq-${tag}">${set}<span class="tag">(${tag})</span></div>`;
  }

  listing(file, tag, folded, line) {
    const place = codeFile(file);
    if (!place) {
      complain(this.where(line), `there is no file ${file} to show`);
      return '';
    }
    shown.snippets.push({file: fromRoot(place), tag, page: this.id});
    const command = tag ? `\\snippet ${file} ${tag}` : `\\include ${file}`;
    const ownPage = otherPages.find((page) => page.folders?.some((folder) => dirname(file) === `first_contact/${folder}`));
    const anchor = `file-${basename(file).replaceAll('.', '-')}`, path = shownPath(fromRoot(place));
    if (!folded)
      return token(`<div class="where">${ownPage ? `<a href="${ownPage.page}#${anchor}">${path}</a>` : path}</div>`) + command + '\n\n';
    const mark = this.id === ownPage?.id ? ` id="${anchor}"` : '';
    return token(`<details class="listing${tag ? '' : ' whole'}"${mark}><summary>${this.asHtml(folded, line)} <span class="where">${path}</span></summary>`) +
           command + '\n' + token('</details>');
  }

  // All files of parts of the library, folded: \files sweep/batch sweep/batch_loops
  files(stems, line) {
    return this.attempt(line, () => {
      const files = stems.trim().split(/\s+/).flatMap(filesOf);
      this.filesShown.push(...files);
      return token(whereTold(files, shown.snippets)) + files.map((file) => this.listing(`first_contact/${file}`, '', `\`${basename(file)}\``, line)).join('');
    });
  }

  output(file, line) {
    shown.outputs.push({file, page: this.id});
    const path = join(root, 'chapters', isOriginal ? file : file.replace('.expected', `.${language}.expected`));
    const printed = this.attempt(line, () => read(path).trimEnd());
    const lines = printed.split('\n').map((text) => `<span class="line">${escape(text) || ' '}</span>`).join('\n');
    return token(`<div class="where">${shownPath(fromRoot(path))}</div><pre class="output">${lines}</pre>`);
  }

  fence({info, content}, line) {
    if (info !== 'sh') complain(this.where(line), 'code comes in by \\snippet alone; only sh may be typed');
    return `<pre class="shell"><code>${escape(content.trimEnd())}</code></pre>`;
  }

  // \snippet FILE TAG, \folded FILE [TAG] | TITLE, \files STEM ..., \output FILE
  command({name, rest, line}) {
    if (name === 'files') return this.files(rest, line);
    if (name === 'output') return this.output(rest, line);
    const [place, title = ''] = rest.split(' | '), [file, tag = ''] = place.trim().split(' ');
    if ((name === 'folded') !== (title !== '') || name === 'snippet' && !tag)
      complain(this.where(line), `\\${name} ${rest}: must be \\snippet FILE TAG or \\folded FILE [TAG] | TITLE`);
    return this.listing(file, tag, title, line);
  }

  heading([{markup, map}, {content}]) {
    const [, words, name = slug(words)] = /^(.*?)(?: \{#([\w-]+)\})?$/.exec(content);
    if (/[$`]/.test(words)) complain(this.where(1 + map[0]), 'a heading holds words alone, for contents and search');
    return markup === '#' ? '' : `${markup} ${words} {#${this.id.replaceAll('_', '-')}-${name}}`;
  }

  made({name, line}) {
    if (this.generated?.[name]) return this.generated[name];
    complain(this.where(line), `there is nothing made by the name ${name}`);
    return '';
  }

  // Runs come first, so that a number may stand before the line that asks for its run.
  body() {
    const env = {page: this, line: 1}, parts = markdown.parse(this.text, env), result = [];
    typedNumbers(parts, (line, number) =>
      complain(this.where(line), `${number} is typed by hand: look it up, {{program.name}}, or say why not, {{typed ${number} | reason}}`));
    for (const {type, meta} of parts)
      if (type === 'run') this.attempt(meta.line, () => runNamed(meta.name, meta.options));
    while (parts.length) {
      const doxygens = parts.findIndex(({type, level}) => level === 0 && (type === 'command' || type === 'heading_open'));
      const between = parts.splice(0, doxygens < 0 ? parts.length : doxygens);
      if (between.length) result.push(token(markdown.renderer.render(between, markdown.options, env)));
      if (parts.length) result.push(parts[0].type === 'command' ? this.command(parts.shift().meta)
                                                                : this.heading(parts.splice(0, 3)));
    }
    return result.join('\n');
  }
}

// What each part of an essay becomes.
const becomes = {
  formula: (page, {content, meta}) => page.set(content, meta.line, false),
  value: (page, {content, meta}) => page.value(content, meta.line),
  cited: (page, {content, meta}) => page.cited(content, meta.line),
  section: (page, {content}) => `<a class="section" href="${pageInEnglish('papermap.html')}#s${content}">§${content}</a>`,
  link_open: (page, {attrs, meta}) => `<a href="${escape(page.link(attrs[0][1], meta.line))}">`,
  equation: (page, {meta}) => page.equation(meta),
  figure_open: (page, {meta}) => page.figure(meta),
  figure_close: () => '</figcaption></figure>',
  fence: (page, part) => page.fence(part, 1 + part.map[0]),
  made: (page, {meta}) => page.made(meta),
  answer: (page, {meta}) => meta.ends ? '</details>' : '<details class="answer">',
  touch: (page, {meta}) => page.touch(meta),
  run: () => '',
  command: (page, {meta}) => complain(page.where(meta.line), 'a listing must not stand within a list or a quotation') ?? '',
  table_open: () => '<table class="markdownTable">',
};
for (const [type, make] of Object.entries(becomes))
  markdown.renderer.rules[type] = (parts, i, options, {page}) => make(page, parts[i]);

/// A sentence from one of the data files as HTML. \param file  where it stands, for complaints
export const prose = (text, file) => new Page(file, join(docs, 'pages', file), null, text).asHtml(text, 1);

const answered = new RegExp(`^\\*\\*(\\d+\\.|${say('ask yourself')})\\*\\*([^]*?)<details>\\n<summary>.*</summary>\\n([^]*?)</details>$`, 'gm');

// The folded answers of a chapter move to the end of its page, where nobody reads them by accident: to its exercises, which
// are numbered, and to what is asked on the way, by letters.
function answersLast(text, id) {
  const answers = [];
  let asked = 0;
  const questions = text.replace(answered, (_, name, question, answer) => {
    const isNumbered = /^\d/.test(name), n = isNumbered ? name.slice(0, -1) : String.fromCharCode('a'.charCodeAt(0) + asked++);
    answers.push(`### ${say('answer')} ${n} {#answer-${n}}\n\n${answer.trim()}\n`);
    const link = `[${say('answer')} ${n}](#${id.replaceAll('_', '-')}-answer-${n})`;
    return `**${name}**${isNumbered ? question : question.trimEnd() + ' '}${link}`;
  });
  return answers.length ? `${questions}\n## ${say('answers')} {#answers}\n\n${answers.join('\n')}` : text;
}

/// One page for Doxygen. \param head  its title, and the HTML that follows it; \param foot  the HTML at its end
export function weave({id, source, original, chapter, letter, title, folders, text, head = '', foot = '', generated = {}}) {
  const page = new Page(id, source, chapter?.number ?? letter, text ?? asPage(source, original, slug));
  page.generated = generated;
  const first = /^# (.+)\n/.exec(page.text);
  if (first?.[1] !== title) complain(`${page.name}:1`, `the first line must be "# ${title}"`);
  if (chapter || letter) page.text = answersLast(page.text, id);
  const label = id === 'index' ? '{#mainpage}' : `{#${id.replaceAll('_', '-')}}`;
  const body = page.body();
  if (folders) checkPage({folders, source}, page.filesShown);
  return `# ${title} ${label}\n${head && token(head)}\n${body}\n${foot && token(foot)}\n`;
}
