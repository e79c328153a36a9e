#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How time and memory of a whole job of square_map grow: one surface, subdivided until it has as many faces as asked
for, on one core. Prints a table and the exponents of least squares in the logarithms, over all sizes and over those of
50000 faces and more, and draws them.

    growth.py build/data/meshes/patch-20.off --most-faces 4000000 --svg growth.svg
"""
import math
import pathlib

import measured_jobs


def exponent(rows, column):
    """the slope of a column over the faces, in logarithms"""
    points = [(math.log(row[1]), math.log(row[column])) for row in rows]
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread > 0 else math.nan


def draw(rows, columns, path):
    """seconds of the job and of the yardstick over the faces, both axes logarithmic"""
    left, right, top, bottom = 70, 620, 30, 420
    faces = [row[1] for row in rows]
    values = [row[c] for row in rows for c in columns]
    x0, x1 = math.floor(math.log10(min(faces))), math.ceil(math.log10(max(faces)))
    y0, y1 = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def x(value):
        return left + (math.log10(value) - x0) / (x1 - x0) * (right - left)

    def y(value):
        return bottom - (math.log10(value) - y0) / (y1 - y0) * (bottom - top)

    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 660 470" font-family="sans-serif" font-size="12">']
    for power in range(x0, x1 + 1):
        lines.append('<path d="M%g %gV%g" stroke="#ddd"/><text x="%g" y="%g" text-anchor="middle">%g</text>' %
                     (x(10 ** power), top, bottom, x(10 ** power), bottom + 18, 10 ** power))
    for power in range(y0, y1 + 1):
        lines.append('<path d="M%g %gH%g" stroke="#ddd"/><text x="%g" y="%g" text-anchor="end">%g s</text>' %
                     (left, y(10 ** power), right, left - 6, y(10 ** power) + 4, 10 ** power))
    for (column, name), color in zip(columns.items(), ['#0072b2', '#d55e00']):
        path_data = 'L'.join('%.1f %.1f' % (x(row[1]), y(row[column])) for row in rows)
        lines.append('<path d="M%s" fill="none" stroke="%s" stroke-width="2"/>' % (path_data, color))
        lines.append('<text x="%g" y="%g" fill="%s" text-anchor="end">%s</text>' %
                     (x(rows[-1][1]), y(rows[-1][column]) - 8, color, name))
    lines.append('<text x="%g" y="%g" text-anchor="middle">faces</text></svg>' % ((left + right) / 2, bottom + 38))
    path.write_text('\n'.join(lines) + '\n', encoding='utf-8')


def main():
    parser = measured_jobs.parser(__doc__)
    parser.add_argument('mesh')
    parser.add_argument('--most-faces', type=int, default=4000000)
    parser.add_argument('--svg', type=pathlib.Path)
    arguments = parser.parse_args()
    programs = measured_jobs.Programs(arguments)
    rows, times = [], 0
    while not rows or rows[-1][1] * 4 <= arguments.most_faces:
        path = programs.subdivided(arguments.mesh, times)
        job, yardstick = programs.job(path, 1), programs.yardstick(path)
        rows.append([path.stem, job['faces'], job['seconds'], yardstick, job['seconds'] / yardstick,
                     job['kilobytes'] / 1024])
        times += 1
    print('One core, %s\n' % measured_jobs.processor())
    measured_jobs.print_table(['mesh', 'faces', 'seconds', 'yardstick', 'ratio', 'MB'], rows, arguments.csv)
    for name, chosen in [('all sizes', rows), ('50000 faces and more', [row for row in rows if row[1] >= 50000])]:
        if len(chosen) > 1:
            print('\nexponents, %s: seconds %.2f, yardstick %.2f, memory %.2f' %
                  (name, exponent(chosen, 2), exponent(chosen, 3), exponent(chosen, 5)))
    if arguments.svg:
        draw(rows, {2: 'square_map', 3: 'one factorization'}, arguments.svg)


if __name__ == '__main__':
    main()
