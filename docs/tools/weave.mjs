// An essay as its author writes it becomes a page for Doxygen: numbers looked up, formulas set, figures inlined,
// listings named. What is finished HTML already travels through Doxygen as a token, and is put in its place later.
import {existsSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';
import {chapters, complain, data, docs, escape, fromRoot, otherPages, read, root} from './book.mjs';
import {cost} from './cost.mjs';
import {inlineFigure} from './figure.mjs';
import {formula} from './formula.mjs';
import {checkPage, filesOf, whereTold} from './library.mjs';
import {typedNumbers} from './typed.mjs';
import {formatted, runNamed, valueOf} from './values.mjs';

export const tokens = [];
const token = (html, block) => `\uE000${tokens.push({html, block}) - 1}\uE001`;
export const inlineToken = (html) => token(html, false);
export const blockToken = (html) => `\n\n${token(html, true)}\n\n`;

/// What the checks ask about afterwards.
export const shown = {snippets: [], figures: [], equations: new Map(), outputs: [], typed: [], cited: new Set()};

const slug = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '');

// A long path may break after a slash.
const shownPath = (path) => escape(path).replaceAll('/', '/<wbr>');

export const references = data('references.json').flatMap((group) => group.entries);

// Cuts a text at whatever a rule matches first, [regular expression, (index, ...groups) => result], and gives the
// pieces: {words} between the matches, {done} for them.
function cut(text, rules) {
  const pieces = [];
  let at = 0;
  while (at < text.length) {
    let best;
    for (const [rule, make] of rules) {
      rule.lastIndex = at;
      const found = rule.exec(text);
      if (found && (!best || found.index < best.found.index)) best = {found, make};
    }
    if (!best) break;
    pieces.push({words: text.slice(at, best.found.index), index: at});
    pieces.push({done: best.make(best.found.index, ...best.found.slice(1)) ?? ''});
    at = best.found.index + best.found[0].length;
  }
  pieces.push({words: text.slice(at), index: at});
  return pieces;
}

class Page {
  constructor(id, source, chapter, text = read(source)) {
    Object.assign(this, {id, source, chapter, text, figures: [], filesShown: []});
    this.name = fromRoot(source);
  }

  where(index) {
    return `${this.name}:${this.text.slice(0, index).split('\n').length}`;
  }

  attempt(index, what, instead = '') {
    try {
      return what();
    } catch (error) {
      complain(this.where(index), error.message.split('\n')[0]);
      return instead;
    }
  }

