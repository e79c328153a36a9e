#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole jobs of square_map on one core: seconds of the processor by phase, memory, and the ratio to a yardstick that
measures the machine, one sparse factorization of the mesh's Laplacian (see yardstick.cpp). With --iterative-authalic
CGAL's parameterizer of that name runs beside it, where it ends within ten minutes and the mesh is a disk.

    whole_job.py build/data/meshes/lion-head.off --subdivide 3
"""
import measured_jobs


def main():
    parser = measured_jobs.parser(__doc__)
    parser.add_argument('meshes', nargs='+')
    parser.add_argument('--subdivide', type=int, default=0, help='also each mesh subdivided once, twice, ... so often')
    parser.add_argument('--iterative-authalic', action='store_true')
    parser.add_argument('--options', default='', help='options of square_map, separated by blanks')
    arguments = parser.parse_args()
    programs = measured_jobs.Programs(arguments)
    columns = ['mesh', 'faces', *measured_jobs.PHASES, 'seconds', 'yardstick', 'ratio', 'kB a face', 'energy']
    if arguments.iterative_authalic:
        columns.append('CGAL iterative authalic')
    rows = []
    for mesh in arguments.meshes:
        for times in range(arguments.subdivide + 1):
            path = programs.subdivided(mesh, times)
            job, yardstick = programs.job(path, 1, *arguments.options.split()), programs.yardstick(path)
            row = [path.stem, job['faces'], *(float(job['phases'][phase]) for phase in measured_jobs.PHASES),
                   job['seconds'], yardstick, job['seconds'] / yardstick, job['kilobytes'] / job['faces'],
                   '%.6f' % job['energy']]
            if arguments.iterative_authalic:
                row.append(programs.yardstick(path, '--iterative-authalic', limit=600) or 'none')
            rows.append(row)
    print('One core, %s\n' % measured_jobs.processor())
    measured_jobs.print_table(columns, rows, arguments.csv)


if __name__ == '__main__':
    main()
