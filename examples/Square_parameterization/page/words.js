'use strict';
// What the page says in words and numbers; all of it is text, never HTML.

function addElement(parent, name, text) {
  const element = parent.appendChild(document.createElement(name));
  if (text !== undefined)
    element.textContent = text;
  return element;
}

/// a number with four significant digits
const rounded = x => (x === null || x === undefined ? 'none' : Number(x.toPrecision(4)).toString());

const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;

function writeTitle(report) {
  const file = report.input.file === '-' ? 'standard input' : report.input.file.split('/').pop();
  const title = `The map of ${file} onto the ${report.best.aspect === 1 ? 'square' : 'rectangle'}`;
  document.title = title;
  document.getElementById('title').textContent = title;
  document.getElementById('summary').textContent =
    `${counted(report.conditioned.faces, 'face', 'faces')}, ${counted(report.conditioned.vertices, 'vertex', 'vertices')}, ` +
    `L2 stretch ${rounded(report.best.l2)}, largest stretch ${rounded(report.best.linf)}. Black lines are the border; ` +
    (report.conditioned.seam_edges > 0 ? 'both sides of a seam have one color.' : 'nothing was cut.');
}

/// the figures of both candidates, side by side
function writeFigures(report, first) {
  const table = document.getElementById('figures'), columns = first ? [report.best, first] : [report.best];
  const head = addElement(addElement(table, 'thead'), 'tr'), body = addElement(table, 'tbody');
  addElement(head, 'th');
  const name = figures => `candidate ${figures.candidate}` +
    (figures !== report.best ? ' (first)' : figures.has_moved_corners ? ', corners moved (best)' : ' (best)');
  columns.forEach(figures => addElement(head, 'th', name(figures)));
  const corners = figures => figures.input_corners.map(v => (v === null ? 'added' : v)).join(', ');
  const rows = [['L2 stretch', f => rounded(f.l2)], ['largest stretch (Linf)', f => rounded(f.linf)],
                ['symmetric Dirichlet energy', f => rounded(f.symmetric_dirichlet)],
                ['flipped faces', f => f.flipped], ['width over height', f => rounded(f.aspect)], ['corners, vertices of the file', corners]];
  for (const [words, value] of rows) {
    const row = addElement(body, 'tr');
    addElement(row, 'th', words);
    columns.forEach(figures => addElement(row, 'td', value(figures)));
  }
}

/// what was done to the file, and how the map was found
function writeDeeds(page) {
  const { report } = page, done = report.conditioned, list = document.getElementById('deeds');
  const tell = (count, one, many, rest) => {
    if (count > 0)
      addElement(list, 'li', counted(count, one, many) + rest);
  };
  addElement(list, 'li', `The file has ${counted(report.input.vertices, 'vertex', 'vertices')} and ` +
                         `${counted(report.input.faces, 'face', 'faces')}.`);
  if (done.components > 1)
    addElement(list, 'li', `Component ${done.component} of ${done.components} was kept.`);
  tell(done.polygons_triangulated, 'polygon was', 'polygons were', ' split into triangles.');
  tell(done.vertices_added, 'vertex was', 'vertices were', ' added inside polygons.');
  tell(done.faces_reoriented, 'face was', 'faces were', ' turned round to agree with the neighbors.');
  tell(done.vertices_dropped, 'vertex without a kept face was', 'vertices without a kept face were', ' dropped.');
  if (done.seam_edges > 0)
    addElement(list, 'li', `Cut along ${counted(done.seam_edges, 'edge', 'edges')}, ${rounded(done.cut_length)} sides of ` +
                           'a square of the same area long.');
  tell(done.border_edges_split, 'edge of the border was', 'edges of the border were', ' split: it was too short.');
  tell(done.chords_split, 'chord was', 'chords were', ' split.');
  tell(done.degenerate_faces, 'face without area was', 'faces without area were', ' mapped as if a little wide.');
  addElement(list, 'li', `Minimizer ${report.minimizer}, strategy ${report.strategy}: ` +
                         `${counted(report.evaluations, 'candidate', 'candidates')} of ${report.candidates} mapped.`);
  if (report.best.has_moved_corners)
    addElement(list, 'li', `The corners then moved on their own, from those of candidate ${report.best.candidate}.`);
  if (report.time_limit_reached)
    addElement(list, 'li', 'The time limit was reached: this is the best map so far.');
  if (page.no_first)
    addElement(list, 'li', page.no_first);
}

/// the colors of the stretch, with the numbers at both ends
function writeScale(scale) {
  document.getElementById('low').textContent = rounded(scale.low);
  document.getElementById('high').textContent = rounded(scale.high);
  document.getElementById('colors').style.background =
    `linear-gradient(to right, ${scale.colors.map(color => `rgb(${color})`).join(', ')})`;
}

/// the curve, drawn by the command; nothing where a single candidate was mapped
function showCurve() {
  const curve = document.getElementById('curve'), place = document.getElementById('curve_place');
  if (curve === null)
    place.remove();
  else
    place.appendChild(curve.content);
}

function tellFace(face, page, arrays) {
  const words = document.getElementById('face');
  words.textContent = face < 0 ? 'Point at a face to see it in both pictures.'
    : `Face ${face}: L2 stretch ${rounded(arrays.stretch[face])}` +
      (page.first ? `, with the first candidate ${rounded(arrays.stretch_first[face])}` : '');
}
