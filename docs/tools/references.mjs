// References within one page: to ids in double quotes, as we write them, and in single ones, as gnuplot does.

/// Every id and name that something on the page may refer to.
export const idsOf = (page) => new Set([...page.matchAll(/\s(?:id|name)=(["'])([^"']+)\1/g)].map(([, , id]) => id));

// What a page refers to within itself: links, drawings used again, and what is filled, clipped or masked by something.
const targets = (page) => [...page.matchAll(/\s(?:xlink:)?href=(["'])#([^"']+)\1/g), ...page.matchAll(/(url\()#([^)]+)\)/g)]
    .map(([, , target]) => decodeURIComponent(target));

/// What a page refers to and does not have, each once.
export const unresolvedIn = (page, ids) => [...new Set(targets(page).filter((target) => !ids.has(target)))];
