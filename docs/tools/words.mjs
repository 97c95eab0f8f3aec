// What the tools themselves say on a page, in the language of the edition: docs/strings.json has all of it.
import {complain, data, language} from './book.mjs';

const strings = data('strings.json'), words = strings[language];

for (const [name, others] of Object.entries(strings))
  for (const key of new Set([...Object.keys(strings.en), ...Object.keys(others)]))
    if (!(key in others) || !(key in strings.en)) complain('docs/strings.json', `"${key}" is not said in each language: ${name}`);

/// The words of that name, or of [a list's name, and the place in it]; what is given stands in the places of {}.
export const say = (name, ...given) => {
  const [list, place] = [name].flat(), found = place === undefined ? words[list] : words[list]?.[place];
  if (found === undefined) throw new Error(`docs/strings.json has no "${name}"`);
  return given.reduce((text, each) => text.replace('{}', () => each), found);
};

/// "no roots", "one division", "two dot products"
export function counted(count, kind) {
  const form = words.count[count] ?? words.count[2].replace(/^\S+?(?=[ {次])/, count);
  return form.replace('{}', say(kind));
}

/// What a script of the page says.
export const scriptWords = () =>
  Object.fromEntries(['copy', 'copied', 'copy this', 'pause', 'play', 'pause or play'].map((name) => [name, say(name)]));
