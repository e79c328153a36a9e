#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program behind every measured table of README.md and of the user manual again, keeps what it prints in
build/tables/, and says which figures have moved by more than their noise.

Noise. Stretch, energies, lengths and counts are deterministic: they may differ by one unit of the last digit printed.
Seconds depend on the machine: they are divided by their median ratio to those of the table, which is printed, and may
then differ by 30 %, or by 5 ms.

Names of tables choose some; all of them take about a quarter of an hour. Exits 1 when a figure has moved.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
README = REPOSITORY / 'README.md'
MANUAL = REPOSITORY / 'doc/Square_parameterization/Square_parameterization.txt'
RELATIVE_NOISE, LEAST_NOISE = 0.3, 0.005  # of seconds

BENCHMARK_MESHES = ['lion-head', 'mannequin-devil', 'cylinder_locally_refined', 'mushroom', 'three_peaks', 'nefertiti',
                    'patch-01', 'mesh_with_border', 'cylinder', 'poly2x^2+y^2-0.062500']
STRATEGY_MESHES = ['cylinder', 'cylinder_locally_refined', 'three_peaks', 'poly2x^2+y^2-0.062500']
DEFAULTS_MESHES = ['lion-head', 'mannequin-devil', 'three_peaks', 'mushroom', 'nefertiti', 'mesh_with_border',
                   'cylinder']
OPTIMAL_MESHES = ['nefertiti', 'patch-01', 'mesh_with_border', 'mushroom', 'three_peaks', 'lion-head',
                  'mannequin-devil', 'cylinder', 'cylinder_locally_refined', 'patch-13', 'patch-20', 'patch-21',
                  'patch-23', 'patch-30', 'plane', 'poly2x^2+y^2-0.062500', 'oblong-shuffled', 'blob', 'fold',
                  'open_cube', 'hedra_open']
MEASURES = ['L2', 'Linf', 'Sym. Dir.', 'Angles']


def plain(cell):
    """a cell without its markup, and without the number of faces after the name of a mesh"""
    cell = re.sub(r'\*\*|</?b>|`', '', cell).strip()
    return re.sub(r' \(\d+\)$', '', cell)


def read_table(path, header):
    """the rows below a header line that begins with `header`, in plain cells; empty first cells repeat the last"""
    lines = path.read_text().splitlines()
    starts = [i for i, line in enumerate(lines) if line.startswith(header)]
    if len(starts) != 1:
        sys.exit("%s has %d tables that begin with '%s'" % (path.name, len(starts), header))
    rows = []
    for line in lines[starts[0] + 2:]:
        if not line.startswith('|'):
            break
        cells = [plain(cell) for cell in line.strip().strip('|').split('|')]
        rows.append([cells[0] or rows[-1][0]] + cells[1:])
    return rows


class Runner:
    """runs programs, each once with the same arguments, and keeps what they print"""

    def __init__(self, arguments):
        self.bin, self.meshes, self.output = arguments.bin, arguments.meshes, arguments.output
        self.reuse, self.done = arguments.reuse, set()
        self.output.mkdir(parents=True, exist_ok=True)

    def __call__(self, name, command):
        kept = self.output / (name + '.txt')
        if not ((self.reuse and kept.exists()) or kept in self.done):
            self.done.add(kept)
            print('  ' + ' '.join(str(word) for word in command), file=sys.stderr, flush=True)
            unfinished = kept.with_suffix('.part')
            with open(unfinished, 'w') as output:
                subprocess.run(command, stdout=output, cwd=self.output, check=True)
            unfinished.rename(kept)
        return kept.read_text()

    def files(self, names):
        return [str(self.meshes / (name + '.off')) for name in names]

    def map(self, mesh, *options):
        """the report of square_map with one thread"""
        name = 'square_map-' + mesh + ''.join(options)
        command = [self.bin / 'square_map', *self.files([mesh]), '--threads', '1', '--quiet', '--json', '-', *options]
        return json.loads(self(name, command))


# Each of the functions below runs a program and returns its figures: {(row, ..., column): value}. Columns that begin
# with 'seconds' have the noise of seconds.

def strategies(run):
    printed = run('strategies', [run.bin / 'paper_tables', *run.files(STRATEGY_MESHES), '--generated'])
    figures = {}
    for line in printed[printed.index('How often'):printed.index('misses:')].splitlines()[2:]:
        if line:
            name, found, _, evaluations = line.split()
            figures[name, 'maps made'], figures[name, 'found'] = float(evaluations), float(found)
    return figures


def strategies_in_readme():
    figures = {}
    for row in read_table(README, '| `--strategy` | Maps made'):
        if row[2]:
            numbers = re.findall(r'\d+', row[2])
            name = row[0].split()[0]
            figures[name, 'maps made'], figures[name, 'found'] = numbers[0], numbers[1]
    return figures


