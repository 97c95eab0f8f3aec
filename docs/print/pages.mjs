// On which page things are, as Chromium's PDF tells it.
import {readFileSync} from 'node:fs';
import {parts} from './parts.mjs';

/// On which page of a PDF each of its named places is, and how many pages it has. Chromium writes both lists in plain text.
export function pagesOf(file) {
  const objects = new Map([...readFileSync(file, 'latin1').matchAll(/^(\d+) 0 obj\n(<<[^]*?)\nendobj/gm)].map(([, id, body]) => [id, body]));
  const references = (text) => [...text.matchAll(/(\d+) 0 R/g)].map(([, id]) => id);
  const leaves = (id) => {
    const kids = /\/Kids \[([^\]]*)\]/.exec(objects.get(id))?.[1];
    return kids ? references(kids).flatMap(leaves) : [id];
  };
  const catalog = [...objects.values()].find((body) => body.includes('/Type /Catalog'));
  const [, tree] = /\/Pages (\d+) 0 R/.exec(catalog), [, names] = /\/Dests (\d+) 0 R/.exec(catalog);
  const order = leaves(tree);
  return {count: order.length,
          places: new Map([...objects.get(names).matchAll(/\/(\S+) \[(\d+) 0 R/g)].map(([, name, id]) => [name, order.indexOf(id) + 1]))};
}

/// The parts before which a page is left empty, so that each that opens on the right does. \param blanks  those of the last print
export function blanksFor({count, places}, blanks) {
  if (!places.size) return new Set();
  const opening = parts.filter(({under}) => !under), result = new Set();
  const start = (i) => i < opening.length ? places.get(opening[i].id) - blanks.has(opening[i].id) : count + 1;
  let page = start(0);
  opening.forEach((part, i) => {
    if (part.onRight && page % 2 === 0) {
      result.add(part.id);
      ++page;
    }
    page += start(i + 1) - places.get(part.id);
  });
  return result;
}
