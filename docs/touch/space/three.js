// A picture in space, drawn by three below the marks of a figure, where there is a graphics card: one mesh, and what the
// figure puts beside it. Light is reckoned at the corners, and all bodies of one form and colour are drawn at once.
import {BufferAttribute, BufferGeometry, Color, ColorManagement, ConeGeometry, CylinderGeometry, DoubleSide, InstancedMesh,
        Matrix4, Mesh, OrthographicCamera, Quaternion, Scene, ShaderMaterial, SphereGeometry, Vector3, WebGLRenderer}
  from 'three';
import {Bodies, brightest, darkest, lampOf} from './bodies.js';

ColorManagement.enabled = false;  // a colour is shown as the page has it

const far = 60;  // the eye is outside of everything
const most = 1200;  // bodies of one form and colour
const upright = new Vector3(0, 1, 0);
const vector = (numbers) => new Vector3(...numbers);

const corner = `
  uniform vec3 colour, lamp;
  varying vec3 shade;
  void main() {
    mat4 place = modelMatrix;
    #ifdef USE_INSTANCING
      place *= instanceMatrix;
    #endif
    vec3 squares = vec3(dot(place[0], place[0]), dot(place[1], place[1]), dot(place[2], place[2]));
    float light = dot(normalize(mat3(place) * (normal / squares)), lamp);
    shade = colour * mix(${darkest.toFixed(3)}, ${brightest.toFixed(3)}, 0.5 + 0.5 * light);
    gl_Position = projectionMatrix * viewMatrix * place * vec4(position, 1.0);
  }`;
const pixel = `
  uniform float opacity;
  varying vec3 shade;
  void main() { gl_FragColor = vec4(shade, opacity); }`;

// Triangles by the coordinates of their corners, none of them shared: each is flat.
function triangles(corners) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  geometry.computeVertexNormals();
  return geometry;
}

// What is put into space by a matrix, each of size 1; a triangle that is lit lies on one of the mesh, and is seen.
const forms = {
  ball: new SphereGeometry(1, 48, 32),
  bar: new CylinderGeometry(1, 1, 1, 12),
  head: new ConeGeometry(1, 1, 24),
  triangle: triangles([0, 0, 0, 1, 0, 0, 0, 1, 0]),
};
const options = {triangle: {side: DoubleSide, polygonOffset: true, polygonOffsetUnits: -2, polygonOffsetFactor: -2}};

// A body of length 1 along y is put between two places.
function between(from, to, radius) {
  const [a, b] = [vector(from), vector(to)], way = b.clone().sub(a), length = way.length();
  return new Matrix4().compose(a.lerp(b, 0.5), new Quaternion().setFromUnitVectors(upright, way.normalize()),
                               new Vector3(radius, length, radius));
}

export class Space extends Bodies {
  /// \param canvas  where to draw
  /// \param mesh  {vertices, faces}: the coordinates, three a vertex, and the vertices, three a face; and its colour
  constructor(canvas, {vertices, faces}, {colour, opacity = 1}) {
    super(canvas);
    Object.assign(this, {scene: new Scene(), lamp: {value: new Vector3()}, materials: new Map(), bodies: new Map()});
    this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true});
    this.corner = (face, k) => vertices.slice(3 * faces[3 * face + k], 3 * faces[3 * face + k] + 3);
    const surface = triangles(faces.flatMap((i) => vertices.slice(3 * i, 3 * i + 3)));
    const layer = (own) => new Mesh(surface, this.material(colour, opacity, own));
    // Of a mesh that one looks through, only the front is seen: how near that is comes first, without its colour.
    if (opacity < 1) this.scene.add(Object.assign(layer({colorWrite: false}), {renderOrder: -1}));
    this.scene.add(layer());
  }

  material(name, opacity, own) {
    const uniforms = {colour: {value: new Color()}, opacity: {value: opacity}, lamp: this.lamp};
    const shaders = {vertexShader: corner, fragmentShader: pixel};
    const material = new ShaderMaterial({...shaders, uniforms, transparent: opacity < 1, ...own});
    this.materials.set(material, name);
    return material;
  }

  add(form, matrix, colour, opacity = 1) {
    const kind = [form, colour, opacity].join();
    if (!this.bodies.has(kind)) {
      const bodies = new InstancedMesh(forms[form], this.material(colour, opacity, options[form]), most);
      this.bodies.set(kind, Object.assign(bodies, {count: 0, frustumCulled: false}));
      this.scene.add(bodies);
    }
    const bodies = this.bodies.get(kind);
    if (bodies.count < most) bodies.setMatrixAt(bodies.count++, matrix);
  }

  ball(center, radius, colour, opacity) {
    this.add('ball', new Matrix4().makeTranslation(...center).scale(new Vector3(radius, radius, radius)), colour, opacity);
  }

  bar(from, to, radius, colour) {
    this.add('bar', between(from, to, radius), colour);
  }

  head(from, to, radius, colour) {
    this.add('head', between(from, to, radius), colour);
  }

  /// Lights up a triangle of the mesh.
  triangle(number, colour) {
    const [a, b, c] = [0, 1, 2].map((k) => vector(this.corner(number, k)));
    const [right, up] = [b.sub(a), c.sub(a)], normal = right.clone().cross(up).normalize();
    this.add('triangle', new Matrix4().makeBasis(right, up, normal).setPosition(a), colour);
  }

  /// Draws the mesh, and what `fill` adds to it.
  /// \param pen  how large the picture is, and what of the view it shows
  /// \param view  {middle, eye, right, up}
  show({view: {left, right, bottom, top}, width, height}, view, fill) {
    for (const bodies of this.bodies.values()) bodies.count = 0;
    fill(this);
    for (const bodies of this.bodies.values()) bodies.instanceMatrix.needsUpdate = true;
    for (const [{uniforms}, name] of this.materials) uniforms.colour.value.setRGB(...this.colour(name).map((each) => each / 255));
    const camera = new OrthographicCamera(left, right, top, bottom, 0.1, 2 * far), middle = vector(view.middle);
    camera.position.copy(middle).addScaledVector(vector(view.eye), far);
    camera.up.set(...view.up);
    camera.lookAt(middle);
    this.lamp.value.set(...lampOf(view));
    this.fit(width, height);
    this.renderer.render(this.scene, camera);
  }

  // A picture of another size is made anew, which takes a while.
  fit(width, height) {
    const size = [width, height, devicePixelRatio].join();
    if (size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(width, height);
  }
}