METHOD_NAMES = {'CGAL iterative authalic': 'CGAL iterative authalic, 15 iterations',
                'iteration (quarter br. f.)': 'iteration, quarter brute force',
                'optimal (one candidate)': 'optimal, one candidate',
                'optimal (default search)': 'default (optimal, bracketing)'}


def methods(run):
    table = run.output / 'methods.csv'
    if not (run.reuse and table.exists()):
        run('methods', ['taskset', '-c', '0', run.bin / 'fixed_border_methods', *run.files(BENCHMARK_MESHES),
                        '--split-chords', '--repetitions', '5', '--csv', table])
    figures = {}
    for line in table.read_text().splitlines()[1:]:
        mesh, method, maps, seconds, _, l2, linf, dirichlet, flips = line.split(',')[:9]
        key = (mesh, METHOD_NAMES.get(method, method))
        for column, value in zip(['maps', 'seconds', 'L2', 'Linf', 'Sym. Dir.', 'flips'],
                                 [maps, seconds, l2, linf, dirichlet, flips]):
            figures[key + (column,)] = float(value)
    return figures


def methods_in_readme():
    return {(row[0], row[1], column): cell for row in read_table(README, '| Mesh (faces) | Method ')
            for column, cell in zip(['maps', 'seconds', 'L2', 'Linf', 'Sym. Dir.', 'flips'], row[2:])}


CLOSED_COLUMNS = ['L2', 'cut', 'balance 0: L2', 'balance 0: cut', 'seconds']


def closed_surfaces(run):
    figures = {}
    for mesh in [row[0] for row in read_table(README, '| Mesh (faces) | L2 | Cut')]:
        default, sharp = run.map(mesh), run.map(mesh, '--balance', '0')
        values = [default['best']['l2'], default['conditioned']['cut_length'], sharp['best']['l2'],
                  sharp['conditioned']['cut_length'], sharp['seconds']['cut'] + sharp['seconds']['search']]
        figures.update({(mesh, column): value for column, value in zip(CLOSED_COLUMNS, values)})
    return figures


def closed_surfaces_in_readme():
    return {(row[0], column): cell for row in read_table(README, '| Mesh (faces) | L2 | Cut')
            for column, cell in zip(CLOSED_COLUMNS, row[1:])}


def cut_disks(run):
    figures = {}
    for mesh in [name for row in read_table(README, '| Mesh (faces) | L2, whole') for name in row[0].split(', ')]:
        cut = run.map(mesh, '--cut-disk')
        figures[mesh, 'whole'] = run.map(mesh)['best']['l2']
        figures[mesh, 'L2'], figures[mesh, 'cut'] = cut['best']['l2'], cut['conditioned']['cut_length']
    return figures


def cut_disks_in_readme():
    figures = {}
    for row in read_table(README, '| Mesh (faces) | L2, whole'):
        if row[2] == 'not cut':
            figures.update({(mesh, 'cut'): '0' for mesh in row[0].split(', ')})
        else:
            figures.update({(row[0], column): cell for column, cell in zip(['whole', 'L2', 'cut'], row[1:])})
    return figures


CUT_WEIGHTS = ['0.0125', '0.025', '0.05', '0.1', '0.2']


def cut_weights(run):
    """L2 plus weight times length of the cut for each weight, and by how much the cut for another weight is better there"""
    figures = {}
    for mesh in [row[0] for row in read_table(MANUAL, '| Mesh | 0.0125')]:
        jobs = [run.map(mesh, '--cut-weight', weight) for weight in CUT_WEIGHTS]
        beaten = 0
        for weight, job in zip(CUT_WEIGHTS, jobs):
            scores = [j['best']['l2'] + float(weight) * j['conditioned']['cut_length'] for j in [job] + jobs]
            figures[mesh, weight] = scores[0]
            beaten = max(beaten, 100 * (scores[0] / min(scores) - 1))
        figures[mesh, 'beaten by'] = beaten
    return figures


def cut_weights_in_manual():
    return {(row[0], column): cell.replace(' %', '') for row in read_table(MANUAL, '| Mesh | 0.0125')
            for column, cell in zip(CUT_WEIGHTS + ['beaten by'], row[1:])}


def optimal_map_output(run):
    return run('optimal_maps', [run.bin / 'optimal_map_tables', *run.files(OPTIMAL_MESHES), '--generated'])


BALANCE_COLUMNS = MEASURES + ['s1']


def balances(run):
    printed = optimal_map_output(run)
    figures, mesh = {}, None
    for line in printed[:printed.index('\nL2 at balance')].splitlines()[1:]:
        if not line.startswith('  '):
            mesh = line.split(',')[0]
            continue
        values = [float(value) for value in line[26:].split()]
        figures.update({(mesh, line[2:26].strip(), column): value for column, value in zip(BALANCE_COLUMNS, values)})
    return figures


