#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What thin shapes cost: whole jobs of square_map on one core for strips, a coil, cones and sheets with fins and with nails, beside
those for bumps, which are compact, of about as many faces. More faces are mapped than a file has where chords are split, as
all inner edges of a strip one cell wide are. The last column is the ratio of seconds to the bump that costs least.

    thin_shapes.py --faces 7200
"""
import math
import pathlib

import measured_jobs


def grid(columns, rows, point_of):
    """points (i, j) of a grid, and two triangles a cell"""
    points = [point_of(i, j) for i in range(columns + 1) for j in range(rows + 1)]
    faces = []
    for i in range(columns):
        for j in range(rows):
            a, b = i * (rows + 1) + j, (i + 1) * (rows + 1) + j
            faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    return points, faces


def bump(faces, height):
    n = round(math.sqrt(faces / 2))
    return grid(n, n, lambda i, j: (i / n, j / n, height * math.exp(-8 * ((i / n - 0.5) ** 2 + (j / n - 0.5) ** 2))))


def strip(faces, rows):
    return grid(faces // (2 * rows), rows, lambda i, j: (i, j, 0))


def coil(faces, rows, turns):
    """a flat strip that is wound up, with gaps as wide as itself, in steps as long as they are wide in the mean"""
    columns = faces // (2 * rows)

    def point(i, j):
        angle = 2 * math.pi * turns * math.sqrt((i + 0.1 * columns) / (1.1 * columns))
        radius = angle / math.pi + j / rows  # two widths more for each turn
        return radius * math.cos(angle), radius * math.sin(angle), 0

    return grid(columns, rows, point)


def cone(faces, radius_of):
    """one fan round the apex"""
    angles = [2 * math.pi * i / faces for i in range(faces)]
    points = [(radius_of(i) * math.cos(angle), radius_of(i) * math.sin(angle), 0) for i, angle in enumerate(angles)]
    return points + [(0, 0, 1)], [(i, (i + 1) % faces, faces) for i in range(faces)]


def sheet(faces, height_of):
    n = round(math.sqrt(faces / 2))
    return grid(n, n, lambda i, j: (i, j, height_of(i, j)))


def shapes(faces):
    """{name: points and triangles}"""
    result = {'bump, height %g' % height: bump(faces, height) for height in [0.3, 0.8, 1.5]}
    result.update({'strip, %d cells wide' % rows: strip(faces, rows) for rows in [1, 2, 5]})
    result['coil, 8 cells wide, 5 turns'] = coil(faces, 8, 5)
    result['cone'] = cone(faces, lambda i: 1)
    result['cone with teeth'] = cone(faces, lambda i: 1 if i % 2 else 0.8)
    result['fins'] = sheet(faces, lambda i, j: 12 if i % 8 == 4 and j % 30 > 4 else 0)
    result['nails'] = sheet(faces, lambda i, j: 20 if i % 6 == 3 and j % 6 == 3 else 0)
    return result


def main():
    parser = measured_jobs.parser(__doc__)
    parser.add_argument('--faces', type=int, default=7200, help='of each shape, about; default 7200')
    arguments = parser.parse_args()
    programs = measured_jobs.Programs(arguments)
    path = pathlib.Path(programs.folder.name) / 'shape.off'
    rows = []
    for name, (points, faces) in shapes(arguments.faces).items():
        measured_jobs.write_off(path, points, faces)
        job = programs.job(path, 1)
        rows.append([name, len(faces), job['faces'], '%.4f' % job['l2'], job['seconds']])
    least = min(row[-1] for row in rows if row[0].startswith('bump'))
    rows = [row + [row[-1] / least] for row in rows]
    print('One core, %s\n' % measured_jobs.processor())
    measured_jobs.print_table(['shape', 'faces', 'mapped', 'L2', 'seconds', 'ratio'], rows, arguments.csv)


if __name__ == '__main__':
    main()