  // {{plane.contact.time}}, {{plane.contact.time:.3f}}, {{typed 0.07 | why}}, {{cost root: file tag}}, {{figure touch}}, {{eq 1.2.3}}
  number(body, index, inFormula) {
    return this.attempt(index, () => {
      const typed = /^typed\s+(.*?)\s*\|\s*(.+)$/.exec(body);
      if (typed) {
        shown.typed.push({where: this.where(index), number: typed[1], reason: typed[2]});
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

  filled(text, index, inFormula) {
    return text.replace(/\{\{([^{}]*)\}\}/g, (_, body) => this.number(body, index, inFormula));
  }

  set(tex, index, display) {
    return this.attempt(index, () => formula(this.filled(tex, index, true), display), '<code>?</code>');
  }

  figureNumber(name, index) {
    const at = this.figures.indexOf(name);
    if (at < 0) complain(this.where(index), `there is no figure ${name} on this page`);
    return (this.chapter ? this.chapter.number + '.' : '') + (at + 1);
  }

  cited(key, index) {
    const entry = references.find((each) => each.key === key);
    if (!entry) complain(this.where(index), `the bibliography has no ${key}`);
    shown.cited.add(key);
    return `<a class="cite" href="bibliography.html#${key}">${escape(entry?.label ?? key)}</a>`;
  }

  link(target, index) {
    const [file, anchor] = target.split('#');
    if (!file) return target;
    const path = resolve(dirname(this.source), file);
    const page = [...chapters, ...otherPages].find((each) => each.source === path);
    if (!page) complain(this.where(index), `the link ${target} leads to no page`);
    return (page?.page ?? file) + (anchor ? '#' + anchor : '');
  }

  // The parts of a line that become HTML here; `keep` says what stands for them in the result.
  inline(text, start, keep) {
    const rules = [
      [/`([^`\n]+)`/g, (i, code) => `<code>${escape(code)}</code>`],
      [/\$([^$]+?)\$/g, (i, tex) => this.set(tex, i, false)],
      [/\{\{figure ([\w-]+)\}\}/g, (i, name) =>
        `<a href="#figure-${name}">figure&nbsp;${this.figureNumber(name, i)}</a>`],
      [/\{\{eq ([\w.]+)\}\}/g, (i, tag) => `<a href="#eq-${tag}">(${tag})</a>`],
      [/\{\{([^{}]*)\}\}/g, (i, body) => this.number(body, i, false)],
      [/\[@([\w-]+)\]/g, (i, key) => this.cited(key, i)],
      [/§\s?(\d(?:\.\d)*)/g, (i, section) => `<a class="section" href="papermap.html#s${section}">§${section}</a>`],
      [/\[([^\]]+)\]\(([^)\s]+\.md(?:#[\w.-]+)?|#[\w.-]+)\)/g, (i, label, target) =>
        `<a href="${this.link(target, i)}">${this.asHtml(label, i)}</a>`],
    ].map(([rule, make]) => [rule, (i, ...found) => keep(make(start + i, ...found))]);
    return cut(text, rules).map(({words, done}) => done ?? words.replace(/(?<=[\p{L}\d])'/gu, '’')).join('');
  }

  // A caption or a label: all of it is made HTML here.
  asHtml(text, index) {
    const parts = [];
    const kept = this.inline(text, index, (html) => `\uE002${parts.push(html) - 1}\uE003`);
    return escape(kept)
        .replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>').replace(/\*([^*]+)\*/g, '<em>$1</em>')
        .replace(/\[([^\]]+)\]\((https?:[^)\s]+)\)/g, '<a href="$2">$1</a>')
        .replace(/\uE002(\d+)\uE003/g, (_, n) => parts[n]);
  }

  figure(alternative, target, caption, index) {
    const name = /^\{#([\w-]+)\}\s*/.exec(caption)?.[1] ?? basename(target, '.svg');
    const path = fromRoot(resolve(dirname(this.source), target));
    shown.figures.push({path, page: this.id});
    if (alternative.length < 20) complain(this.where(index), `the figure ${name} needs an alternative text that tells what is seen`);
    const svg = this.attempt(index, () => this.pictures(path, `${this.id}-${name}`.replaceAll('_', '-'), alternative));
    const words = this.asHtml(caption.replace(/^\{#[\w-]+\}\s*/, '').replace(/\s*\n\s*/g, ' '), index);
    return blockToken(`<figure id="figure-${name}">${svg}<figcaption><b>Figure&nbsp;${this.figureNumber(name, index)}.</b> ${words}</figcaption></figure>`);
  }

  // The picture, and, where the chapter draws it moving as well, that one: the style sheet shows one of the two.
  pictures(path, prefix, alternative) {
    const moving = path.replace(/\.svg$/, '-animated.svg'), still = inlineFigure(path, prefix, alternative);
    if (!existsSync(join(root, moving))) return still;
    shown.figures.push({path: moving, page: this.id});
    return still.replace('<svg', '<svg class="rests"') +
           inlineFigure(moving, prefix + '-moves', alternative).replace('<svg', '<svg class="moves"');
  }

  equation(tex, index) {
    const tag = /\\tag\{([^}]+)\}/.exec(tex)?.[1];
    const set = this.set(tex.replace(/\\tag\{[^}]+\}/, '').trim(), index, true);
    if (!tag) return blockToken(`<div class="equation">${set}</div>`);
    if (shown.equations.has(tag)) complain(this.where(index), `equation (${tag}) stands twice`);
    shown.equations.set(tag, this.id);
    return blockToken(`<div class="equation" id="eq-${tag}">${set}<span class="tag">(${tag})</span></div>`);
  }

  listing(file, tag, folded, index) {
    const place = [join(root, 'common', file), join(root, 'chapters', file)].find(existsSync);
    if (!place) {
      complain(this.where(index), `there is no file ${file} to show`);
      return '';
    }
    shown.snippets.push({file: fromRoot(place), tag, page: this.id});
    const command = tag ? `\\snippet ${file} ${tag}` : `\\include ${file}`;
    const ownPage = otherPages.find((page) => page.folders?.some((folder) => dirname(file) === `first_contact/${folder}`));
    const anchor = `file-${basename(file).replaceAll('.', '-')}`, path = shownPath(fromRoot(place));
    if (!folded)
      return blockToken(`<div class="where">${ownPage ? `<a href="${ownPage.page}#${anchor}">${path}</a>` : path}</div>`) + command + '\n\n';
    const mark = this.id === ownPage?.id ? ` id="${anchor}"` : '';
    return blockToken(`<details class="listing${tag ? '' : ' whole'}"${mark}><summary>${this.asHtml(folded, index)} <span class="where">${path}</span></summary>`) +
           command + '\n' + blockToken('</details>');
  }

  // All files of parts of the library, folded: \files sweep/batch sweep/batch_loops
  files(stems, index) {
    return this.attempt(index, () => {
      const files = stems.trim().split(/\s+/).flatMap(filesOf);
      this.filesShown.push(...files);
      return blockToken(whereTold(files, shown.snippets)) + files.map((file) => this.listing(`first_contact/${file}`, '', `\`${basename(file)}\``, index)).join('');
    });
  }

