#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps every OFF file of a folder with square_map and prints what became of each.

One line a file: exit status, vertices, faces, seam edges, cut length in units of sqrt(area), L2 stretch, seconds; or the
reason of a refusal. Then a summary by exit status, with the slowest file and the one that took most memory. Each file
has 10 minutes and 4 GB; a run that takes more is reported as 'time' or, where the command itself does not notice, by
its signal. Exits 1 when a file ended in another way than the documented exit statuses 0, 3, 4 and 5.

Options after -- go to square_map.
"""
import argparse
import collections
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 600
BYTES = 4 << 30


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder', nargs='?', type=pathlib.Path, default=REPOSITORY / 'build/data/meshes')
    parser.add_argument('--square-map', type=pathlib.Path, default=REPOSITORY / 'build/bin/square_map')
    parser.add_argument('--keep', type=pathlib.Path, metavar='FOLDER', help='where the maps are kept as OBJ files')
    arguments = sys.argv[1:]
    end = arguments.index('--') if '--' in arguments else len(arguments)
    return parser.parse_args(arguments[:end]), arguments[end + 1:]


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))


def map_file(square_map, path, output, options):
    """runs the command; returns its status, its report or None, its last message, and the seconds it took"""
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / 'report.json'
        command = [square_map, path, '-o', output or pathlib.Path(folder) / 'map.obj', '--json', report, '--quiet']
        try:
            finished = subprocess.run(command + options, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                      errors='replace', timeout=SECONDS, preexec_fn=limit_memory)
        except subprocess.TimeoutExpired:
            return 'time', None, 'more than %d seconds' % SECONDS, time.monotonic() - start
        message = (finished.stderr.strip().splitlines() or [''])[-1]
        result = json.loads(report.read_text()) if finished.returncode == 0 else None
    return finished.returncode, result, message, time.monotonic() - start


def main():
    arguments, options = parse_arguments()
    files = sorted(arguments.folder.glob('*.off'))
    if not files:
        sys.exit("no OFF files in '%s'" % arguments.folder)
    if arguments.keep:
        arguments.keep.mkdir(parents=True, exist_ok=True)
    statuses = collections.Counter()
    slowest = largest = (0, '')
    print('%-28s %6s %8s %8s %6s %7s %8s %8s' % ('file', 'status', 'V', 'F', 'seams', 'length', 'L2', 'seconds'))
    for path in files:
        output = arguments.keep / (path.stem + '.obj') if arguments.keep else None
        status, result, message, seconds = map_file(arguments.square_map, path, output, options)
        statuses[status] += 1
        slowest = max(slowest, (seconds, path.stem))
        # of all children so far: it grows with the file that takes more than those before it
        largest = max(largest, (resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024, path.stem),
                      key=lambda entry: entry[0])
        if result:
            conditioned = result['conditioned']
            print('%-28s %6s %8d %8d %6d %7.3f %8.4f %8.2f' %
                  (path.stem, status, conditioned['vertices'], conditioned['faces'], conditioned['seam_edges'],
                   conditioned['cut_length'], result['best']['l2'], seconds), flush=True)
        else:
            print('%-28s %6s %s (%.2f s)' % (path.stem, status, message, seconds), flush=True)
    print('\n%d files: ' % len(files) +
          ', '.join('%d with status %s' % (count, status) for status, count in sorted(statuses.items(), key=str)))
    print('slowest: %s, %.1f s; most memory: %s, %.0f MiB' % (slowest[1], slowest[0], largest[1], largest[0]))
    sys.exit(0 if set(statuses) <= {0, 3, 4, 5} else 1)


if __name__ == '__main__':
    main()
