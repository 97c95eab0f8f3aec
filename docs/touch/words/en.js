// Every word of the figures to touch, in English.
const partOf = (time, way) => `${way} of the way after ${time} of the time`;

export const words = {
  all: {
    reset: 'Reset', play: 'Play', pause: 'Pause', link: 'A link to this scene', run: 'Run this',
    lacks: (what) => `this figure cannot be shown here (${what}).`,
    place: (x, y) => `across ${x}, up ${y}`,
  },

  plane: {
    title: 'A ball and a floor, to be moved',
    caption: `<b>To touch.</b> Drag both ends of the motion, and the floor by its points <i>P</i> and <i>Q</i>; or reach them by
      the Tab key, and move them by the arrows, with Shift by small steps. Rings show the ball in each frame of a film: ask
      only there, and with few frames a ball goes through the floor.`,
    from: 'S 0, the centre at the start', to: 'S 1, the centre at the end',
    p: 'P, a point of the floor', q: 'Q, another point of the floor',
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    frames: {html: 'frames', spoken: 'frames of the film'},
    length: {html: '|<b>N</b>|, as printed', spoken: 'length of the normal in the formula as printed'},
    center: 'S(t)', gap: 'gap', frame: 'first frame', printed: '<i>t</i>, as printed',
    touches: (gap, t, x, z) => `The gap is ${gap}. The ball touches the floor at <i>t</i> = ${t}, in the point (${x}, ${z}).`,
    free: (gap) => `The gap is ${gap}. The ball does not touch the floor on its way.`,
    tunnels: `No frame shows them together: asked there alone, the ball has gone through.`,
    seen: (first, count) => `Of ${count} frames, number ${first} is the first to show them together.`,
  },

  frustum: {
    title: 'A plank and what a camera sees, from above',
    caption: `<b>To touch.</b> Drag the plank by its centre <b>Q</b>, and turn it. For each plane of the frustum its highest point is told,
      <b>E</b> · <b>Q</b> + <i>r</i><sub>eff</sub>: below 0 all of the plank is behind that plane, and it is rejected. Pink is the plane
      that it is farthest behind. Off an edge a plank that nobody sees is kept.`,
    plank: 'Q, the centre of the plank', turn: {html: 'turn', spoken: 'turn of the plank in degrees'},
    left: 'left', right: 'right', lower: 'lower', upper: 'upper', near: 'near', far: 'far',
    verdict: 'the plank is', rejected: 'rejected', kept: 'kept',
    behind: (side, depth) => `The plank is rejected: its highest point is ${depth} behind the ${side} plane.`,
    before: (side, height) => `The plank is kept: over each plane something of it is in front, over the ${side} plane ${height}.`,
  },

  partitioning: {
    title: 'A ball among walls, and what a tree lets it leave out',
    caption: `<b>To touch.</b> Drag both ends of the path, and choose a tree. Each part that the search goes into has an orange rim, and is
      tinted if it is cut no more; the rest it leaves out. In a plane the octree is a quadtree: the upper four of eight children are
      empty, and looked at too. A wall is in the square of its middle, so its box may reach into others.`,
    from: 'where the ball starts', to: 'where it ends if it touches none',
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    tree: {spoken: 'which tree', choices: ['quadtree', 'BSP tree', 'tree of boxes']},
    work: (nodes, tests) => `${nodes} nodes, ${tests} tests`,
    touches: (wall, t) => `The ball touches wall ${wall} first, at <i>t</i> = ${t}.`,
    free: 'The ball touches no wall on its way.',
    takes: (tree, nodes, tests, all) => `The ${tree} looks at ${nodes} nodes, and tests ${tests} of ${all} walls.`,
  },

  'hit-test': {
    title: 'A leaf, a hook and a pointer on a stage',
    caption: `<b>To touch.</b> Drag the pointer, the leaf and the hook. <code>hitTestPoint</code> asks the box of the leaf or, with its flag,
      the leaf itself: a ray to the right counts how often it crosses the outline. <code>hitTestObject</code> asks the two boxes, and
      green is what it cannot tell.`,
    pointer: 'the pointer', leaf: 'the corner of the leaf', hook: 'the corner of the hook',
    crossings: 'crossings', shapes: 'the shapes', whether: (is) => is ? 'true' : 'false',
    inside: (count) => `The pointer is in the leaf: its ray crosses the outline ${count === 1 ? 'once' : `${count} times`}, an odd number.`,
    inBox: (count) => `The pointer is in the box of the leaf and not in the leaf: its ray crosses the outline ${
      count === 0 ? 'nowhere' : count === 2 ? 'twice' : `${count} times`}.`,
    outside: 'The pointer is outside the box of the leaf.',
    meet: 'The two shapes touch.', boxesMeet: 'The two boxes overlap, and the shapes do not.', apart: 'The two boxes are apart.',
  },

  'moving-spheres': {
    title: 'Two moving balls, in the world and as seen from Q',
    caption: `<b>To touch.</b> Drag both ends of both motions, in the world. The other picture is the same seen from <i>Q</i>: a point
      that begins at <b>w</b> and moves by <b>u</b>, and a ball of radius <i>d</i> at rest. Where the discriminant is negative,
      its line passes by.`,
    p1: 'P 1, the centre of P at the start', p2: 'P 2, the centre of P at the end',
    q1: 'Q 1, the centre of Q at the start', q2: 'Q 2, the centre of Q at the end',
    rp: {html: 'radius <i>r<sub>P</sub></i>', spoken: 'radius of P'},
    rq: {html: 'radius <i>r<sub>Q</sub></i>', spoken: 'radius of Q'},
    time: {html: 'time <i>t</i>', spoken: 'time t'},
    world: 'the world', fromQ: 'seen from Q', now: 'distance at <i>t</i>', closest: 'least distance', at: 'at',
    discriminant: 'discriminant',
    meets: (t, parts) => `The balls meet at <i>t</i> = ${t}, and would part at ${parts}.`,
    passes: 'The balls never meet: the discriminant is negative.',
    later: 'The balls do not meet within this motion.',
    distance: (t, distance, d) => `At <i>t</i> = ${t} their centres are ${distance} apart; they touch at ${d}.`,
  },

  'angle-demo': {
    title: 'Two discs and their impact',
    caption: `<b>To touch.</b> Drag the discs and the tips of their velocities, and play. Red is before; green what happens: the
      discs meet, and part by the normal at contact; pink is program 4 as printed: the velocities change at once, by the normal
      at the start, whether the discs meet or not.`,
    p1: 'P 1, the place of disc 1', v1: 'tip of velocity 1', p2: 'P 2, the place of disc 2', v2: 'tip of velocity 2',
    mass1: {html: 'mass <i>m</i><sub>1</sub>', spoken: 'mass of disc 1'},
    mass2: {html: 'mass <i>m</i><sub>2</sub>', spoken: 'mass of disc 2'},
    restitution: {html: 'restitution <i>e</i>', spoken: 'restitution e'},
    radius: {html: 'radius <i>r</i>', spoken: 'radius of both discs'},
    time: {html: 'time <i>t</i>', spoken: 'time t'},
    energy: 'energy', momentumX: 'momentum, <i>x</i>', momentumY: 'momentum, <i>y</i>',
    velocities: 'velocities after',
    meets: (t) => `The discs meet at <i>t</i> = ${t}.`,
    misses: 'The discs never meet.',
    printedToo: 'Program 4 has them collide as well, from where they start.',
    printedAlone: 'Program 4 has them collide all the same: they come nearer.',
    printedNot: 'Program 4 finds no collision.',
  },

  slide: {
    title: 'A ball that slides along the ground and a second wall',
    caption: `<b>To touch.</b> Drag both ends of the wish, and the top of the second wall, which changes the angle between the two.
      Grey are the ways that one wall alone would let it go on; green is the way taken, which leads into none. Pink is where the
      ball ends if each wall forgets the one before.`,
    p1: 'P 1, the centre at the start', p2: 'P 2, where the ball is sent', wall: 'the top of the second wall',
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    contacts: 'contacts', end: 'ends at', other: 'wall after wall',
    meets: (count) => `The ball meets a wall ${count === 1 ? 'once' : count === 2 ? 'twice' : `${count} times`}`,
    arrives: (end) => `and slides on to ${end}.`,
    stands: (end) => `and stands at ${end}: every way on leads into a wall, or back.`,
    free: 'The ball meets nothing on its way.',
  },

  terrain: {
    title: 'A ball that is steered over a terrain',
    caption: `<b>To touch.</b> Steer the ball by the arrow keys, or hold it and point where it is to go; drag the ground to turn it.
      Each step is a slide. Red is the wish, with the pull downwards; green the way that was made, both five times as long as
      they are; the others are the normals of what the ball met.`,
    wish: 'the ball: the arrows steer it',
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'}, pull: {html: 'pull downwards', spoken: 'pull downwards in each step'},
    turn: {html: 'turn, degrees', spoken: 'turn of the view, in degrees'},
    tilt: {html: 'seen from above, degrees', spoken: 'height of the view, in degrees'},
    contacts: 'contacts', triangle: 'triangle', end: 'ends at',
    meets: (count) => `In the last step the ball met the ground ${count === 1 ? 'once' : count === 2 ? 'twice' : `${count} times`}.`,
    free: 'In the last step the ball met nothing.', stands: (end) => `It is at (${end}).`,
  },

  'from-afar': {
    title: 'A ball that comes from afar at a vertex, in floats and in doubles',
    caption: `<b>To touch.</b> Send the ball from ever farther away, in powers of ten, and aim it beside the vertex. Green is where it touches;
      pink where the root as multiplied out puts it in floats, in which most games compute: Δ is the difference of two giants,
      <i>b</i>² and <i>a</i> <i>c</i>, and from far away nothing of it is left but their rounding.`,
    power: {html: 'from 10<sup><i>x</i></sup> radii', spoken: 'power of ten of the distance, in radii'},
    beside: {html: 'aimed beside', spoken: 'how far beside the vertex it is aimed, in radii'},
    minusB: '&minus;<i>b</i>, float', root: '√Δ, float', floatPrinted: '<i>t</i>, float',
    floatStable: '<i>t</i>, closest approach, float',
    doublePrinted: '<i>t</i>, double', doubleStable: '<i>t</i>, closest approach, double', none: 'no hit',
    apart: (off) => `In floats the multiplied-out root puts the ball ${off} radii from where it touches.`,
    lost: 'In floats the multiplied-out root finds no hit: under it is less than nothing.',
    misses: 'The ball passes the vertex by.',
  },

  'de-casteljau': {
    title: 'A curve of four control points, made by cutting corners',
    caption: `<b>To touch.</b> Drag the four control points, and go along the curve. Each line is gone along by the same part, and its
      point is an end of the next line. With constant speed the part is one of the curve's length: dots that crowd are then evenly spaced.`,
    a: 'the first control point', b: 'the second control point', c: 'the third control point', d: 'the last control point',
    part: {html: 'part <i>s</i>', spoken: 'part of the curve, s'},
    even: {html: 'constant speed', spoken: 'constant speed'},
    length: 'length', speed: 'speed at <i>s</i>', parameter: 'parameter at <i>s</i> of the length',
    at: (x, y, s, length) => `The curve is ${length} long. At ${s} of its parameter it is at (${x}, ${y}).`,
    evenly: (x, y, s, length, parameter) => `The curve is ${length} long. At ${s} of its length its parameter is ${parameter}, and it is at (${x}, ${y}).`,
  },

  'tween-bounce': {
    title: 'The ball of programs 1 to 3: its height over time',
    caption: `<b>To touch.</b> Throw the ball, play, and freeze it at any time, as the paper does with Ctrl-C. Pink is the path as
      printed, green that of a ball that obeys gravity. The paper then puts the word <span lang="zh-Hant">軌跡</span>, path, where one points: here
      by the right button, or by its handle.`,
    v0: {html: 'speed down <i>v</i><sub>0</sub>', spoken: 'speed down at the start, v 0'},
    y0: {html: 'height <i>y</i><sub>0</sub>', spoken: 'height at the start, y 0'},
    g: {html: 'gravity <i>g</i>', spoken: 'gravity g'},
    restitution: {html: 'restitution <i>e</i>', spoken: 'restitution e'},
    dt: {html: 'step Δ<i>t</i>', spoken: 'time from sample to sample'},
    time: {html: 'time <i>t</i>', spoken: 'time t'},
    label: 'the place of the word 軌跡, path', path: '軌跡',
    height: 'height at <i>t</i>', hit: 'first hit', speed: 'speed there', top: 'top of the rebound',
    hits: (printed, t1) => `As printed the ball hits the floor at <i>t</i> = ${printed}; if it obeys gravity, at ${t1}.`,
    never: 'As printed the ball does not hit the floor.',
    frozen: (t, printed, truth) => `At <i>t</i> = ${t} it is ${printed} high as printed, and ${truth} if it obeys.`,
  },

  film: {
    title: 'A film of three keys, a floor and a box',
    caption: `<b>To touch.</b> Drag the keys and the box, and play. Dashed is the plan, red what becomes of it: the path is tested
      first, and each contact turns aside what is left. On the time line, to the right or below, drag key 1 to another time, and the curve
      of each easing by its two points. Each contact is marked when it comes.`,
    key0: 'K 0, the place of key 0', key1: 'K 1, the place of key 1', key2: 'K 2, the place of key 2',
    box: 'the middle of the box', time1: 'K 1 on the time line, the time of key 1',
    in1: 'first easing, the point at its start', out1: 'first easing, the point at its end',
    in2: 'second easing, the point at its start', out2: 'second easing, the point at its end',
    restitution: {html: 'restitution <i>e</i>', spoken: 'restitution e'},
    time: {html: 'time <i>t</i>', spoken: 'time t'},
    at: (there) => `It is at (${there}).`, said: {
      time1: (t) => `at the time ${t}`, in1: partOf, out1: partOf, in2: partOf, out2: partOf},
    contacts: 'contacts at', position: 'place at <i>t</i>', part: 'part of the way',
    met: (count, times, t) => count ? `Up to <i>t</i> = ${t} the ball touches ${count === 1 ? 'once' : count === 2 ? 'twice' :
      `${count} times`}, ${count > times.length ? 'first ' : ''}at ${times.join(', ')}.` : `Up to <i>t</i> = ${t} the ball touches nothing.`,
  },

  'general-sphere': {
    title: 'A ball and a solid with corners',
    caption: `<b>To touch.</b> Drag both ends of the path, and change the radius. The grey outline is the solid moved out: straight
      along the sides, round about the corners that point outwards. What is touched first lights up. Pink are the cylinders as
      printed, about the corners moved out, and the ball that stops at the first of them.`,
    from: 'S 0, the centre at the start', to: 'S 1, the centre at the end',
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    feature: 'touched', face: 'a side', edge: 'a corner', vertex: 'a vertex', cylinder: '<i>t</i>, cylinder as printed',
    touches: (what, t) => `The ball touches ${what} first, at <i>t</i> = ${t}.`,
    free: 'The ball touches nothing on its way.',
    stops: (t) => `As printed it is stopped by a cylinder at <i>t</i> = ${t}.`,
    noCylinder: 'It meets none of the cylinders as printed.',
  },

  bunny: {
    title: 'A rabbit, and a ball that is thrown at it',
    caption: `<b>To touch.</b> Drag the picture to turn the rabbit, and press where the ball is to go: a ray through the pointer, a ball
      of radius 0, finds the triangle that is seen there. The ball is thrown from the hand to that point, and the fast tree
      (Appendix A) finds what it meets first, which lights up, and the normal there. Microseconds are those of your machine.`,
    hand: 'the hand, where the ball starts', aim: 'where the ball is thrown', start: 'hand',
    turn: {html: 'turn, degrees', spoken: 'turn of the view, in degrees'},
    tilt: {html: 'seen from above, degrees', spoken: 'height of the view, in degrees'},
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    time: {html: 'time <i>t</i>', spoken: 'time t'},
    feature: 'touched', face: 'a face', edge: 'an edge', vertex: 'a vertex', triangle: 'triangle',
    opened: 'opened, of the tree', work: (nodes, leaves) => `${nodes} nodes, ${leaves} leaves`,
    takes: 'the sweep takes', micro: (count) => `${count} µs`,
    picks: (number) => `The ray picks triangle ${number}.`, picksNone: 'The ray passes the rabbit.',
    touches: (what, number, t) => `The ball touches ${what}, of triangle ${number}, at <i>t</i> = ${t}.`,
    free: 'The ball touches nothing on its way.',
  },

  'fast-tree': {
    title: 'One cast on its way through the fast tree',
    caption: `<b>To touch.</b> Move the slider of the steps, and the hand and the aim of the ball. A step looks into a node, whose children
      have boxes, or into a leaf with triangles. Green is what may be touched, pink what is dropped for good, blue what waits.
      After the last step the doubles have decided.`,
    hand: 'the hand, where the ball starts', aim: 'where the ball is thrown', start: 'hand',
    step: {html: 'step', spoken: 'step of the walk'},
    turn: {html: 'turn, degrees', spoken: 'turn of the view, in degrees'},
    tilt: {html: 'seen from above, degrees', spoken: 'height of the view, in degrees'},
    radius: {html: 'radius <i>r</i>', spoken: 'radius r'},
    at: 'step', of: (step, steps) => `${step} of ${steps}`, kept: 'may be touched', dropped: 'dropped', waiting: 'wait',
    triangle: 'triangle touched',
    begins: (steps) => `The walk begins at the root, and takes ${steps} steps.`,
    ends: (number, t) => `It is decided: triangle ${number} is touched, at <i>t</i> = ${t}.`,
    free: 'It is decided: nothing is touched.',
    nth: (step, steps) => `Step ${step} of ${steps}.`,
    node: (kept, dropped) => `A node: of its children ${kept} may be touched, ${dropped} are dropped.`,
    leaf: (kept, dropped) => `A leaf: of its triangles ${kept} may be touched, ${dropped} are dropped.`,
    waits: (count) => `On the stack ${count} wait.`,
  },

  box: {
    title: 'A box that is turned above a floor',
    caption: `<b>To touch.</b> Turn the box, and drag both ends of its way. Three bars, one for each axis, reach from the floor twice
      as high as the centre can come down: to the dashed plane. Turned one way alone the box lands on an edge, turned neither
      way on a face.`,
    from: 'Q 0, the centre at the start', to: 'Q 1, the centre at the end',
    lean: {html: 'turn about <i>x</i>, degrees', spoken: 'turn about x, in degrees'},
    turn: {html: 'turn about <i>y</i>, degrees', spoken: 'turn about y, in degrees'},
    lands: 'lands on', vertex: 'a vertex', edge: 'an edge', face: 'a face',
    reaches: (radius) => `To this floor the box is a ball of radius ${radius}.`,
    touches: (what, t, count) => `It lands on ${what} at <i>t</i> = ${t}, with ${count} point${count > 1 ? 's' : ''} of contact.`,
    free: 'It does not touch the floor on its way.',
  },
};
