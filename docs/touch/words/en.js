// Every word of the figures to touch, in English.
export const words = {
  all: {
    reset: 'Reset', play: 'Play', pause: 'Pause', link: 'A link to this scene', run: 'Run this',
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
};
