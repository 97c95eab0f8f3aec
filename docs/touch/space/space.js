// A picture in space, drawn by three below the marks of a figure: one mesh, and balls, arrows and lit triangles. Places are
// the library's; a colour is one of the book's, by its name.
import {BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, Group,
        HemisphereLight, Mesh,
        MeshLambertMaterial, OrthographicCamera, Scene, SphereGeometry, Vector3, WebGLRenderer} from 'three';

const far = 60;  // the eye is outside of everything
const ball = new SphereGeometry(1, 48, 32), shaft = new CylinderGeometry(1, 1, 1, 16), head = new ConeGeometry(1, 1, 24);
const upright = new Vector3(0, 1, 0);

function triangles(vertices, faces) {
  const geometry = new BufferGeometry();
  const corners = new Float32Array(faces.flatMap((i) => vertices.slice(3 * i, 3 * i + 3)));
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.computeVertexNormals();  // no corner is shared: flat triangles
  return geometry;
}

// A body of length 1 along y is put between two places.
function between(body, from, to, width) {
  const way = to.clone().sub(from), length = way.length();
  body.position.copy(from).addScaledVector(way, 0.5);
  body.scale.set(width, length, width);
  body.quaternion.setFromUnitVectors(upright, way.normalize());
  return body;
}

export class Space {
  /// \param canvas  where to draw, in this context
  /// \param mesh  {vertices, faces}: the coordinates, three a vertex, and the vertices, three a face; and its colour
  constructor(canvas, context, mesh, {colour, opacity = 1}) {
    this.renderer = new WebGLRenderer({canvas, context, antialias: true, alpha: true});
    Object.assign(this, {canvas, source: mesh, colour, opacity, scene: new Scene(), things: new Group()});
    Object.assign(this, {materials: new Map(), seen: new Map()});
    this.mesh = new Mesh(triangles(mesh.vertices, mesh.faces));
    this.lamp = new DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.mesh, this.things, new HemisphereLight(0xffffff, 0x888888, 1.6), this.lamp, this.lamp.target);
  }

  // A colour of the book in the theme that is seen; it is asked for once a picture.
  material(name, opacity = 1) {
    if (!this.seen.has(name)) {
      this.canvas.style.color = `var(--${name})`;
      this.seen.set(name, getComputedStyle(this.canvas).color);
    }
    const color = this.seen.get(name), key = `${color} ${opacity}`;
    const material = () => new MeshLambertMaterial({color, side: DoubleSide, transparent: opacity < 1, opacity});
    if (!this.materials.has(key)) this.materials.set(key, material());
    return this.materials.get(key);
  }

  add(geometry, name, opacity) {
    const thing = new Mesh(geometry, this.material(name, opacity));
    this.things.add(thing);
    return thing;
  }

  ball(center, radius, colour, opacity) {
    const thing = this.add(ball, colour, opacity);
    thing.position.set(...center);
    thing.scale.setScalar(radius);
  }

  arrow(from, to, colour) {
    const [a, b] = [new Vector3(...from), new Vector3(...to)], length = a.distanceTo(b), tip = Math.min(0.55, length);
    if (length === 0) return;
    const neck = b.clone().lerp(a, tip / length);
    between(this.add(shaft, colour), a, neck, 0.05);
    between(this.add(head, colour), neck, b, 0.17);
  }

  /// The edges of a box, from its lowest corner to its highest.
  box(low, high, colour, width = 0.03) {
    const corner = (i) => new Vector3(...low.map((each, k) => i >> k & 1 ? high[k] : each));
    for (let i = 0; i < 8; ++i)
      for (const k of [1, 2, 4]) if (!(i & k)) between(this.add(shaft, colour), corner(i), corner(i | k), width);
  }

  /// Lights up a triangle of the mesh.
  triangle(number, colour) {
    const lit = this.add(triangles(this.source.vertices, this.source.faces.slice(3 * number, 3 * number + 3)), colour);
    lit.material.polygonOffset = true;
    lit.material.polygonOffsetUnits = lit.material.polygonOffsetFactor = -2;
  }

  // A picture of another size is made anew, which takes a while.
  fit(width, height) {
    const size = [width, height, devicePixelRatio].join();
    if (size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(width, height);
  }

  /// Draws the mesh, and what `fill` adds to it.
  /// \param pen  how large the picture is, and what of the view it shows
  /// \param view  {middle, eye, right, up}
  show({view: {left, right, bottom, top}, width, height}, {middle, eye, up}, fill) {
    for (const thing of this.things.children) if (thing.geometry.type === 'BufferGeometry') thing.geometry.dispose();
    this.things.clear();
    this.seen.clear();
    this.mesh.material = this.material(this.colour, this.opacity);
    fill(this);
    const camera = new OrthographicCamera(left, right, top, bottom, 0.1, 2 * far), center = new Vector3(...middle);
    camera.position.copy(center).addScaledVector(new Vector3(...eye), far);
    camera.up.set(...up);
    camera.lookAt(center);
    this.lamp.target.position.copy(center);
    this.lamp.position.copy(camera.position).addScaledVector(camera.up, far / 2);
    this.fit(width, height);
    this.renderer.render(this.scene, camera);
  }
}
