// Particles as shaded balls in WebGL 2: one draw call, turned by a trackball.

const vertex = `#version 300 es
in vec3 x;
in vec3 colour;
uniform mat3 turn;
uniform vec3 centre;
uniform vec2 scale;
uniform float depth, size;
out vec3 c;
void main() {
  vec3 p = turn * (x - centre);
  gl_Position = vec4(p.xy * scale, -p.z * depth, 1.0);
  gl_PointSize = size;
  c = colour;
}`;
const fragment = `#version 300 es
precision mediump float;
in vec3 c;
out vec4 pixel;
void main() {
  vec2 r = 2.0 * gl_PointCoord - 1.0;
  float r2 = dot(r, r);
  if (r2 > 1.0) discard;
  float light = 0.55 + 0.45 * (0.35 * -r.x - 0.45 * r.y + 0.82 * sqrt(1.0 - r2));
  pixel = vec4(c * light, 1.0);
}`;
const plain = `#version 300 es
precision mediump float;
in vec3 c;
out vec4 pixel;
void main() { pixel = vec4(c, 1.0); }`;

function program(gl, fragment_text) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment_text]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.bindAttribLocation(made, 0, "x");
  gl.bindAttribLocation(made, 1, "colour");
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const at = Object.fromEntries(["turn", "centre", "scale", "depth", "size"].map((name) => [name, gl.getUniformLocation(made, name)]));
  return { made, at };
}

const multiply = (a, b) => [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j]));
const about_x = (t) => [1, 0, 0, 0, Math.cos(t), -Math.sin(t), 0, Math.sin(t), Math.cos(t)];
const about_y = (t) => [Math.cos(t), 0, Math.sin(t), 0, 1, 0, -Math.sin(t), 0, Math.cos(t)];

export class Points {
  /// Throws where the browser has no WebGL 2.
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("This browser has no WebGL 2: particles cannot be drawn.");
    Object.assign(this, { canvas, gl, turn: [1, 0, 0, 0, 1, 0, 0, 0, 1], centre: [0, 0, 0], half: 1, n: 0, radius: 1, lines: 0, frames: 0 });
    this.balls = program(gl, fragment);
    this.sticks = program(gl, plain);
    this.of_points = this.arrays();
    this.of_lines = this.arrays();
    gl.enable(gl.DEPTH_TEST);
    this.listen();
    new ResizeObserver(() => this.draw_soon()).observe(canvas);
  }
  arrays() {
    const { gl } = this, set = gl.createVertexArray(), x = gl.createBuffer(), colour = gl.createBuffer();
    gl.bindVertexArray(set);
    gl.bindBuffer(gl.ARRAY_BUFFER, x);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, colour);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
    return { set, x, colour };
  }
  put(buffer, data) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, buffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, data, this.gl.DYNAMIC_DRAW);
  }
  /// Positions, 3 n, m; radius of a particle, m.
  positions(x, radius) { this.put(this.of_points.x, x); this.n = x.length / 3; this.radius = radius; this.draw_soon(); }
  colours(rgba) { this.put(this.of_points.colour, rgba); this.draw_soon(); }
  /// Lines over everything: [{from, to, colour: [r, g, b]}].
  segments(list) {
    this.put(this.of_lines.x, new Float32Array(list.flatMap((s) => [...s.from, ...s.to])));
    this.put(this.of_lines.colour, new Uint8Array(list.flatMap((s) => [...s.colour, 255, ...s.colour, 255])));
    this.lines = 2 * list.length;
    this.draw_soon();
  }
  /// What is in the middle, and how far the shorter side reaches from it, m.
  look_at(centre, half) { this.centre = centre; this.half = half; this.draw_soon(); }
  rotate(right, down) { this.turn = multiply(multiply(about_x(down), about_y(right)), this.turn); this.draw_soon(); }
  zoom(factor) { this.half *= factor; this.draw_soon(); }
  draw_soon() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.draw(); });
  }
  draw() {
    const { gl, canvas } = this, ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    gl.clearColor(...(dark ? [0.075, 0.082, 0.094] : [0.965, 0.961, 0.949]), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const shorter = Math.min(width, height), pixels = shorter / (2 * this.half);
    const uniforms = ({ made, at }, size) => {
      gl.useProgram(made);
      gl.uniformMatrix3fv(at.turn, true, this.turn);
      gl.uniform3fv(at.centre, this.centre);
      gl.uniform2f(at.scale, (2 * pixels) / width, (2 * pixels) / height);
      gl.uniform1f(at.depth, 1 / (40 * this.half));
      gl.uniform1f(at.size, size);
    };
    uniforms(this.balls, Math.max(1.5, 2 * this.radius * pixels));
    gl.bindVertexArray(this.of_points.set);
    gl.drawArrays(gl.POINTS, 0, this.n);
    if (this.lines) {
      uniforms(this.sticks, 1);
      gl.disable(gl.DEPTH_TEST);
      gl.bindVertexArray(this.of_lines.set);
      gl.drawArrays(gl.LINES, 0, this.lines);
      gl.enable(gl.DEPTH_TEST);
    }
    canvas.dataset.frames = ++this.frames;
  }
  listen() {
    const { canvas } = this, held = new Map();
    canvas.addEventListener("pointerdown", (e) => { canvas.setPointerCapture(e.pointerId); held.set(e.pointerId, [e.clientX, e.clientY]); });
    const apart = () => { const [a, b] = [...held.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
    canvas.addEventListener("pointermove", (e) => {
      if (!held.has(e.pointerId)) return;
      const before = held.get(e.pointerId), far = held.size === 2 && apart();
      held.set(e.pointerId, [e.clientX, e.clientY]);
      if (held.size === 2) return void this.zoom(far / Math.max(1, apart()));
      const reach = Math.min(canvas.clientWidth, canvas.clientHeight);
      this.rotate((3 * (e.clientX - before[0])) / reach, (3 * (e.clientY - before[1])) / reach);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (e) => held.delete(e.pointerId));
    canvas.addEventListener("wheel", (e) => { e.preventDefault(); this.zoom(Math.exp(Math.sign(e.deltaY) * 0.12)); }, { passive: false });
    canvas.addEventListener("keydown", (e) => {
      const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
      if (turns) this.rotate(...turns);
      else if (e.key === "+" || e.key === "-") this.zoom(e.key === "+" ? 0.85 : 1.18);
      else return;
      e.preventDefault();
    });
  }
}
