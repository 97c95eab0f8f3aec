// The words of the essays: no term in the glossary that no chapter uses, none explained that it lacks; every symbol in
// the table of symbols; and the eight together no longer than they may be.
import {appendices, chapters, complain, docs, fromRoot, read} from '../tools/book.mjs';
import {firstOf, terms} from '../tools/glossary.mjs';
import {wordsOf} from '../tools/minutes.mjs';

const mostWords = 23600;  // of the eight essays, without the appendices
const pages = [...chapters, ...appendices].map((page) => ({...page, text: read(page.source)}));

const prose = (text) => text.replace(/<!--[^]*?-->/g, '').replace(/^\\.*$/gm, '').replace(/\s+/g, ' ');

function checkGlossary() {
  for (const term of terms)
    if (firstOf(term) === undefined) complain('docs/pages/glossary.md', `no chapter uses the term "${term.english}"`);
}

// "This is an *octree*", "is called a *ghost collision*": what is explained by its name, the glossary has.
function checkExplained() {
  const naming = /(?:\bcalled(?: an?| the)?|\bknown as(?: an?| the)?|\bname: it is(?: an?| the)?|\b[Tt]his is(?: an?| the)?) \*([^*]+)\*/g;
  for (const {source, text} of pages)
    for (const [, name] of prose(text).matchAll(naming))
      if (!terms.some(({pattern}) => pattern.test(name))) complain(fromRoot(source), `the glossary lacks the term "${name}"`);
}

const greek = 'alpha beta gamma delta Delta epsilon varepsilon theta varphi phi tau omega lambda mu sigma rho'.split(' ');
const counters = new Set('xyzin');  // coordinates, and what counts

// Bold letters and Greek ones; of other letters those in displayed formulas.
function symbolsIn(tex, isDisplayed) {
  const plain = tex.replace(/\{\{[^}]*\}\}|\\(?:text|tag|mathrm|operatorname|begin|end)\{[^}]*\}|\\mathsf T/g, ' ');
  const bold = [...plain.matchAll(/\\vec\s*\{?\s*([A-Za-z])/g)].map(([, letter]) => `vec ${letter}`);
  const rest = plain.replace(/\\vec\s*\{?\s*[A-Za-z]/g, ' ');
  const others = [...rest.matchAll(/\\([A-Za-z]+)/g)].map(([, name]) => name).filter((name) => greek.includes(name));
  const letters = isDisplayed ? rest.replace(/\\[A-Za-z]+/g, ' ').match(/[A-Za-z]/g) ?? [] : [];
  return [...bold, ...others, ...letters.filter((letter) => !counters.has(letter))];
}

const symbolsOf = (text) => new Set([...text.matchAll(/\$\$([^]+?)\$\$|\$([^$]+)\$/g)]
    .flatMap(([, displayed, inline]) => symbolsIn(displayed ?? inline, displayed !== undefined)));

function checkSymbols() {
  const table = read(docs, 'pages/symbols.md'), inTable = table.replace(/\$([^$]+)\$/g, '$$$$$1$$$$');
  const known = symbolsOf(inTable);
  for (const {source, text} of pages)
    for (const symbol of symbolsOf(text))
      if (!known.has(symbol)) complain(fromRoot(source), `the table of symbols lacks ${symbol}`);
  return known.size;
}

export function checkWords() {
  checkGlossary();
  checkExplained();
  const symbols = checkSymbols(), words = chapters.reduce((sum, chapter) => sum + wordsOf(read(chapter.source)), 0);
  if (words > mostWords) complain('the essays', `${words} words: must be ${mostWords} at most`);
  return `${words} words of ${mostWords}, ${terms.length} terms, ${symbols} symbols`;
}
