'use strict';
// Puts the page together.

/// draws whenever something has changed
class Page {
  constructor(page) {
    this.page = page;
    this.arrays = readArrays(page.arrays);
    this.uniforms = makeUniforms(page.scale);
    const faces = makeFaces(this.arrays, page.scale);
    const border = makeBorder(this.arrays, page.seam_colors.map(color => color.map(c => c / 255)));
    this.canvas = document.getElementById('canvas');
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.renderer.setClearColor(0xffffff, 1);
    this.target = new THREE.WebGLRenderTarget(1, 1);
    const squareCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 2);
    squareCamera.position.set(0, 0, 1);
    this.surface = new View(document.getElementById('surface'), makeSurfaceCamera(this.arrays), faces, border,
                            this.uniforms, null);
    this.square = new View(document.getElementById('square'), squareCamera, faces, border, this.uniforms,
                           rectangleAround([page.report.best, page.first || page.report.best]));
    this.goal = 1;
    this.face = -1;
    this.pointer = null;
    this.isChanged = true;
    this.listen();
    this.resize();
  }

  listen() {
    const changed = () => { this.isChanged = true; };
    this.controls = controlSurface(this.surface, changed);
    controlSquare(this.square, changed);
    for (const view of [this.surface, this.square]) {
      view.panel.addEventListener('pointermove', event => {
        const place = view.panel.getBoundingClientRect();
        this.pointer = event.buttons === 0
          ? { view, x: event.clientX - place.left, y: event.clientY - place.top } : null;
      });
      view.panel.addEventListener('pointerleave', () => { this.pointer = null; this.setFace(-1); });
    }
    for (const input of document.querySelectorAll('input'))
      input.addEventListener('change', () => this.readSwitches());
    window.addEventListener('resize', () => this.resize());
    this.readSwitches();
  }

  readSwitches() {
    const value = name => document.querySelector(`input[name=${name}]:checked`).value;
    this.goal = value('candidate') === 'best' ? 1 : 0;
    this.uniforms.coloring.value = value('coloring') === 'stretch' ? STRETCH : CHECKERBOARD;
    document.getElementById('scale').classList.toggle('shown', value('coloring') === 'stretch');
    this.isChanged = true;
  }

  resize() {
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(this.canvas.clientWidth, this.canvas.clientHeight, false);
    this.controls.handleResize();
    this.isChanged = true;
  }

  /// the corners of a face in both pictures, as they are now
  setFace(face) {
    if (face === this.face && face < 0)
      return;
    this.face = face;
    tellFace(face, this.page, this.arrays);
    const { points, places, places_first, triangles } = this.arrays, best = this.uniforms.best.value;
    const corners = place => face < 0 ? null : [0, 1, 2].map(k => place(triangles[3 * face + k]));
    this.surface.showMark(corners(v => new THREE.Vector3(points[3 * v], points[3 * v + 1], points[3 * v + 2])));
    const between = k => (1 - best) * places_first[k] + best * places[k];
    this.square.showMark(corners(v => new THREE.Vector3(between(2 * v), between(2 * v + 1), 0)));
    this.isChanged = true;
  }

  /// goes one step from one candidate to the other
  moveToGoal() {
    const best = this.uniforms.best, distance = this.goal - best.value;
    if (distance === 0)
      return;
    best.value = Math.abs(distance) < 0.06 ? this.goal : best.value + Math.sign(distance) * 0.05;
    this.setFace(this.face);
    this.isChanged = true;
  }

  frame() {
    this.controls.update();
    this.moveToGoal();
    if (this.pointer !== null) {
      const { view, x, y } = this.pointer;
      this.pointer = null;
      this.setFace(view.faceAt(this.renderer, this.target, x, y, this.uniforms));
    }
    if (this.isChanged) {
      this.isChanged = false;
      const place = this.canvas.getBoundingClientRect();
      this.renderer.setScissorTest(false);
      this.renderer.clear(); // between the panels, too
      this.renderer.setScissorTest(true);
      this.surface.draw(this.renderer, place);
      this.square.draw(this.renderer, place);
    }
    requestAnimationFrame(() => this.frame());
  }
}

(() => {
  const page = JSON.parse(document.getElementById('page').textContent);
  writeTitle(page.report);
  writeFigures(page.report, page.first);
  writeDeeds(page);
  writeScale(page.scale);
  showCurve();
  document.getElementById('candidates').disabled = !page.first;
  try {
    const pictures = new Page(page);
    pictures.frame();
    pictures.renderer.getContext().finish();
    document.documentElement.dataset.firstPicture = Math.round(performance.now()); // milliseconds, for tests
  } catch (error) {
    document.getElementById('complaint').textContent = `The pictures need WebGL, which fails here: ${error.message}`;
  }
})();
