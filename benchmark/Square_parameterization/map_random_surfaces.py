#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps random small surfaces with square_map, every second one with random options, and checks each map.

The surfaces are those of the fuzzer, which build/bin/random_surfaces writes; the checker reads nothing but the map. A
run is wrong when it crashes or hangs, exits with a status that is not documented, gives a map that is not one-to-one or
has another stretch than the report says, leaves a file that it should not, or one is missing. With default settings and
one thread it has a limit of processor time, too: 2 seconds for a disk and 5 for another surface of at most 10000 faces,
1 for another one of at most 1000.

One line a surface that is wrong, has no map (exit status 5), or takes longer; a table at the end. Exits 1 when one was
wrong. A seed gives the same surface and options.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import random
import resource
import signal
import statistics
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
HANG = 150  # seconds of processor time, more than which is a hang
HANG_OF_CANDIDATE = 1  # the same for each vertex where all those of the border are mapped
DONE, BAD_COMMAND_LINE, BAD_FILE, UNMAPPABLE, NO_MAP = 0, 2, 3, 4, 5
STRATEGIES = ['bracketing', 'none', 'quarter-brute-force', 'brute-force', 'step-sampling', 'single-highest', 'many-high',
              'better-of-two', 'hybrid', 'particle-swarm']
WEIGHTS = ['blended', 'clamped-cotangent', 'uniform', 'mean-value', 'symmetric-mean-value', 'shape-preserving',
           'shape-preserving-plain', 'harmonic']


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--square-map', type=pathlib.Path, default=REPOSITORY / 'build/bin/square_map')
    parser.add_argument('--random-surfaces', type=pathlib.Path, default=REPOSITORY / 'build/bin/random_surfaces')
    parser.add_argument('--checker', type=pathlib.Path,
                        help='another checker beside check_map.py: called as that, it prints the problems; where it fails on '
                        'all maps the exit status is 1, too')
    parser.add_argument('--seed', type=int, default=0, help='of the first surface; default 0')
    parser.add_argument('--count', type=int, default=2000, help='how many surfaces; default 2000')
    parser.add_argument('--faces', type=int, default=2000, help='of the largest surfaces, about; default 2000')
    parser.add_argument('--keep', type=pathlib.Path, metavar='FOLDER', help='where surfaces with findings are kept')
    return parser.parse_args()


def read_faces(path):
    """the number of vertices and the faces of an OFF file of the generator"""
    words = path.read_text().split()
    vertices, count = int(words[1]), int(words[2])
    place, faces = 4 + 3 * vertices, []
    for _ in range(count):
        size = int(words[place])
        faces.append([int(word) for word in words[place + 1:place + 1 + size]])
        place += size + 1
    return vertices, faces


def random_options(choice, surface, folder):
    """options that have an effect beside one another; `choice` is a random.Random"""
    options = []

    def maybe(likelihood, *words):
        if choice.random() < likelihood:
            options.extend(str(word() if callable(word) else word) for word in words)
            return True
        return False

    maybe(0.9, '--component', lambda: choice.choice(['largest', '0', '0', '1']))
    maybe(0.9, '--triangulate')
    is_iterative = maybe(0.3, '--minimizer', 'iterative')
    if not is_iterative:
        maybe(0.3, '--balance', lambda: choice.choice([0, 1, choice.random()]))
        maybe(0.3, '--border', lambda: choice.choice(['fixed', 'sliding']))
        maybe(0.2, '--aspect', lambda: choice.choice(['best', 1, 2 ** choice.uniform(-3, 3)]))
    maybe(0.3, '--weights', lambda: choice.choice(WEIGHTS))
    maybe(0.1, '--eta', lambda: 1 - choice.random())
    maybe(0.1, '--patience', lambda: choice.randrange(4))
    maybe(0.3, '--threads', lambda: choice.randrange(5))
    maybe(0.1, '--time-limit', lambda: choice.choice([0.01, 0.1, 1]))
    vertices, faces = read_faces(surface)
    if maybe(0.1, '--corners', lambda: ','.join(str(choice.randrange(vertices)) for _ in range(4))):
        pass
    else:
        maybe(0.3, '--corner-rule', lambda: choice.choice(['nearest', 'author']))
        maybe(0.3, '--walk', lambda: choice.choice(['counter-clockwise', 'clockwise']))
        if maybe(0.5, '--strategy', lambda: choice.choice(STRATEGIES)):
            tuning = {'step-sampling': '--step', 'hybrid': '--interval', 'particle-swarm': '--seed'}
            if options[-1] in tuning:
                maybe(0.5, tuning[options[-1]], lambda: choice.randrange(20))
    if choice.random() < 0.1:
        sides = [(face[k - 1], face[k]) for face in faces for k in range(len(face))]
        seams = folder / 'seams.txt'
        seams.write_text(''.join('%d %d\n' % choice.choice(sides) for _ in range(choice.randrange(4))))
        options += ['--seams', str(seams)]
    elif not maybe(0.2, '--cut', lambda: choice.choice(['shortest', 'none'])):
        maybe(0.2, '--cut-weight', lambda: choice.choice([0, choice.random()]))
        maybe(0.2, '--max-cut-length', lambda: choice.choice([0, 10 * choice.random()]))
        maybe(0.2, '--cut-disk')
    return options


