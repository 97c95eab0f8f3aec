// References within one page: what may be referred to, and what is.

const attributesOf = (tree) => tree('*').toArray().flatMap(({attribs}) => Object.entries(attribs));

/// Every id on the page, as often as it is given.
export const idsOf = (tree) => attributesOf(tree).filter(([name]) => name === 'id').map(([, id]) => id);

/// Every id and name that something may refer to.
export const targetsOf = (tree) => new Set(attributesOf(tree).filter(([name]) => /^(id|name)$/.test(name)).map(([, target]) => target));

// Links, drawings used again, and what is filled, clipped or masked by something.
const referredTo = ([name, value]) => [...value.matchAll(/href$/.test(name) ? /^#(.+)/g : /url\(#([^)]+)\)/g)].map(([, id]) => id);

/// What a page refers to and does not have, each once.
export const unresolvedIn = (tree, targets = targetsOf(tree)) =>
  [...new Set(attributesOf(tree).flatMap(referredTo).map(decodeURIComponent))].filter((id) => !targets.has(id));
