// Every figure to touch, by the name that an essay calls it by.
export {plane} from './plane.js';