def hang_of(options, surface):
    """seconds of processor time, more than which is a hang"""
    return max(HANG, HANG_OF_CANDIDATE * read_faces(surface)[0]) if 'brute-force' in options else HANG


def run(command, hang):
    """exit status, messages, seconds of processor time; it is ended after `hang` seconds"""
    with tempfile.TemporaryFile() as messages:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=messages,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (hang, hang + 10)))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)  # it is waited for
        messages.seek(0)
        text = messages.read().decode(errors='replace').strip()
    return process.returncode, text, usage.ru_utime + usage.ru_stime


def call_checker(checker, path):
    """the report of a checker; None where it fails"""
    checked = subprocess.run([sys.executable, checker, path, '--json'], capture_output=True, text=True, check=False)
    try:
        return json.loads(checked.stdout)
    except ValueError:
        return None


def check_map(path, l2):
    """what is wrong with a map whose report says that the stretch is l2"""
    result = call_checker(pathlib.Path(__file__).with_name('check_map.py'), path)
    if result is None:
        return ['the checker fails']
    problems = ['invalid map: ' + problem for problem in result['problems']]
    if l2 is None:
        problems.append('the report tells no L2 stretch')
    elif not 0.999999 * result.get('least_l2', 0) <= l2 <= 1.000001 * result.get('l2', math.inf):
        problems.append('the L2 stretch is %.9g to %.9g, not %.9g' % (result['least_l2'], result['l2'], l2))
    return problems


def largest_component(faces):
    """the faces of the component that has most; components share no vertex"""
    parent = {}

    def root(vertex):
        while parent.setdefault(vertex, vertex) != vertex:
            parent[vertex] = vertex = parent[parent[vertex]]
        return vertex

    for face in faces:
        for vertex in face:
            parent[root(vertex)] = root(face[0])
    components = collections.defaultdict(list)
    for face in faces:
        components[root(face[0])].append(face)
    return max(components.values(), key=len)


def is_disk(faces):
    """whether a component has the Euler characteristic of a disk"""
    sides = {frozenset((face[k - 1], face[k])) for face in faces for k in range(len(face))}
    return len({vertex for face in faces for vertex in face}) - len(sides) + len(faces) == 1


def limit_of(report, surface):
    """seconds of processor time for a surface with default settings; the report is None where there is no map"""
    if report is None:
        faces = largest_component(read_faces(surface)[1])
        return 2 if is_disk(faces) else 1 if len(faces) <= 1000 else 5
    conditioned = report['conditioned']
    faces = conditioned['faces'] - 2 * conditioned['chords_split'] - conditioned['border_edges_split']
    if faces > 10000:
        return math.inf
    return 2 if conditioned['seam_edges'] == 0 else 1 if faces <= 1000 else 5


