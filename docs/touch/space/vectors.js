// Three numbers each.

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/// So much of the way from one place to the other.
export const along = (from, to, part) => from.map((each, i) => each + part * (to[i] - from[i]));
export const distance = (a, b) => Math.hypot(...minus(a, b));
export const unit = (a) => along([0, 0, 0], a, 1 / Math.hypot(...a));
