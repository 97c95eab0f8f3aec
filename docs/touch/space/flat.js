// The same picture where there is no graphics card: all is laid flat upon a canvas and painted, the farthest first. A face
// that is turned away is not seen; so of a ball and a face that one is hidden which is behind the plane of the face.
import {threes} from '../core/lists.js';
import {Bodies, brightest, darkest, lampOf} from './bodies.js';
import {along, cross, distance, dot, minus, unit} from './vectors.js';

const shades = 64, tiny = 1e-6;
const piece = 0.5;  // of a bar, in the mesh's unit: near and far pieces are painted each in its turn
const beyond = 0.7;  // of a pixel: so far a face is painted over its corners, or the paper would be seen between two
const thin = 0.5;  // a face that is seen from its side, by the cosine, is painted over its edges, too

// A face keeps what is found out about it for each picture: that is many faces, and done for each picture.
function facesOf({vertices, faces}) {
  const places = threes(vertices);
  return threes(faces).map((corners, number) => {
    const [a, b, c] = corners.map((i) => places[i]);
    return {number, corners, at: a, normal: unit(cross(minus(b, a), minus(c, a))),
            xs: [0, 0, 0], ys: [0, 0, 0], depths: [0, 0, 0], x: 0, y: 0, depth: 0, reach: 0};
  });
}

export class Flat extends Bodies {
  /// \param mesh  {vertices, faces}: the coordinates, three a vertex, and the vertices, three a face; and its colour
  constructor(canvas, mesh, {colour, opacity = 1}) {
    super(canvas);
    Object.assign(this, {places: threes(mesh.vertices), faces: facesOf(mesh), own: colour, opacity});
    Object.assign(this, {paper: canvas.getContext('2d'), tints: new Map()});
  }

  repaint() {
    super.repaint();
    this.tints.clear();
  }

  // A colour in the light that falls on it, from -1 to 1, as the page writes it.
  tint(name, light) {
    if (!this.tints.has(name)) {
      const bright = (shade) => darkest + (brightest - darkest) * shade / shades;
      this.tints.set(name, Array.from({length: shades + 1}, (_, shade) =>
        `rgb(${this.colour(name).map((each) => Math.min(255, Math.round(bright(shade) * each)))})`));
    }
    return this.tints.get(name)[Math.round(shades * (0.5 + 0.5 * light))];
  }

  // Where a place is seen: across and down in pixels, and how far towards the eye.
  seen(place) {
    const {pen: {view: {left, top}, scale}, view: {middle, right, up, eye}} = this, way = minus(place, middle);
    return [(dot(way, right) - left) * scale, (top - dot(way, up)) * scale, dot(way, eye)];
  }

  fill(style, path) {
    this.paper.fillStyle = style;
    this.paper.beginPath();
    path();
    this.paper.fill();
  }

  // Something whose middle is at that place.
  put(depth, at, paint) {
    this.things.push({depth, at, paint});
  }

  ball(center, radius, colour, opacity = 1) {
    const [x, y, depth] = this.seen(center), size = radius * this.pen.scale, {paper} = this;
    if (size === 0) return;
    this.put(depth, center, () => {
      const light = paper.createRadialGradient(x, y - 0.45 * size, 0, x, y - 0.45 * size, 1.45 * size);
      for (const part of [0, 0.25, 0.5, 0.75, 1]) light.addColorStop(part, this.tint(colour, 1 - 1.5 * part * part));
      paper.globalAlpha = opacity;
      this.fill(light, () => paper.arc(x, y, size, 0, 7));
      paper.globalAlpha = 1;
    });
    this.balls.push({center, radius, x, y, size, depth});
  }

  bar(from, to, radius, colour) {
    const count = this.opacity < 1 ? 1 : Math.ceil(distance(from, to) / piece), {paper} = this;
    for (let i = 0; i < count; ++i) {
      const ends = [i, i + 1].map((k) => along(from, to, k / count)), [a, b] = ends.map((each) => this.seen(each));
      this.put((a[2] + b[2]) / 2, along(...ends, 0.5), () => {
        Object.assign(paper, {strokeStyle: this.tint(colour, 0.6), lineWidth: 2 * radius * this.pen.scale});
        paper.beginPath();
        paper.moveTo(a[0], a[1]);
        paper.lineTo(b[0], b[1]);
        paper.stroke();
      });
    }
  }

  // A cone, seen from anywhere: its foot is an ellipse, and its tip is over it or beside.
  head(from, to, radius, colour) {
    const [[x, y, low], [tipX, tipY, high]] = [from, to].map((each) => this.seen(each)), size = radius * this.pen.scale;
    const angle = Math.atan2(tipY - y, tipX - x), narrow = Math.abs(high - low) / distance(from, to);
    const side = (sign) => [x - sign * size * Math.sin(angle), y + sign * size * Math.cos(angle)];
    this.put((low + high) / 2, along(from, to, 0.5), () => {
      this.fill(this.tint(colour, 0.2), () => this.paper.ellipse(x, y, narrow * size, size, angle, 0, 7));
      this.fill(this.tint(colour, 0.6), () => [[tipX, tipY], side(1), side(-1)].forEach((at) => this.paper.lineTo(...at)));
    });
  }

