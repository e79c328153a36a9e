# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs whole jobs of square_map, each in a process of its own, for whole_job.py, growth.py and threads.py."""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PHASES = ['read', 'condition', 'cut', 'search', 'final', 'write']


def parser(description):
    result = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('--bin', type=pathlib.Path, default=REPOSITORY / 'build/bin', help='folder of the programs')
    result.add_argument('--csv', type=pathlib.Path, help='write the table to this file, too')
    result.add_argument('--repeat', type=int, default=3, help='the least time of so many runs counts; default 3')
    return result


def processor():
    """the name of the processor"""
    for line in open('/proc/cpuinfo', encoding='utf-8'):
        if line.startswith('model name'):
            return line.split(':', 1)[1].strip()
    return 'unknown'


def write_off(path, points, faces):
    with open(path, 'w', encoding='ascii') as file:
        file.write('OFF\n%d %d 0\n' % (len(points), len(faces)))
        file.writelines('%.17g %.17g %.17g\n' % point for point in points)
        file.writelines('%d %s\n' % (len(face), ' '.join(map(str, face))) for face in faces)


class Programs:
    def __init__(self, arguments):
        self.bin, self.repeat = arguments.bin.resolve(), arguments.repeat
        self.folder = tempfile.TemporaryDirectory()

    def subdivided(self, mesh, times):
        """a file with the mesh, subdivided"""
        if times == 0:
            return pathlib.Path(mesh).resolve()
        path = pathlib.Path(self.folder.name) / ('%s-%d.off' % (pathlib.Path(mesh).stem, times))
        if not path.exists():
            subprocess.run([self.bin / 'subdivide', mesh, str(times), path], check=True)
        return path

    def yardstick(self, path, *options, limit=None):
        """processor seconds; None when it does not end in time, or fails"""
        try:
            run = subprocess.run([self.bin / 'yardstick', path, *options], capture_output=True, text=True,
                                 timeout=limit, cwd=self.folder.name, check=False)
        except subprocess.TimeoutExpired:
            return None
        return float(run.stdout) if run.returncode == 0 else None

    def seconds_at_once(self, path, count, *options):
        """seconds of the clock of so many whole jobs at once, on one thread each: the least of several runs"""
        best = math.inf
        for _ in range(self.repeat):
            start = time.monotonic()
            jobs = [subprocess.Popen(self.command(path, 1, '%d' % i, *options)) for i in range(count)]
            statuses = [job.wait() for job in jobs]
            if any(statuses):
                sys.exit('%s: square_map ended with status %d' % (path, max(statuses, key=abs)))
            best = min(best, time.monotonic() - start)
        return best

    def command(self, path, threads, name, *options):
        """the command line of a whole job; the name is that of its outputs"""
        folder = pathlib.Path(self.folder.name)
        return [self.bin / 'square_map', path, '-o', folder / (name + '.obj'), '--json', folder / (name + '.json'),
                '--quiet', '--threads', str(threads), *options]

    def job(self, path, threads, *options):
        """seconds of processors and of the clock, memory and phases of one whole job: the least of several runs"""
        best = None
        for _ in range(self.repeat):
            start = time.monotonic()
            process = subprocess.Popen(self.command(path, threads, 'map', *options))
            _, status, usage = os.wait4(process.pid, 0)
            wall = time.monotonic() - start
            if os.waitstatus_to_exitcode(status) != 0:
                sys.exit('%s: square_map ended with status %d' % (path, os.waitstatus_to_exitcode(status)))
            result = json.loads((pathlib.Path(self.folder.name) / 'map.json').read_text())
            job = {'seconds': usage.ru_utime + usage.ru_stime, 'wall': wall, 'kilobytes': usage.ru_maxrss,
                   'faces': result['conditioned']['faces'], 'phases': result['seconds'],
                   'energy': result['best']['energy'], 'l2': result['best']['l2']}
            if best is None or job['wall' if threads != 1 else 'seconds'] < best['wall' if threads != 1 else 'seconds']:
                best = job
        return best


def print_table(columns, rows, path):
    """Markdown on standard output, and CSV"""
    print('| ' + ' | '.join(columns) + ' |\n' + '|---' * len(columns) + '|')
    for row in rows:
        print('| ' + ' | '.join('%.4g' % cell if isinstance(cell, float) else str(cell) for cell in row) + ' |')
    if path:
        with open(path, 'w', newline='', encoding='utf-8') as output:
            csv.writer(output).writerows([columns, *rows])
