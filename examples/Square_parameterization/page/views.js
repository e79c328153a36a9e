'use strict';
// The two pictures, which one canvas behind two panels shows, and what the pointer does there.

/// width and height of what holds the rectangles of several maps, of area 1 each
function rectangleAround(maps) {
  return { width: Math.max(...maps.map(map => Math.sqrt(map.aspect))),
           height: Math.max(...maps.map(map => 1 / Math.sqrt(map.aspect))) };
}

/// a picture: what is drawn in a panel, and from where; in space, or flat in a rectangle round the origin
class View {
  constructor(panel, camera, faces, border, uniforms, rectangle) {
    const isFlat = rectangle !== null;
    this.rectangle = rectangle;
    this.panel = panel;
    this.camera = camera;
    this.size = { value: new THREE.Vector2(1, 1) };
    this.faces = new THREE.Mesh(faces, makeFaceMaterial(uniforms, isFlat));
    this.border = new THREE.Mesh(border, makeBorderMaterial(uniforms, this.size, isFlat));
    this.mark = new THREE.Group();
    this.mark.visible = false;
    this.scene = new THREE.Scene();
    for (const object of [this.faces, this.border, this.mark]) {
      object.frustumCulled = false; // the shaders move the points
      this.scene.add(object);
    }
  }

  /// marks a face, also where others hide it
  showMark(corners) {
    this.mark.children.slice().forEach(child => this.mark.remove(child));
    this.mark.visible = corners !== null;
    if (corners === null)
      return;
    const center = new THREE.Vector3();
    corners.forEach(corner => center.addScaledVector(corner, 1 / 3));
    const hidden = { color: 0xd5006d, depthTest: false, transparent: true };
    this.mark.add(new THREE.LineLoop(new THREE.BufferGeometry().setFromPoints(corners),
                                     new THREE.LineBasicMaterial(hidden)));
    this.mark.add(new THREE.Points(new THREE.BufferGeometry().setFromPoints([center]),
                                   new THREE.PointsMaterial(Object.assign({ size: 7, sizeAttenuation: false }, hidden))));
    this.mark.children.forEach(child => { child.frustumCulled = false; });
  }

  /// draws the picture behind the panel
  draw(renderer, canvasPlace) {
    const place = this.panel.getBoundingClientRect();
    const rectangle = [place.left - canvasPlace.left + 1, canvasPlace.bottom - place.bottom + 1,
                       place.width - 2, place.height - 2];
    this.size.value.set(rectangle[2], rectangle[3]);
    this.setAspect(rectangle[2] / rectangle[3]);
    renderer.setViewport(...rectangle);
    renderer.setScissor(...rectangle);
    renderer.render(this.scene, this.camera);
  }

  setAspect(aspect) {
    const camera = this.camera;
    if (this.rectangle !== null) {
      const { width, height } = this.rectangle;
      camera.top = 0.54 * Math.max(height, width / aspect); // a little more than the rectangle
      camera.bottom = -camera.top;
      camera.right = aspect * camera.top;
      camera.left = -camera.right;
    } else
      camera.aspect = aspect;
    camera.updateProjectionMatrix();
  }

  /// the number of the face at a place of the panel, or -1
  faceAt(renderer, target, x, y, uniforms) {
    const coloring = uniforms.coloring.value, pixel = new Uint8Array(4);
    uniforms.coloring.value = FACE_NUMBERS;
    this.border.visible = this.mark.visible = false;
    this.camera.setViewOffset(this.panel.clientWidth, this.panel.clientHeight, x, y, 1, 1);
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.render(this.scene, this.camera);
    renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
    renderer.setRenderTarget(null);
    renderer.setClearColor(0xffffff, 1);
    this.camera.clearViewOffset();
    this.border.visible = true;
    this.mark.visible = this.mark.children.length > 0;
    uniforms.coloring.value = coloring;
    return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
  }
}

/// looks at the surface from the side where it shows most of its outside, as its center sees it
function makeSurfaceCamera(arrays) {
  let radius = 0;
  const mean = new THREE.Vector3();
  for (let k = 0; k < arrays.points.length; k += 3) {
    radius = Math.max(radius, Math.hypot(arrays.points[k], arrays.points[k + 1], arrays.points[k + 2]));
    mean.add(new THREE.Vector3(arrays.normals[k], arrays.normals[k + 1], arrays.normals[k + 2]));
  }
  if (mean.length() < 0.05 * 127 * arrays.points.length / 3) // closed: all sides are alike
    mean.set(0.5, 0.4, 1);
  const camera = new THREE.PerspectiveCamera(30, 1, radius / 100, radius * 50);
  camera.up.set(0, Math.abs(mean.y) > 0.9 * mean.length() ? 0 : 1, Math.abs(mean.y) > 0.9 * mean.length() ? 1 : 0);
  camera.position.copy(mean.normalize().multiplyScalar(radius / Math.sin(Math.PI / 12)));
  camera.lookAt(0, 0, 0);
  return camera;
}

/// turns the surface by the mouse; `changed` is called when it has
function controlSurface(view, changed) {
  const controls = new THREE.TrackballControls(view.camera, view.panel);
  controls.staticMoving = true;
  controls.rotateSpeed = 3;
  controls.maxDistance = 20 * view.camera.position.length();
  controls.addEventListener('change', changed);
  return controls;
}

/// moves and enlarges the square by the mouse; `changed` is called when it has
function controlSquare(view, changed) {
  const { panel, camera } = view;
  const unitsPerPixel = () => (camera.right - camera.left) / camera.zoom / panel.clientWidth;
  let last = null;
  panel.addEventListener('pointerdown', event => { last = event; panel.setPointerCapture(event.pointerId); });
  panel.addEventListener('pointerup', () => { last = null; });
  panel.addEventListener('pointermove', event => {
    if (last === null)
      return;
    camera.position.x -= (event.clientX - last.clientX) * unitsPerPixel();
    camera.position.y += (event.clientY - last.clientY) * unitsPerPixel();
    last = event;
    changed();
  });
  panel.addEventListener('wheel', event => {
    event.preventDefault();
    const place = panel.getBoundingClientRect();
    const x = event.clientX - (place.left + place.right) / 2, y = (place.top + place.bottom) / 2 - event.clientY;
    const before = unitsPerPixel();
    camera.zoom = Math.min(Math.max(camera.zoom * Math.exp(-event.deltaY / 400), 0.5), 1000);
    camera.position.x += x * (before - unitsPerPixel()); // what is under the pointer stays there
    camera.position.y += y * (before - unitsPerPixel());
    changed();
  }, { passive: false });
}
