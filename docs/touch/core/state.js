// What a reader may change: parameters with a start, a range and two steps; and the state as a part of the address.

const decimals = (step) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/// A number: {start, least, most, step, fine}. The arrows go by `step`, with Shift by `fine`, and so does a drag.
export const number = (start, {least, most, step, fine = step}) => ({start, least, most, step, fine});
/// Something that is on, 1, or off, 0.
export const toggle = (start) => ({...number(start, {least: 0, most: 1, step: 1}), isToggle: true});
/// One of several, by its number from 0; the words name each.
export const choice = (start, {length}) => ({...number(start, {least: 0, most: length - 1, step: 1}), isChoice: true});
/// A place in the plane: {start: [x, y], least: [x, y], most: [x, y], step, fine}; with `from` the way from another place
/// to it, such as a velocity; that place is a parameter, or [x, y]. With `frame`, which makes {base, unit} of the state, it
/// is counted from there, in those units. It is moved in the figure's picture of the number `view`.
export const place = (start, {least, most, step = 0.1, fine = 0.01, from, frame, view = 0}) =>
  ({start, least, most, step, fine, from, frame, view, isPlace: true});

/// Numbers that are the library's, to the last bit: where a step ended is where the next one begins.
export const exact = (start, {least, most}) => ({start, least, most, isExact: true});

//! [clamped]
const within = (value, least, most, step) =>
  Number((Math.round(Math.min(most, Math.max(least, value)) / step) * step).toFixed(decimals(step))) + 0;  // and no -0

/// The value nearest to the wished one that the parameter may have.
export function clamped({least, most, fine, isPlace, isExact}, wished) {
  if (isExact) return wished.map((each, i) => Math.min(most[i], Math.max(least[i], each)));
  if (isPlace) return wished.map((each, i) => within(each, least[i], most[i], fine));
  return within(wished, least, most, fine);
}
//! [clamped]

/// The state at the beginning.
export const startOf = (parameters) =>
  Object.fromEntries(Object.entries(parameters).map(([name, {start}]) => [name, start]));

//! [fragment]
/// "#touch-plane:from=-0.9,2.1;radius=0.7"
export const fragmentOf = (id, state) =>
  `#${id}:` + Object.entries(state).map(([name, value]) => `${name}=${value}`).join(';');
//! [fragment]

// An address that somebody has cut or mistyped asks for nothing.
function decoded(fragment) {
  try {
    return decodeURIComponent(fragment);
  } catch {
    return '';
  }
}

const isNumber = (text) => /^-?\d+(\.\d+)?(e[+-]?\d+)?$/.test(text) && Number.isFinite(+text);

/// The state that an address asks for; what it does not say, or says wrongly, is as at the start.
export function stateFrom(fragment, id, parameters) {
  const state = startOf(parameters), [own, said = ''] = decoded(fragment).split(':');
  if (own !== `#${id}`) return undefined;
  for (const part of said.split(';')) {
    const [name, text = ''] = part.split('='), numbers = text.split(',');
    const parameter = Object.hasOwn(parameters, name) && parameters[name];
    if (!parameter || !numbers.every(isNumber)) continue;
    const {start} = parameter, values = numbers.map(Number), several = Array.isArray(start);
    if (values.length === (several ? start.length : 1)) state[name] = clamped(parameter, several ? values : values[0]);
  }
  return state;
}

/// A number for a reader: four significant digits, a true minus.
export function shown(value) {
  if (value === undefined) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : value < 0 ? '−∞' : '–';
  const text = String(Number(value.toPrecision(4)));
  const [, mantissa, power] = /^(.*?)(?:e([+-]\d+))?$/.exec(text);
  return (mantissa + (power ? ` × 10^${+power}` : '')).replaceAll('-', '−');
}
