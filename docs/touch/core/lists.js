// Lists as the library tells them.

const groups = (list, size) => list.flatMap((_, i) => i % size ? [] : [list.slice(i, i + size)]);

/// x, y, x, y, ... as [x, y], [x, y], ...
export const pairs = (list) => groups(list, 2);
/// The same in space.
export const threes = (list) => groups(list, 3);
/// A point of space, as one sees it from the front.
export const flat = ([x, , z]) => [x, z];
/// {0: a, 1: b} as [a, b]; nothing as an empty list.
export const listed = (list) => Object.values(list ?? {});
