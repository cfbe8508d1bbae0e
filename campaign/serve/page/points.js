// Particles as shaded balls by three.js: one draw call, turned by its trackball.

import { BufferAttribute, BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, OrthographicCamera, Points as Cloud,
  Scene, ShaderMaterial, Vector3, VertexColors, WebGLRenderer } from "./three.module.js";
import { TrackballControls } from "./TrackballControls.js";

const vertexShader = `
attribute vec3 colour;
uniform float size;
varying vec3 c;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = size;
  c = colour;
}`;
const fragmentShader = `
varying vec3 c;
void main() {
  vec2 r = 2.0 * gl_PointCoord - 1.0;
  float r2 = dot(r, r);
  if (r2 > 1.0) discard;
  float light = 0.55 + 0.45 * (0.35 * -r.x - 0.45 * r.y + 0.82 * sqrt(1.0 - r2));
  gl_FragColor = vec4(c * light, 1.0);
}`;

// Of the camera from what it looks at: where an orthographic one stands shows in nothing, but the
// trackball tells only of moves that are not tiny.
const distance = 1000;

function renderer_on(canvas) {
  try {
    return new WebGLRenderer({ canvas, antialias: false, stencil: false, powerPreference: "high-performance" });
  } catch {
    throw new Error("This browser has no WebGL: particles cannot be drawn.");
  }
}

export class Points {
  /// Throws where the browser has no WebGL. Gives up all that it holds when the signal comes.
  constructor(canvas, signal) {
    const camera = new OrthographicCamera(-1, 1, 1, -1), scene = new Scene();
    Object.assign(this, { canvas, camera, scene, renderer: renderer_on(canvas), radius: 1, frames: 0 });
    this.balls = new Cloud(new BufferGeometry(), new ShaderMaterial({ vertexShader, fragmentShader, uniforms: { size: { value: 1 } } }));
    this.sticks = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: VertexColors, depthTest: false }));
    this.sticks.renderOrder = 1;
    for (const body of [this.balls, this.sticks]) scene.add(Object.assign(body, { frustumCulled: false }));
    camera.position.z = distance;
    this.controls = Object.assign(new TrackballControls(camera, canvas), { staticMoving: true, keys: [] });
    this.listen(signal);
    const watch = new ResizeObserver(() => this.fit());
    watch.observe(canvas);
    signal.addEventListener("abort", () => { watch.disconnect(); this.dispose(); });
  }
  /// Positions, 3 n, m; radius of a particle, m. Colours must follow.
  positions(x, radius) {
    this.radius = radius;
    this.shape(this.balls, { position: new BufferAttribute(x, 3) });
  }
  /// RGBA, a byte each.
  colours(rgba) {
    const { geometry } = this.balls, there = geometry.getAttribute("colour");
    if (there) there.copyArray(rgba).needsUpdate = true;
    else geometry.setAttribute("colour", new BufferAttribute(rgba, 4, true));
    this.draw_soon();
  }
  /// Lines over everything: [{from, to, colour: [r, g, b]}].
  segments(list) {
    this.shape(this.sticks, { position: new Float32BufferAttribute(list.flatMap((s) => [...s.from, ...s.to]), 3),
      color: new Float32BufferAttribute(list.flatMap((s) => [...s.colour, ...s.colour]).map((octet) => octet / 255), 3) });
  }
  shape(body, attributes) {
    body.geometry.dispose();
    body.geometry = new BufferGeometry();
    for (const [name, attribute] of Object.entries(attributes)) body.geometry.setAttribute(name, attribute);
    this.draw_soon();
  }
  /// What is in the middle, and how far the shorter side reaches from it, m.
  look_at(centre, half) {
    const { camera, controls: { target } } = this, eye = camera.position.clone().sub(target);
    camera.position.addVectors(target.fromArray(centre), eye);
    this.zoom(camera.zoom * half);
  }
  zoom(factor) {
    this.camera.zoom /= factor;
    this.controls.update();
    this.draw_soon();
  }
  rotate(right, down) {
    const { camera, controls } = this, eye = camera.position.sub(controls.target).applyAxisAngle(camera.up, -right);
    const side = new Vector3().crossVectors(camera.up, eye).normalize();
    for (const arm of [eye, camera.up]) arm.applyAxisAngle(side, -down);
    eye.add(controls.target);
    controls.update();
  }
  fit() {
    const { canvas, camera, controls, renderer } = this, { clientWidth: width, clientHeight: height } = canvas;
    if (!width || !height) return;
    const shorter = Math.min(width, height);
    renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    renderer.setSize(width, height, false);
    Object.assign(camera, { left: -width / shorter, right: width / shorter, top: height / shorter, bottom: -height / shorter });
    // A drag over the shorter side turns by 3; what is pushed stays below the pointer.
    Object.assign(controls, { rotateSpeed: (1.5 * width) / shorter, panSpeed: width / distance });
    controls.handleResize();
    this.draw();
  }
  draw_soon() {
    this.waiting ??= requestAnimationFrame(() => this.draw());
  }
  draw() {
    const { canvas, camera, renderer } = this, deep = 40 / camera.zoom;
    cancelAnimationFrame(this.waiting);
    this.waiting = null;
    Object.assign(camera, { near: distance - deep, far: distance + deep });
    camera.updateProjectionMatrix();
    const pixels = 0.5 * Math.min(canvas.width, canvas.height) * camera.zoom;
    this.balls.material.uniforms.size.value = Math.max(1.5, 2 * this.radius * pixels);
    renderer.setClearColor(getComputedStyle(canvas).getPropertyValue("--paper").trim());
    renderer.render(this.scene, camera);
    canvas.dataset.frames = ++this.frames;
  }
  /// The trackball moves when it is asked to: after each event that concerns it, not in a loop.
  listen(signal) {
    const { canvas, camera, controls } = this, update = () => controls.update();
    controls.addEventListener("change", () => this.draw_soon());
    controls.addEventListener("start", () => document.addEventListener("mousemove", update, { signal }));
    controls.addEventListener("end", () => { document.removeEventListener("mousemove", update); update(); });
    canvas.addEventListener("touchmove", update);
    // three.js r111 zooms an orthographic camera the wrong way round below two fingers.
    let fingers = 0;
    for (const kind of ["touchstart", "touchend"]) canvas.addEventListener(kind, (e) => { fingers = e.touches.length; }, { capture: true });
    const zoom = controls.zoomCamera;
    controls.zoomCamera = () => {
      const before = camera.zoom;
      zoom.call(controls);
      if (fingers > 1) camera.zoom = before ** 2 / camera.zoom;
    };
    canvas.addEventListener("mousedown", () => canvas.focus({ preventScroll: true }));  // which the trackball prevents
    canvas.addEventListener("keydown", (e) => {
      const turn = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key], factor = { "+": 0.85, "-": 1.18 }[e.key];
      if (!turn && !factor) return;
      e.preventDefault();
      turn ? this.rotate(...turn) : this.zoom(factor);
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw_soon(), { signal });
  }
  dispose() {
    cancelAnimationFrame(this.waiting);
    this.controls.dispose();
    for (const { geometry, material } of [this.balls, this.sticks]) geometry.dispose(), material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