def balances_in_manual():
    return {(row[0], row[1], column): cell for row in read_table(MANUAL, '| Mesh | Map | L2 ')
            for column, cell in zip(BALANCE_COLUMNS, row[2:])}


def say_where_worse(figures):
    """whether balance 0.3 is as good as the maps by brute force in each measure"""
    meshes = list(dict.fromkeys(mesh for mesh, _, _ in figures))
    for method in ['paper, brute force', 'iteration, brute force']:
        worse = {mesh: ['%s (%.4g, not %.4g)' % (m, figures[mesh, 'balance 0.3', m], figures[mesh, method, m])
                        for m in MEASURES if figures[mesh, 'balance 0.3', m] > figures[mesh, method, m]]
                 for mesh in meshes}
        print('  balance 0.3 is as good as %s in all measures on %d of %d meshes; worse: %s' %
              (method, sum(not where for where in worse.values()), len(meshes),
               ', '.join('%s in %s' % (mesh, ' and '.join(where)) for mesh, where in worse.items() if where)))


def balance_means(run):
    figures = balances(run)
    say_where_worse(figures)
    logarithms = collections.defaultdict(list)
    for (_, row, column), value in figures.items():
        if row.startswith('balance ') and column in MEASURES:
            logarithms[row.split()[1], column].append(math.log(value))
    means = {key: statistics.mean(values) for key, values in logarithms.items()}
    least = {column: min(mean for (_, c), mean in means.items() if c == column) for column in MEASURES}
    return {(balance, column): 100 * math.expm1(mean - least[column]) for (balance, column), mean in means.items()}


def balance_means_in_manual():
    return {(row[0], column): cell for row in read_table(MANUAL, '| balance | L2 ')
            for column, cell in zip(MEASURES, row[1:])}


GAIN_COLUMNS = ['iteration: first', 'iteration: best', 'fixed: first', 'fixed: best', 'sliding: first', 'sliding: best']


def gains(run):
    printed = optimal_map_output(run)
    figures = {}
    for line in printed[printed.index('L2 at balance'):printed.index('\nBracketing')].splitlines()[2:]:
        if line:
            values = [float(value) for value in line[28:].split()]
            figures.update({(line[:28].strip(), column): value for column, value in zip(GAIN_COLUMNS, values)})
    mean = {column: statistics.mean(math.log(v) for (_, c), v in figures.items() if c == column)
            for column in GAIN_COLUMNS}
    for worse, better in [(0, 1), (1, 3), (3, 5), (4, 5)]:
        print('  %s saves %.1f %% against %s' % (GAIN_COLUMNS[better], 100 * (
            1 - math.exp(mean[GAIN_COLUMNS[better]] - mean[GAIN_COLUMNS[worse]])), GAIN_COLUMNS[worse]))
    print('  bracketing: ' + printed.splitlines()[-1])
    return figures


def gains_in_manual():
    return {(row[0], column): cell for row in read_table(MANUAL, '| Mesh | iteration: first')
            for column, cell in zip(GAIN_COLUMNS, row[1:])}


def iteration_rows(run):
    """{(weights, eta, patience): [L2 per mesh]}, infinite where there is no map"""
    printed = run('iteration_defaults', [run.bin / 'iteration_defaults', *run.files(DEFAULTS_MESHES)])
    rows = {}
    for line in printed.replace('no map', 'inf').splitlines()[3:]:
        weights, eta, patience, *cells = line.split()
        rows[weights.replace('-', ' '), eta, patience] = [float(cell) for cell in cells[::2]]
    return rows


def weights(run):
    return {(name, mesh): l2 for (name, *numbers), row in iteration_rows(run).items() if numbers == ['0.3', '1']
            for mesh, l2 in zip(DEFAULTS_MESHES, row)}


def weights_in_manual():
    return {(row[0].replace('-', ' '), mesh): cell.replace('no map', 'inf')
            for row in read_table(MANUAL, '| Weights | lion-head') for mesh, cell in zip(DEFAULTS_MESHES, row[1:])}


def exponents(run):
    rows = iteration_rows(run)
    patient = {tuple(row) for (name, eta, _), row in rows.items() if (name, eta) == ('blended', '0.3')}
    print('  a patience of 0, 1 or 3 makes %s' % ('no difference' if len(patient) == 1 else 'a difference'))
    return {(eta, mesh): l2 for (name, eta, patience), row in rows.items() if (name, patience) == ('blended', '1')
            for mesh, l2 in zip(DEFAULTS_MESHES, row)}


