#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The three steps of brute_force_on_many.sh: plan prints the slices that are left, map maps one of them, and finish maps
the best candidate of all."""
import argparse
import hashlib
import json
import math
import os
import shutil
import subprocess
import sys

from machine import faces_at_most, free_memory, memory_of, number_of_cores
from meshes import STATE, name_of, word_of
from options import Unusable, pairs, split_outputs, words_of
from state import check_command_line, keep_settings, read_settings, refuse, version_of

STRATEGIES = ('brute-force', 'quarter-brute-force')
REFUSED = {'--candidates': 'is what this script sets', '--curve': 'is what this script sets',
           '--corners': 'leaves nothing to search', '--time-limit': 'would leave candidates out',
           '--help': 'goes with square_map alone', '--version': 'goes with square_map alone'}
SHARE_OF_START = 20  # a slice takes so many times what it takes to read and cut the mesh, where that is possible
LEAST_SECONDS = 10  # of a slice


def parse_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('step', choices=['plan', 'finish'])
    parser.add_argument('program')
    parser.add_argument('mesh')
    parser.add_argument('work')
    parser.add_argument('--machines', type=int, default=1)
    end = words.index('--')  # the options of square_map come after it
    return parser.parse_args(words[:end]), words[end + 1:]


def search_and_outputs(words):
    """the options of the slices, with the strategy, and those of the outputs"""
    options = pairs(words)
    for name, _ in options:
        if name in REFUSED:
            raise Unusable('%s %s' % (name, REFUSED[name]))
    search, outputs = split_outputs(options)
    if '--strategy' not in dict(search):
        search.append(('--strategy', STRATEGIES[0]))
    if dict(search)['--strategy'] not in STRATEGIES:
        raise Unusable('--strategy is %s or %s' % STRATEGIES)
    search = [(name, os.path.abspath(value) if name == '--seams' else value) for name, value in search]
    return search, outputs


def slice_path(work, name):
    return os.path.join(os.fsdecode(work), 'slice-%s.json' % name)


def map_slice(program, mesh, work, name):
    """maps FIRST-LAST; the report takes its place when it is whole. Returns the status and the messages."""
    stage = os.path.join(os.fsdecode(work), os.fsdecode(STATE), 'work-%s-%d' % (name, os.getpid()))
    os.makedirs(stage)
    report = os.path.join(stage, 'report.json')
    done = subprocess.run([program, os.fsdecode(mesh), *read_settings(work)['arguments'], '--candidates',
                           name.replace('-', ':'), '--json', report, '--threads', '1', '--quiet'],
                          stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    if done.returncode == 0:
        os.replace(report, slice_path(work, name))
    shutil.rmtree(stage)
    return done.returncode, done.stderr


def slices_of(program, mesh, work, cores):
    """the slices as FIRST-LAST: chosen once by what the first candidate takes, and kept"""
    kept = os.path.join(work, STATE.decode(), 'slices.json')
    if not os.path.exists(kept):
        status, messages = map_slice(program, mesh, work, '0-0')
        if status != 0:
            sys.stderr.buffer.write(messages)
            sys.exit(status)
        with open(slice_path(work, '0-0'), encoding='utf-8') as file:
            report = json.load(file)
        count, seconds = report['candidates'], report['seconds']
        map_seconds = max(1e-6, seconds['search'])
        start_seconds = seconds['total'] - map_seconds
        size = math.ceil(max(SHARE_OF_START * start_seconds, LEAST_SECONDS) / map_seconds)
        size = max(1, min(size, math.ceil(count / cores)))
        names = ['0-0'] + ['%d-%d' % (first, min(first + size, count) - 1) for first in range(1, count, size)]
        print('%d candidates in %d slices: %.3g s a map, about %.3g h on %d cores' %
              (count, len(names), map_seconds, (count * map_seconds + len(names) * start_seconds) / cores / 3600, cores),
              file=sys.stderr)
        with open(kept + '.part', 'w', encoding='utf-8') as file:
            json.dump(names, file)
        os.replace(kept + '.part', kept)
    with open(kept, encoding='utf-8') as file:
        return json.load(file)


def plan(given, words):
    """checks the call, and prints the number of jobs, the memory of each, their words, and the slices that are left"""
    try:
        search, outputs = search_and_outputs(words)
    except Unusable as error:
        refuse(str(error))
    arguments = words_of([pair for pair in search if pair[0] not in ('--threads', '--quiet')])
    check_command_line(given.program, words_of(search) + words_of(outputs))
    try:
        with open(given.mesh, 'rb') as file:
            content = file.read()
    except OSError as error:
        print("brute_force_on_many.sh: cannot read MESH '%s': %s" % (given.mesh, error.strerror), file=sys.stderr)
        sys.exit(3)
    keep_settings(given.work, {'version': version_of(given.program), 'arguments': arguments,
                               'mesh': hashlib.sha256(content).hexdigest()})
    program, mesh, work = (os.fsencode(os.path.abspath(name)) for name in (given.program, given.mesh, given.work))
    cores = number_of_cores()
    memory = min(memory_of(faces_at_most(mesh, len(content)), 1), free_memory() // 2)
    names = slices_of(program, mesh, given.work, cores * given.machines)
    print('jobs', cores, memory, word_of(program), word_of(mesh), word_of(work))
    for name in names:
        if not os.path.exists(slice_path(given.work, name)):
            print('slice', name)


def finish(given, words):
    """becomes the call of square_map that maps the best candidate"""
    search, outputs = search_and_outputs(words)
    with open(os.path.join(given.work, STATE.decode(), 'slices.json'), encoding='utf-8') as file:
        reports = [slice_path(given.work, name) for name in json.load(file)]
    missing = [report for report in reports if not os.path.exists(report)]
    if missing:
        print('brute_force_on_many.sh: %d slices of %d failed; %s/%s/joblog says more, and the same call goes on' %
              (len(missing), len(reports), given.work, STATE.decode()), file=sys.stderr)
        sys.exit(1)
    curves = [('--curve', report) for report in reports]
    mesh = given.mesh if not given.mesh.startswith('-') else './' + given.mesh
    os.execv(given.program, [given.program, mesh, *words_of(search), *words_of(outputs), *words_of(curves)])


def main():
    if sys.argv[1] == 'map':
        program, mesh, work, name = (name_of(word) for word in sys.argv[2:])
        status, messages = map_slice(program, mesh, work, name.decode())
        sys.stderr.buffer.write(messages)
        return status
    given, words = parse_arguments(sys.argv[1:])
    plan(given, words) if given.step == 'plan' else finish(given, words)
    return 0


if __name__ == '__main__':
    sys.exit(main())
