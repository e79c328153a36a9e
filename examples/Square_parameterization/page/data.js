'use strict';
// What the page holds: the map as arrays, and the report.

/// the bytes of a script element of letters
function decodedBytes(id) {
  const letters = atob(document.getElementById(id).textContent.trim());
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k)
    bytes[k] = letters.charCodeAt(k);
  return bytes;
}

/// the arrays of the page by name; those of a first candidate are those of the best where there is none
function readArrays(layout) {
  const buffer = decodedBytes('arrays').buffer;
  const types = { float32: Float32Array, uint32: Uint32Array, int32: Int32Array, int8: Int8Array };
  const arrays = {};
  for (const { name, type, offset, size } of layout)
    arrays[name] = new types[type](buffer, offset, size);
  arrays.places_first = arrays.places_first || arrays.places;
  arrays.stretch_first = arrays.stretch_first || arrays.stretch;
  return arrays;
}

/// an array with `width` numbers for each corner of each face, of one with as many for each vertex
function perCorner(values, width, triangles) {
  const result = new values.constructor(width * triangles.length);
  for (let k = 0; k < triangles.length; ++k)
    for (let c = 0; c < width; ++c)
      result[width * k + c] = values[width * triangles[k] + c];
  return result;
}

/// an array with the share of the color scale for each corner of each face, of the stretch of the faces
function scaleShares(stretch, scale) {
  const shares = new Float32Array(3 * stretch.length), span = Math.log(scale.high / scale.low);
  for (let f = 0; f < stretch.length; ++f)
    shares.fill(Math.min(Math.max(Math.log(stretch[f] / scale.low) / span, 0), 1), 3 * f, 3 * f + 3);
  return shares;
}

/// for each corner of each face the number of the face, plus one, as a color, and which of its corners it is
function faceColors(faces) {
  const colors = new Uint8Array(12 * faces);
  for (let f = 0; f < faces; ++f)
    for (let corner = 0; corner < 3; ++corner) {
      const place = 12 * f + 4 * corner;
      for (let byte = 0; byte < 3; ++byte)
        colors[place + byte] = ((f + 1) >> (8 * byte)) & 255;
      colors[place + 3] = 127 * corner;
    }
  return colors;
}

/// the faces with corners of their own, so that each may have a color: one geometry for the surface and for its map
function makeFaces(arrays, scale) {
  const geometry = new THREE.BufferGeometry();
  const add = (name, values, width, normalized) =>
    geometry.setAttribute(name, new THREE.BufferAttribute(values, width, normalized));
  add('position', perCorner(arrays.points, 3, arrays.triangles), 3);
  add('normal', perCorner(arrays.normals, 3, arrays.triangles), 3, true);
  add('uv', perCorner(arrays.places, 2, arrays.triangles), 2);
  add('uvFirst', perCorner(arrays.places_first, 2, arrays.triangles), 2);
  add('share', scaleShares(arrays.stretch, scale), 1);
  add('shareFirst', scaleShares(arrays.stretch_first, scale), 1);
  add('faceColor', faceColors(arrays.stretch.length), 4, true);
  return geometry;
}

/// the edges of the border of the cut surface as ribbons, those of a seam in its color
function makeBorder(arrays, seamColors) {
  const edges = arrays.border.length / 2, geometry = new THREE.BufferGeometry(), indices = [];
  const add = (name, width, value) => {
    const values = new Float32Array(4 * edges * width);
    for (let e = 0; e < edges; ++e)
      for (let k = 0; k < 4; ++k)
        for (let c = 0; c < width; ++c)
          values[(4 * e + k) * width + c] = value(e, k, c);
    geometry.setAttribute(name, new THREE.BufferAttribute(values, width));
  };
  const ends = (values, width, end) => (e, k, c) => values[width * arrays.border[2 * e + end] + c];
  add('position', 3, ends(arrays.points, 3, 0));
  add('target', 3, ends(arrays.points, 3, 1));
  add('uv', 2, ends(arrays.places, 2, 0));
  add('targetUv', 2, ends(arrays.places, 2, 1));
  add('uvFirst', 2, ends(arrays.places_first, 2, 0));
  add('targetUvFirst', 2, ends(arrays.places_first, 2, 1));
  add('place', 2, (e, k, c) => (c === 0 ? k >> 1 : 2 * (k & 1) - 1));
  const black = [0.13, 0.13, 0.13];
  add('color', 3, (e, k, c) => (arrays.seam[e] < 0 ? black : seamColors[arrays.seam[e] % seamColors.length])[c]);
  for (let e = 0; e < edges; ++e)
    indices.push(4 * e, 4 * e + 1, 4 * e + 2, 4 * e + 2, 4 * e + 1, 4 * e + 3);
  geometry.setIndex(indices);
  return geometry;
}