def exponents_in_manual():
    return {(row[0], mesh): cell for row in read_table(MANUAL, '| \\f$ \\eta \\f$ | lion-head')
            for mesh, cell in zip(DEFAULTS_MESHES, row[1:])}


SPLINE_COLUMNS = ['mean value', 'iterative authalic', 'parameterize_onto_square()']


def splines(run):
    figures = {}
    for mesh in dict.fromkeys(row[0] for row in read_table(README, '| Mesh | Control points')):
        lines = run('spline-' + mesh, [run.bin / 'fit_bspline_surface', *run.files([mesh])]).splitlines()
        for size, *errors in (line.split() for line in lines[2:]):
            size = size.removesuffix('^2')
            figures.update({(mesh, size, column): float(x) for column, x in zip(SPLINE_COLUMNS, errors)})
    return figures


def splines_in_readme():
    return {(row[0], row[1].split()[0], column): cell for row in read_table(README, '| Mesh | Control points')
            for column, cell in zip(SPLINE_COLUMNS, row[2:])}


POLYGON_COLUMNS = ['L2 between corners', 'L2 with points', 'seconds with points']


def polygons(run):
    table = run.output / 'polygons.csv'
    if not (run.reuse and table.exists()):
        run('polygons', [pathlib.Path(__file__).parent / 'polygons.py', '--bin', run.bin, '--csv', table])
    with open(table, newline='', encoding='utf-8') as lines:
        rows = list(csv.DictReader(lines))
    return {(row['polygon'], column): float(row[column]) for row in rows for column in POLYGON_COLUMNS}


def polygons_in_manual():
    return {(row[0], column): cell for row in read_table(MANUAL, '| Polygon of 2000 corners')
            for column, cell in zip(POLYGON_COLUMNS, row[1:])}


TABLES = {
    'polygons': (polygons, polygons_in_manual),
    'splines': (splines, splines_in_readme),
    'strategies': (strategies, strategies_in_readme),
    'methods': (methods, methods_in_readme),
    'closed-surfaces': (closed_surfaces, closed_surfaces_in_readme),
    'cut-disks': (cut_disks, cut_disks_in_readme),
    'cut-weights': (cut_weights, cut_weights_in_manual),
    'weights': (weights, weights_in_manual),
    'exponents': (exponents, exponents_in_manual),
    'balances': (balances, balances_in_manual),
    'balance-means': (balance_means, balance_means_in_manual),
    'gains': (gains, gains_in_manual)}


def has_moved(column, written, measured, speed):
    """whether a figure, as it is written, differs by more than its noise"""
    value = float(written)
    if column.startswith('seconds'):
        difference = abs(measured / speed - value)
        return difference > max(RELATIVE_NOISE * value, LEAST_NOISE)
    if math.isinf(value) or math.isinf(measured):
        return value != measured
    decimals = len(written.partition('.')[2])
    return abs(measured - value) > 1.001 * 10 ** -decimals


def compare(name, measured, written):
    """prints the figures of a table that have moved; returns their number"""
    ratios = [measured[key] / float(cell) for key, cell in written.items()
              if key[-1].startswith('seconds') and key in measured and float(cell) > 0]
    speed = statistics.median(ratios) if ratios else 1
    moved = 0
    for key, cell in written.items():
        if key not in measured:
            moved += 1
            print('  %s: %s is not measured' % (', '.join(key), cell))
        elif has_moved(key[-1], cell, measured[key], speed):
            moved += 1
            print('  %s: %s is now %.6g' % (', '.join(key), cell, measured[key]))
    times = '; seconds are %.2f times those written' % speed if ratios else ''
    print('%s: %d of %d figures have moved%s' % (name, moved, len(written), times), flush=True)
    return moved


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('tables', nargs='*', metavar='TABLE', help='of: ' + ', '.join(TABLES))
    parser.add_argument('--bin', type=pathlib.Path, default=REPOSITORY / 'build/bin')
    parser.add_argument('--meshes', type=pathlib.Path, default=REPOSITORY / 'build/data/meshes')
    parser.add_argument('--output', type=pathlib.Path, default=REPOSITORY / 'build/tables')
    parser.add_argument('--reuse', action='store_true', help='take what is in the output folder instead of running')
    arguments = parser.parse_args()
    for path in ['bin', 'meshes', 'output']:
        setattr(arguments, path, getattr(arguments, path).resolve())
    unknown = [name for name in arguments.tables if name not in TABLES]
    if unknown:
        parser.error("there is no table '%s'" % unknown[0])
    run = Runner(arguments)
    moved = 0
    for name in arguments.tables or TABLES:
        measure, read = TABLES[name]
        moved += compare(name, measure(run), read())
    sys.exit(1 if moved else 0)


if __name__ == '__main__':
    main()
