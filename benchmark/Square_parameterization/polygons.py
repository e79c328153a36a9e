#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What points inside large polygons save: each polygon is mapped by `square_map --triangulate` on one core as it is, when it is split
with points inside, and with its first and third corner exchanged, when it meets itself and is split between its corners alone.
With --height prisms on the polygons are mapped instead, whose lids they are: closed surfaces as of gears.

    polygons.py --corners 2000
    polygons.py --corners 2500 --height 1
"""
import math
import pathlib
import random

import measured_jobs


def round_polygon(corners, radius_of):
    return [(radius_of(k) * math.cos(2 * math.pi * k / corners), radius_of(k) * math.sin(2 * math.pi * k / corners))
            for k in range(corners)]


def comb(corners):
    """teeth of 1 by 2 on a base of height 5"""
    teeth = corners // 4
    points = [(-1, -5), (2 * teeth, -5), (2 * teeth, 0)]
    for tooth in reversed(range(teeth)):
        points += [(2 * tooth + x, y) for x, y in [(1, 0), (1, 2), (0, 2), (0, 0)]]
    return points + [(-1, 0)]


def polygons(corners):
    """{name: points in the plane}"""
    numbers = random.Random(1)
    radii = [numbers.uniform(0.7, 1) for _ in range(corners)]
    result = {'circle': round_polygon(corners, lambda k: 1),
              'seven waves, radii 0.8 to 1.2': round_polygon(corners, lambda k: 1 + math.sin(14 * math.pi * k / corners) / 5),
              'teeth of ten corners, radii 1 and 0.8': round_polygon(corners, lambda k: 1 if (k + 5) // 10 % 2 else 0.8),
              'radii between 0.7 and 1 at random': round_polygon(corners, lambda k: radii[k]),
              'comb': comb(corners)}
    for inner in [0.95, 0.8, 0.5, 0.2]:
        result['radii 1 and %g in turns' % inner] = round_polygon(corners, lambda k, r=inner: 1 if k % 2 else r)
    return result


def flat(points):
    """points and faces of a polygon"""
    return [(*corner, 0) for corner in points], [range(len(points))]


def prism(points, height):
    """the same of a prism"""
    n = len(points)
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return [(*corner, z) for z in [0, height] for corner in points], [range(n - 1, -1, -1), range(n, 2 * n), *sides]


def main():
    parser = measured_jobs.parser(__doc__)
    parser.add_argument('--corners', type=int, default=2000, help='about; default 2000')
    parser.add_argument('--height', type=float, help='of prisms on the polygons')
    arguments = parser.parse_args()
    has_height = arguments.height is not None
    if has_height and not arguments.height > 0:
        parser.error('a height is positive')
    programs = measured_jobs.Programs(arguments)
    path = pathlib.Path(programs.folder.name) / 'polygon.off'
    rows = []
    for name, points in polygons(arguments.corners).items():
        row = [name]
        shapes = [prism(points, arguments.height)] if has_height else [flat(points[2::-1] + points[3:]), flat(points)]
        for shape in shapes:
            measured_jobs.write_off(path, *shape)
            job = programs.job(path, 1, '--triangulate')
            row += [job['faces'], '%.3f' % job['l2'], job['seconds']]
        rows.append(row)
    kind = 'Prisms of height %g on polygons' % arguments.height if has_height else 'Polygons'
    print('%s of %d corners on one core, %s\n' % (kind, arguments.corners, measured_jobs.processor()))
    splits = ['with points'] if has_height else ['between corners', 'with points']
    columns = ['polygon', *('%s %s' % (column, split) for split in splits for column in ['faces', 'L2', 'seconds'])]
    measured_jobs.print_table(columns, rows, arguments.csv)


if __name__ == '__main__':
    main()
