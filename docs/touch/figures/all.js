// Every figure to touch, by the name that an essay calls it by.
export {angleDemo as 'angle-demo'} from './angle_demo.js';
export {box} from './box.js';
export {bunny} from './bunny.js';
export {deCasteljau as 'de-casteljau'} from './de_casteljau.js';
export {fromAfar as 'from-afar'} from './from_afar.js';
export {frustum} from './frustum.js';
export {fastTree as 'fast-tree'} from './fast_tree.js';
export {film} from './film.js';
export {generalSphere as 'general-sphere'} from './general_sphere.js';
export {hitTest as 'hit-test'} from './hit_test.js';
export {movingSpheres as 'moving-spheres'} from './moving_spheres.js';
export {partitioning} from './partitioning.js';
export {plane} from './plane.js';
export {slide} from './slide.js';
export {terrain} from './terrain.js';
export {tweenBounce as 'tween-bounce'} from './tween_bounce.js';