  /// Lights up a triangle of the mesh.
  triangle(number, colour) {
    this.lit.set(number, colour);
  }

  // Where a face is seen; whether it is within the picture.
  layFace(face, seen) {
    const {corners, xs, ys, depths} = face, {width, height} = this.pen;
    corners.forEach((corner, k) => { [xs[k], ys[k], depths[k]] = seen[corner]; });
    face.x = (xs[0] + xs[1] + xs[2]) / 3;
    face.y = (ys[0] + ys[1] + ys[2]) / 3;
    face.depth = (depths[0] + depths[1] + depths[2]) / 3;
    face.reach = Math.max(...xs.map((x, k) => Math.hypot(x - face.x, ys[k] - face.y)));
    return Math.abs(face.x - width / 2) < width / 2 + face.reach && Math.abs(face.y - height / 2) < height / 2 + face.reach;
  }

  // What is in a ball is seen through its front.
  throughBalls() {
    for (const thing of this.things)
      for (const {center, radius, depth} of this.balls)
        if (thing.at !== center && distance(thing.at, center) < radius) thing.depth = Math.min(thing.depth, depth - tiny);
  }

//! [is_behind]
  // Where a corner of a face is seen upon a ball, or its middle, the front of the ball is before it or behind; where none
  // is, the plane of the face tells: what is turned to the eye hides what is behind its plane, and nothing else.
  isBehind({xs, ys, depths, x, y, depth, normal, at}, ball) {
    for (const [a, b, itsDepth] of [[x, y, depth], ...xs.map((each, k) => [each, ys[k], depths[k]])]) {
      const off = Math.hypot(a - ball.x, b - ball.y) / ball.size;
      if (off < 1) return itsDepth < ball.depth + ball.radius * Math.sqrt(1 - off * off);
    }
    return dot(normal, minus(ball.center, at)) > 0;
  }
//! [is_behind]

  besideBall(face, ball) {
    const {x, y, size, depth} = ball;
    if (Math.abs(face.x - x) > size + face.reach || Math.abs(face.y - y) > size + face.reach) return;
    const isBehind = this.isBehind(face, ball);
    face.depth = isBehind ? Math.min(face.depth, depth - tiny) : Math.max(face.depth, depth + tiny);
  }

  // The faces that are turned to the eye, within the picture; what is lit is seen from behind, too, if one looks through.
  putFaces(faces) {
    const {eye} = this.view, isPale = this.opacity < 1, seen = this.places.map((place) => this.seen(place));
    for (const face of faces) {
      if (dot(face.normal, eye) <= 0 && !(isPale && this.lit.has(face.number)) || !this.layFace(face, seen)) continue;
      for (const ball of this.balls) this.besideBall(face, ball);
      this.things.push(face);
    }
  }

  paintFace({number, normal, x, y, xs, ys}, lamp) {
    const {paper} = this, style = this.tint(this.lit.get(number) ?? this.own, dot(normal, lamp));
    paper.fillStyle = style;
    paper.beginPath();
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [xs[k] - x, ys[k] - y], out = 1 + beyond / Math.max(1, Math.sqrt(a * a + b * b));
      paper.lineTo(x + out * a, y + out * b);
    }
    paper.fill();
    if (dot(normal, this.view.eye) > thin) return;
    Object.assign(paper, {strokeStyle: style, lineWidth: beyond});
    paper.stroke();
  }

  paintAll() {
    const lamp = lampOf(this.view);
    for (const thing of this.things.sort((one, other) => one.depth - other.depth))
      if (thing.paint) thing.paint();
      else this.paintFace(thing, lamp);
  }

  // A mesh that one looks through is painted first, and made paler.
  paintPale() {
    const {paper, pen: {width, height}, things} = this;
    this.things = [];
    this.putFaces(this.faces.filter(({number}) => !this.lit.has(number)));
    this.paintAll();
    paper.globalCompositeOperation = 'destination-out';
    this.fill(`rgb(0, 0, 0, ${1 - this.opacity})`, () => paper.rect(0, 0, width, height));
    paper.globalCompositeOperation = 'source-over';
    this.things = things;
    this.putFaces(this.faces.filter(({number}) => this.lit.has(number)));
  }

  /// Paints the mesh, and what `fill` adds to it.
  /// \param pen  how large the picture is, and what of the view it shows
  /// \param view  {middle, eye, right, up}
  show(pen, view, fill) {
    Object.assign(this, {pen, view, things: [], balls: [], lit: new Map()});
    this.fit(pen);
    fill(this);
    this.throughBalls();
    if (this.opacity < 1) this.paintPale();
    else this.putFaces(this.faces);
    this.paintAll();
  }

  fit({width, height}) {
    const {canvas, paper} = this, [wide, high] = [width, height].map((each) => Math.round(each * devicePixelRatio));
    if (canvas.width !== wide || canvas.height !== high) {
      Object.assign(canvas, {width: wide, height: high});
      Object.assign(canvas.style, {width: `${width}px`, height: `${height}px`});
    }
    paper.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    Object.assign(paper, {lineCap: 'round', lineJoin: 'bevel'});
    paper.clearRect(0, 0, width, height);
  }
}
