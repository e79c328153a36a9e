#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a map that square_map has written as OBJ, from the file alone.

A map is one-to-one onto the unit square when every triangle of texture coordinates is counter-clockwise, by exact
arithmetic, and its border is one loop that runs once round the square, with a vertex in each corner. Prints the L2
stretch and what is wrong; exits 1 when something is. A comment such as `# aspect 2.5` in the file means that the stretch is
that of the map onto the rectangle of this width over height, and of area 1.
"""
import argparse
import collections
import fractions
import json
import math
import sys


class Broken_file(Exception):
    pass


def read_obj(path):
    """points, places in the texture, faces as three pairs of indices of these, and the aspect"""
    points, places, faces, aspect = [], [], [], 1.0
    with open(path) as stream:
        for line in stream:
            kind, *words = line.split() or ['']
            if kind == 'v':
                points.append(tuple(float(word) for word in words))
            elif kind == 'vt':
                places.append(tuple(float(word) for word in words))
            elif kind == 'f':
                face = [tuple(int(number) - 1 for number in word.split('/')) for word in words]
                if len(face) != 3 or any(len(corner) != 2 for corner in face):
                    raise Broken_file('a face is not a triangle with texture coordinates')
                faces.append(face)
            elif words[:1] == ['aspect']:
                aspect = float(words[1])
    if not faces:
        raise Broken_file('there are no faces')
    return points, places, faces, aspect


def is_counter_clockwise(a, b, c):
    left, right = (b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0])
    if abs(left - right) > 1e-14 * (abs(left) + abs(right)):  # rounding makes 4 errors of 2^-53 at most
        return left > right
    a, b, c = ([fractions.Fraction(x) for x in p] for p in (a, b, c))
    return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])


def border_loops(faces):
    """loops of places; also whether each side of a face has at most one face on its other side"""
    sides = collections.Counter((face[k][1], face[(k + 1) % 3][1]) for face in faces for k in range(3))
    following = {a: b for a, b in sides if (b, a) not in sides}
    is_manifold = max(sides.values()) == 1 and len(following) == sum((b, a) not in sides for a, b in sides)
    loops = []
    while following:
        loop = [next(iter(following))]
        while loop[-1] in following:
            loop.append(following.pop(loop[-1]))
        loops.append(loop[:-1])
    return loops, is_manifold


def place_on_square(p):
    """the side of the square and what grows along it counter-clockwise; None off the border. A corner begins a side."""
    x, y = p
    for side, is_on, way in ((0, y == 0 and 0 <= x < 1, x), (1, x == 1 and 0 <= y < 1, y),
                             (2, y == 1 and 0 < x <= 1, -x), (3, x == 0 and 0 < y <= 1, -y)):
        if is_on:
            return side, way
    return None


def border_problems(loop, places):
    if any(place_on_square(places[v]) is None for v in loop):
        return ['a border vertex is off the border of the square']
    walk = [place_on_square(places[v]) for v in loop]
    first = walk.index(min(walk))
    walk = walk[first:] + walk[:first]
    problems = []
    if any(a >= b for a, b in zip(walk, walk[1:])):
        problems.append('the border does not run once round the square, counter-clockwise')
    corners = {places[v] for v in loop} & {(0, 0), (1, 0), (1, 1), (0, 1)}
    if len(corners) < 4:
        problems.append('%d corners of the square have no vertex' % (4 - len(corners)))
    return problems


def l2_stretch(points, places, faces, aspect):
    """of Sander et al. 2001, on the rectangle of area 1: the least and the greatest that it may be, for rounding may take
    or give height to faces that have hardly any, and area to their images"""
    low = [min(p[k] for p in points) for k in range(3)]
    size = max(max(p[k] for p in points) - low[k] for k in range(3)) or 1
    rounding = 2 ** -50 * max(max(map(abs, p)) for p in points) / size
    points = [[(p[k] - low[k]) / size for k in range(3)] for p in points]
    least = greatest = least_area = greatest_area = 0
    for face in faces:
        (p, a), (q, b), (r, c) = ((points[v], places[t]) for v, t in face)
        e, f, g = ([x - y for x, y in zip(*ends)] for ends in ((q, p), (r, p), (r, q)))
        normal = [e[k - 2] * f[k - 1] - e[k - 1] * f[k - 2] for k in range(3)]
        face_area = math.hypot(*normal) / 2
        area_error = rounding * max(math.hypot(*e), math.hypot(*f), math.hypot(*g))
        left, right = (b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0])
        if left <= right:
            return 0, math.inf
        squares = sum((x * (c[k] - a[k]) - y * (b[k] - a[k])) ** 2 * (1 / aspect if k else aspect)
                      for x, y in zip(e, f) for k in range(2))
        squares /= 2 * (left - right) ** 2
        uv_error = min(0.5, 2 ** -50 * (abs(left) + abs(right)) / (left - right))
        least_area += max(0, face_area - area_error)
        greatest_area += face_area + area_error
        least += squares * (1 - uv_error) ** 2 * max(0, face_area - area_error)
        greatest += squares / (1 - uv_error) ** 2 * (face_area + area_error)
    if greatest_area == 0:
        return 0, math.inf
    return math.sqrt(least) / greatest_area, math.sqrt(greatest) / least_area if least_area > 0 else math.inf


def check(path):
    """the report on the map in a file"""
    points, places, faces, aspect = read_obj(path)
    problems = []
    flipped = sum(not is_counter_clockwise(*(places[t] for _, t in face)) for face in faces)
    if flipped:
        problems.append('%d triangles are flipped or flat' % flipped)
    loops, is_manifold = border_loops(faces)
    if not is_manifold:
        problems.append('the texture is not a manifold')
    if len(loops) == 1:
        problems += border_problems(loops[0], places)
    else:
        problems.append('the texture has %d borders' % len(loops))
    least, greatest = l2_stretch(points, places, faces, aspect)
    return {'faces': len(faces), 'flipped': flipped, 'l2': greatest, 'least_l2': least, 'problems': problems}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('map', help='an OBJ file with texture coordinates')
    parser.add_argument('--json', action='store_true', help='print the report as JSON')
    arguments = parser.parse_args()
    try:
        report = check(arguments.map)
    except (OSError, ValueError, IndexError, Broken_file) as error:
        report = {'problems': ['it cannot be read: %s' % error]}
    if arguments.json:
        print(json.dumps(report))
    else:
        print('%d faces, L2 stretch %.9g' % (report.get('faces', 0), report.get('l2', math.nan)))
        print('\n'.join(report['problems']) or 'one-to-one onto the unit square')
    sys.exit(1 if report['problems'] else 0)


if __name__ == '__main__':
    main()
