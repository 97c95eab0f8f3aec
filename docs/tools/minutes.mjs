// How long a chapter takes to read, from what stands in it: its words, its formulas, and the lines of its open listings.
import {existsSync} from 'node:fs';
import {codeOf} from './cost.mjs';
import {read} from './book.mjs';

const wordsAMinute = 150, linesAMinute = 25, formulasAMinute = 2;
const notRead = [/<!--[\s\S]*?-->/g, /^<details>[\s\S]*?^<\/details>$/gm, /^\*\*Ask yourself.*$/gm, /^\*\*To search for.*$/gm, /^\$\$[\s\S]+?\$\$$/gm, /^\\.*$/gm, /^```[\s\S]*?^```$/gm, /^!\[.*$/gm];

function linesOf(text) {
  const listings = [...text.matchAll(/^\\snippet (\S+) (\S+)$/gm)];
  return listings.reduce((sum, [, file, tag]) => sum + codeOf(file, tag).split('\n').filter((line) => line.trim()).length, 0);
}

/// How many words a text has, without formulas, listings, questions on the way, answers, and what pictures show.
export const wordsOf = (text) =>
  notRead.reduce((rest, part) => rest.replace(part, ''), text).match(/[\p{L}\d]+/gu).length;

/// To the nearest five minutes.
export function minutesOf({original}) {
  if (!existsSync(original)) return 0;
  const text = read(original), words = wordsOf(text), formulas = text.match(/^\$\$/gm)?.length ?? 0;
  return 5 * Math.max(1, Math.round((words / wordsAMinute + linesOf(text) / linesAMinute + formulas / formulasAMinute) / 5));
}