class Outcome:
    """what became of one surface"""

    def __init__(self, arguments, seed, surface):
        self.choice = random.Random(seed)
        self.is_default = seed % 2 == 0
        self.is_checked_twice = False
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / 'out').mkdir()
            self.options = (['--component', 'largest', '--triangulate', '--threads', '1'] if self.is_default else
                            random_options(self.choice, surface, folder))
            map_file, report_file = folder / 'out' / 'map.obj', folder / 'out' / 'report.json'
            self.status, self.messages, self.seconds = run(
                [arguments.square_map, surface, '-q', '-o', map_file, '--json', report_file] + self.options,
                hang_of(self.options, surface))
            self.report = json.loads(report_file.read_text()) if report_file.exists() else None
            self.problems = self.find_problems({path.name for path in (folder / 'out').iterdir()})
            if self.status == DONE and not self.problems:
                self.problems += check_map(map_file, self.report['best']['l2'])
                if arguments.checker:
                    checked = call_checker(arguments.checker, map_file)
                    self.is_checked_twice = checked is not None  # it may not be made for coordinates as these
                    self.problems += ['invalid map: ' + problem for problem in (checked or {'problems': []})['problems']]
        self.is_late = self.is_default and self.seconds > limit_of(self.report, surface)

    def find_problems(self, files):
        problems = []
        if self.status == 128 + signal.SIGXCPU:
            problems.append('hang')
        elif self.status not in (DONE, BAD_COMMAND_LINE, BAD_FILE, UNMAPPABLE, NO_MAP):
            problems.append('crash: exit status %d' % self.status)
        elif self.status == BAD_FILE and '--seams' not in self.options:
            problems.append('refused a file')
        elif self.status == BAD_COMMAND_LINE and not {'--corners', '--seams', '--component'} & set(self.options):
            problems.append('refused options')
        if files != ({'map.obj', 'report.json'} if self.status == DONE else set()):
            problems.append('files: ' + (', '.join(sorted(files)) or 'none'))
        if self.status != DONE and len(self.messages.splitlines()) != 1:
            problems.append('%d lines of messages' % len(self.messages.splitlines()))
        return problems

    def __str__(self):
        words = ['exit status %s' % self.status, '%.2f s' % self.seconds]
        if self.report:
            words.append('L2 %.4g' % self.report['best']['l2'])
        if self.messages:
            words.append(self.messages)
        return ', '.join((['WRONG: ' + '; '.join(self.problems)] if self.problems else []) +
                         (['LATE'] if self.is_late else []) + words + [' '.join(self.options)])


def print_table(outcomes):
    rows = [('default settings', [o for o in outcomes if o.is_default]),
            ('random options', [o for o in outcomes if not o.is_default])]
    print('\n%-18s %6s %7s %8s %8s %7s %6s %6s %6s %8s %8s' %
          ('', 'runs', 'mapped', 'refused', 'usage', 'no map', 'wrong', 'late', 'median', 'longest', 'L2 > 100'))
    for name, row in rows:
        statuses = collections.Counter(o.status for o in row)
        seconds = [o.seconds for o in row] or [0]
        print('%-18s %6d %7d %8d %8d %7d %6d %6s %6.2f %8.2f %8d' %
              (name, len(row), statuses[DONE], statuses[UNMAPPABLE],
               statuses[BAD_COMMAND_LINE] + statuses[BAD_FILE], statuses[NO_MAP],
               sum(bool(o.problems) for o in row),
               sum(o.is_late for o in row) if name == 'default settings' else '', statistics.median(seconds),
               max(seconds), sum(o.report is not None and o.report['best']['l2'] > 100 for o in row)))


def main():
    arguments = parse_arguments()
    if arguments.keep:
        arguments.keep.mkdir(parents=True, exist_ok=True)
    outcomes = []
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        with tempfile.TemporaryDirectory() as folder:
            written = subprocess.run([arguments.random_surfaces, '--seed', str(seed), '--count', '1', '--faces',
                                      str(arguments.faces), '--write', folder], capture_output=True, text=True, check=True)
            surface = pathlib.Path(folder) / ('%d.off' % seed)
            outcome = Outcome(arguments, seed, surface)
            has_no_map = outcome.status == NO_MAP and '--time-limit' not in outcome.options
            if outcome.problems or outcome.is_late or has_no_map:
                print('%s %s' % (written.stdout.rsplit(':', 1)[0], outcome), flush=True)
                if arguments.keep:
                    (arguments.keep / surface.name).write_bytes(surface.read_bytes())
        outcomes.append(outcome)
    print_table(outcomes)
    maps, checked_twice = sum(o.status == DONE for o in outcomes), sum(o.is_checked_twice for o in outcomes)
    if arguments.checker:
        print('\n%d of %d maps could be checked by %s, too' % (checked_twice, maps, arguments.checker.name))
    is_checker_used = not arguments.checker or maps == 0 or checked_twice > 0
    sys.exit(1 if any(o.problems for o in outcomes) or not is_checker_used else 0)


if __name__ == '__main__':
    main()
