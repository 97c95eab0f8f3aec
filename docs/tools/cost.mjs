// What code costs, counted in the very listing: {{cost dot product: first_contact/sweep/sphere_plane.cpp sweep_sphere_plane}}
// becomes "two dot products". So an essay cannot go on telling what the code no longer does.
import {codeFile, read} from './book.mjs';
import {counted} from './words.mjs';

const kinds = {
  'dot product': /\b(?:dot|squared_norm|squaredNorm|signed_distance)\(/g,
  'cross product': /\b(?:accurate_)?cross\(/g,
  multiplication: / \*=? /g,
  division: / \/=? /g,
  root: /\b(?:sqrt|norm|normalized|stableNorm)\(/g,
};

/// The code between the two lines of its tag, without comments and texts.
export function codeOf(file, tag) {
  const place = codeFile(file);
  const part = place && read(place).split(new RegExp(`^\\s*//! \\[${tag}\\]$`, 'm'))[1];
  if (!part) throw new Error(`there is no code ${file} ${tag} to count in`);
  return part.replace(/\/\/.*$/gm, '').replace(/"(?:[^"\\]|\\.)*"/g, '""');
}

// What is done each time: the lines of the first loop up to its first question.
const inLoop = (code) => /\bfor \(.*\{\n([\s\S]*?)\n\s*if /.exec(code)?.[1] ?? '';

/// The words for "KIND: FILE TAG"; of several listings, "KIND: FILE TAG, FILE TAG", the sum. "KIND in loop: ..."
/// counts what is done each time.
export function cost(body) {
  const [whole, listings = ''] = body.split(/:\s*/), kind = whole.replace(/ in loop$/, '');
  if (!kinds[kind]) throw new Error(`cost ${kind}: must be one of ${Object.keys(kinds).join(', ')}`);
  const part = whole === kind ? (code) => code : inLoop;
  const count = listings.split(/,\s*/).map((listing) => part(codeOf(...listing.trim().split(/\s+/))).match(kinds[kind])?.length ?? 0)
      .reduce((sum, each) => sum + each, 0);
  if (count === 0 && kind !== 'root') throw new Error(`cost ${body}: there is none`);
  return counted(count, kind);
}
