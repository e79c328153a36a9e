#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many times as fast whole jobs of square_map are with 1, 2, 4, ... threads, up to the cores of this machine, by
phase and as a whole, in seconds of the clock. Cores share memory, caches and power: the column `throughput` tells what is
left of so many cores where as many jobs run at once, on one thread each, relative to one job. Fails when a map depends on
the number of threads.

    threads.py build/data/meshes/bunny00.off build/data/meshes/lion-head.off
"""
import os
import sys

import measured_jobs


def main():
    parser = measured_jobs.parser(__doc__)
    parser.add_argument('meshes', nargs='+')
    parser.add_argument('--subdivide', type=int, default=0, help='subdivide each mesh so often')
    parser.add_argument('--options', default='', help='options of square_map, separated by blanks')
    arguments = parser.parse_args()
    programs = measured_jobs.Programs(arguments)
    phases = ['condition', 'cut', 'search']
    rows = []
    for mesh in arguments.meshes:
        path = programs.subdivided(mesh, arguments.subdivide)
        options = arguments.options.split()
        alone = programs.seconds_at_once(path, 1, *options)
        threads, first = 1, None
        while threads <= (os.cpu_count() or 1):
            job = programs.job(path, threads, *options)
            first = first or job
            if job['energy'] != first['energy']:
                sys.exit('%s: the map depends on the number of threads' % path)
            at_once = programs.seconds_at_once(path, threads, *options) if threads > 1 else alone
            rows.append([path.stem, job['faces'], threads, job['wall'], first['wall'] / job['wall'], threads * alone / at_once,
                         *(first['phases'][phase] / max(job['phases'][phase], 1e-9) for phase in phases)])
            threads *= 2
    print('%s, %d cores\n' % (measured_jobs.processor(), os.cpu_count() or 1))
    measured_jobs.print_table(['mesh', 'faces', 'threads', 'seconds', 'speed-up', 'throughput', *phases], rows,
                              arguments.csv)


if __name__ == '__main__':
    main()