  output(file, index) {
    shown.outputs.push({file, page: this.id});
    const path = join(root, 'chapters', file);
    const text = this.attempt(index, () => read(path).trimEnd());
    const lines = text.split('\n').map((line) => `<span class="line">${escape(line) || ' '}</span>`).join('\n');
    return blockToken(`<div class="where">${shownPath('chapters/' + file)}</div><pre class="output">${lines}</pre>`);
  }

  fence(language, body, index) {
    if (language !== 'sh') complain(this.where(index), 'code comes in by \\snippet alone; only sh may be typed');
    return blockToken(`<pre class="shell"><code>${escape(body.trimEnd())}</code></pre>`);
  }

  heading(level, title, index) {
    if (/[$`]/.test(title)) complain(this.where(index), 'a heading holds words alone, for contents and search');
    return `${'#'.repeat(level)} ${title} {#${this.id.replaceAll('_', '-')}-${slug(title)}}`;
  }

  // The blocks that are more than Markdown.
  blocks() {
    return cut(this.text, [
      [/^```(\w*)\n([\s\S]*?)^```$/gm, (i, language, body) => this.fence(language, body, i)],
      [/^<!-- run ([\w-]+): (.+?) -->$/gm, (i, name, line) => this.attempt(i, () => runNamed(name, line))],
      [/<!--[\s\S]*?-->/g, () => ''],
      [/^\$\$\s*([\s\S]+?)\$\$$/gm, (i, tex) => this.equation(tex, i)],
      [/^!\[([^\]]*)\]\(([^)\s]+\.svg)\)\n((?:.+\n?)*)/gm, (i, alternative, target, caption) =>
        this.figure(alternative, target, caption.trim(), i)],
      [/^\\snippet (\S+) (\S+)$/gm, (i, file, tag) => this.listing(file, tag, '', i)],
      [/^\\folded (\S+)(?: ([\w-]+))? \| (.+)$/gm, (i, file, tag, title) => this.listing(file, tag, title, i)],
      [/^\\files (.+)$/gm, (i, stems) => this.files(stems, i)],
      [/^\\output (\S+)$/gm, (i, file) => this.output(file, i)],
      [/^<details>$/gm, () => blockToken('<details class="answer">')],
      [/^<\/details>$/gm, () => blockToken('</details>')],
      [/^<summary>(.*)<\/summary>$/gm, (i, title) => blockToken(`<summary>${this.asHtml(title, i)}</summary>`)],
      [/^\{\{([\w-]+)!\}\}$/gm, (i, name) => blockToken(this.attempt(i, () => this.made(name)))],
      [/^(#{2,4}) (.+)$/gm, (i, marks, title) => this.heading(marks.length, title, i)],
    ]);
  }

  made(name) {
    if (!this.generated?.[name]) throw new Error(`there is nothing made by the name ${name}`);
    return this.generated[name];
  }

  body() {
    for (const [, target, caption] of this.text.matchAll(/^!\[[^\]]*\]\(([^)\s]+\.svg)\)\n(.*)/gm))
      this.figures.push(/^\{#([\w-]+)\}/.exec(caption)?.[1] ?? basename(target, '.svg'));
    return this.blocks().map(({words, index, done}) => done ?? this.inline(words, index, inlineToken)).join('');
  }
}

/// A sentence from one of the data files as HTML. \param file  where it stands, for complaints
export const prose = (text, file) => new Page(file, join(docs, 'pages', file), null, text).asHtml(text, 0);

/// One page for Doxygen. \param head  its title, and the HTML that follows it; \param foot  the HTML at its end
export function weave({id, source, chapter, title, folders, head = '', foot = '', generated = {}}) {
  const page = new Page(id, source, chapter);
  page.generated = generated;
  const first = /^# (.+)\n/.exec(page.text);
  if (first?.[1] !== title) complain(`${page.name}:1`, `the first line must be "# ${title}"`);
  typedNumbers(page.text, (index, number) =>
    complain(page.where(index), `${number} is typed by hand: look it up, {{program.name}}, or say why not, {{typed ${number} | reason}}`));
  page.text = page.text.replace(/^# .+\n/, '\n');
  const label = id === 'index' ? '{#mainpage}' : `{#${id.replaceAll('_', '-')}}`;
  const body = page.body();
  if (folders) checkPage({folders, source}, page.filesShown);
  return `# ${title} ${label}\n${head && blockToken(head)}\n${body}\n${foot && blockToken(foot)}\n`;
}
