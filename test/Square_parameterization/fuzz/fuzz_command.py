#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Disturbs runs of square_map that have several outputs, at random moments: by signals, by a reader of the report that
goes away, by a time limit, by little memory. After each run all outputs are there, whole, or all are as they were; no
other file is left; and the exit status is the one that is documented.

One line for each run in which that does not hold, and for every hundredth; exits 1 when there was one. The same seed
gives the same runs, but for the moments, which are shares of the time that a run takes on the machine.
"""
import argparse
import json
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]
DONE, BAD_COMMAND_LINE, UNMAPPABLE, NO_MAP = 0, 2, 4, 5
NO_LOADER = 127  # there is no memory even for the libraries
DISTURBANCES = ['signals', 'reader', 'time-limit', 'memory']
SECONDS = 300  # a run that takes longer hangs


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('square_map', type=pathlib.Path)
    parser.add_argument('--seed', type=int, default=0, help='of the first run; default 0')
    parser.add_argument('--count', type=int, default=0, help='how many runs; 0 (default): until the time is up')
    parser.add_argument('--seconds', type=float, default=300, help='how long, without --count; default 300')
    parser.add_argument('--disturbances', default=','.join(DISTURBANCES), metavar='NAMES',
                        help='of %(default)s; memory cannot be limited for a program with sanitizers')
    return parser.parse_args()


def wavy_sheet(n):
    """n x n cells as an OFF file"""
    points = ['%g %g %g' % (i, j, math.sin(i) * math.cos(0.7 * j)) for i in range(n + 1) for j in range(n + 1)]
    faces = []
    for i in range(n):
        for j in range(n):
            a, b = i * (n + 1) + j, (i + 1) * (n + 1) + j
            faces += ['3 %d %d %d' % (a, b, b + 1), '3 %d %d %d' % (a, b + 1, a + 1)]
    return '\n'.join(['OFF', '%d %d 0' % (len(points), len(faces))] + points + faces) + '\n'


def bipyramid(n):
    """a closed surface of 2 n faces as an OFF file"""
    points = ['%g %g 0' % (math.cos(2 * math.pi * k / n), math.sin(2 * math.pi * k / n)) for k in range(n)]
    points += ['0 0 1', '0 0 -1']
    faces = ['3 %d %d %d' % (n, k, (k + 1) % n) for k in range(n)]
    faces += ['3 %d %d %d' % (n + 1, (k + 1) % n, k) for k in range(n)]
    return '\n'.join(['OFF', '%d %d 0' % (len(points), len(faces))] + points + faces) + '\n'


INPUTS = {'sheet': wavy_sheet(12), 'large sheet': wavy_sheet(40), 'bipyramid': bipyramid(30)}


class Run:
    """one run in a folder of its own, and what is wrong with its end"""

    def __init__(self, square_map, seed, disturbances, times):
        self.random = random.Random(seed)
        self.square_map = square_map
        self.input = self.random.choice(sorted(INPUTS))
        self.options = self.random.choice([[], ['--strategy', 'brute-force'], ['--minimizer', 'iterative']])
        if self.options == ['--strategy', 'brute-force'] and self.input == 'large sheet':
            self.options = ['--strategy', 'none']
        self.options = self.options + ['--threads', str(self.random.choice([1, 2, 4]))]
        self.map_name = 'map.' + self.random.choice(['obj', 'off', 'ply', 'stl'])
        self.disturbance = self.random.choice(disturbances)
        self.sent = []
        self.times = times  # of undisturbed runs

    def __str__(self):
        sent = ', '.join('%s at %.4f s' % (signal.Signals(s).name, at) for s, at in self.sent)
        return ' '.join([self.input, self.map_name] + self.options) + ': ' + self.disturbance + ' ' + sent

    def seconds(self):
        """what an undisturbed run takes"""
        key = (self.input, tuple(self.options))
        if key not in self.times:
            with tempfile.TemporaryDirectory() as folder:
                start = time.monotonic()
                path = pathlib.Path(folder) / 'in.off'
                path.write_text(INPUTS[self.input])
                subprocess.run([self.square_map, path, '-q', '-o', path.parent / 'map.obj'] + self.options, check=True,
                               timeout=SECONDS)
                self.times[key] = time.monotonic() - start
        return self.times[key]

    def moment(self):
        """in seconds from the start; often near the end, when outputs are written"""
        share = self.random.uniform(0, 1.1) if self.random.random() < 0.5 else self.random.gauss(1, 0.05)
        return max(0, share * self.seconds())

    def __call__(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / 'in.off').write_text(INPUTS[self.input])
            olds = {}
            outputs = [self.map_name] + (['report.json'] if self.disturbance != 'reader' else [])
            for output in outputs:
                if self.random.random() < 0.5:
                    olds[output] = 'the old ' + output
                    (folder / output).write_text(olds[output])
            options = ['-o', folder / self.map_name] + self.options
            options += ['--json', folder / 'report.json' if self.disturbance != 'reader' else '-']
            if self.disturbance == 'time-limit':
                options += ['--time-limit', '%g' % max(1e-4, self.moment())]
            status, messages = self.run([self.square_map, folder / 'in.off'] + options)
            return self.problems(status, messages, folder, olds, outputs)

    def run(self, command):
        limit = self.random.randrange(4 << 20, 120 << 20) if self.disturbance == 'memory' else 0
        process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            preexec_fn=(lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))) if limit else None)
        start = time.monotonic()

        def disturb():
            if self.disturbance == 'signals':
                moments = sorted(self.moment() for _ in range(self.random.choice([1, 1, 2, 3])))
                if self.random.random() < 0.3:  # one just after the other
                    moments = [moments[0] + 1e-4 * k for k in range(len(moments))]
                for at in moments:
                    time.sleep(max(0, start + at - time.monotonic()))
                    if process.poll() is None:
                        self.sent.append((self.random.choice(SIGNALS), at))
                        process.send_signal(self.sent[-1][0])
            elif self.disturbance == 'reader':
                time.sleep(self.moment())
                process.stdout.close()

        disturber = threading.Thread(target=disturb)
        disturber.start()
        try:
            messages = process.stderr.read().decode(errors='replace')
            process.wait(SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            messages = 'it hangs'
        disturber.join()
        return process.returncode, messages

    def problems(self, status, messages, folder, olds, outputs):
        problems = []
        left = {path.name for path in folder.iterdir()}
        texts = {name: (folder / name).read_bytes() for name in outputs if name in left}
        is_old = all(texts.get(name) == (olds[name].encode() if name in olds else None) for name in outputs)
        is_new = all(name in texts and self.is_whole(name, texts[name]) for name in outputs)
        if not is_old and not is_new:
            problems.append('the outputs are neither the old ones nor the new ones')
        strangers = left - {'in.off'} - set(outputs)
        if strangers:
            problems.append('left behind: ' + ', '.join(sorted(strangers)))
        if status not in self.expected_statuses():
            problems.append('exit status %d' % status)
        if status == DONE and not is_new:
            problems.append('done, but there is no map')
        if status != DONE and not is_old and len(self.sent) < 2:
            problems.append('exit status %d, but outputs are written' % status)
        if 'no file was replaced' in messages and not is_old:
            problems.append('something was written')
        if 'Sanitizer' in messages or 'runtime error' in messages:
            problems.append('a sanitizer complains')
        if problems:
            problems.append(messages.strip())
        return problems

    def expected_statuses(self):
        if self.disturbance == 'signals':
            # before the program has begun a signal ends it as it ends every program
            return {DONE} | {128 + s for s, _ in self.sent} | {-s for s, _ in self.sent}
        return {DONE, {'reader': BAD_COMMAND_LINE, 'time-limit': NO_MAP, 'memory': UNMAPPABLE}[self.disturbance],
                NO_LOADER if self.disturbance == 'memory' else DONE}

    def is_whole(self, name, text):
        if name == 'report.json':
            try:
                return bool(json.loads(text))
            except ValueError:
                return False
        faces = INPUTS[self.input].split()[2]
        ends = {'map.obj': b'f ', 'map.off': b'3 ', 'map.ply': b'', 'map.stl': b''}
        return (len(text) > 40 * int(faces) // 4 and not text.startswith(b'the old') and
                text.rstrip().splitlines()[-1].startswith(ends[name]))


def main():
    arguments = parse_arguments()
    disturbances = arguments.disturbances.split(',')
    if not set(disturbances) <= set(DISTURBANCES):
        sys.exit('disturbances are: ' + ', '.join(DISTURBANCES))
    os.environ['LC_ALL'] = 'C'
    for ignored in SIGNALS:
        signal.signal(ignored, signal.SIG_DFL)
    times, wrong, done, start = {}, 0, 0, time.monotonic()
    while done < arguments.count if arguments.count else time.monotonic() - start < arguments.seconds:
        run = Run(arguments.square_map.resolve(), arguments.seed + done, disturbances, times)
        problems = run()
        if problems:
            print('%d: %s: WRONG: %s' % (arguments.seed + done, run, '; '.join(problems)), flush=True)
            wrong += 1
        done += 1
        if done % 100 == 0:
            print('%d runs, %d wrong, %.0f s' % (done, wrong, time.monotonic() - start), flush=True)
    print('%d runs, %d wrong' % (done, wrong))
    sys.exit(1 if wrong else 0)


if __name__ == '__main__':
    main()
