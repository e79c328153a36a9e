#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a call of map_folder.sh, prepares OUT and prints what is to be done, a line each:

    pass THREADS JOBS PERCENT BYTES   run JOBS jobs of THREADS threads at a time; on other machines as many as PERCENT of
                                      their cores; start none while less than BYTES of memory are free
    mesh THREADS WORD                 a mesh of that pass, the largest first
    total COUNT                       all meshes, with those that are done already

A call that makes no sense ends with status 2 and one sentence.
"""
import argparse
import json
import os
import subprocess
import sys

from meshes import STATE, is_mapped, meshes_below, read_record, word_of
from options import Unusable, arguments_and_outputs

# Measured (one thread, all outputs): 30 MB, and at most 2.7 kB a face; a further thread takes 1.7 kB a face
BYTES_OF_PROGRAM, BYTES_OF_FACE, BYTES_OF_FACE_AND_THREAD = 40 << 20, 3000, 1800
# the least that a face takes in a file, with its share of the vertices, in the tersest form of each format
BYTES_IN_FILE = {b'.off': 22, b'.obj': 24, b'.ply': 19, b'.stl': 50}


def refuse(sentence):
    sys.exit(fail(sentence))


def fail(sentence):
    print('map_folder.sh: ' + sentence, file=sys.stderr)
    return 2


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('source')
    parser.add_argument('out')
    parser.add_argument('--machines', type=int, default=1)
    parser.add_argument('--part', default='1/1')
    end = sys.argv.index('--')  # the options of square_map come after it
    return parser.parse_args(sys.argv[1:end]), sys.argv[end + 1:]


def check_folders(source, out):
    if not os.path.isdir(source):
        refuse("there is no folder '%s'" % source)
    if not os.access(source, os.R_OK | os.X_OK):
        refuse("the folder '%s' cannot be read" % source)
    real_source, real_out = os.path.realpath(source), os.path.realpath(out)
    common = os.path.commonpath([real_source, real_out])
    if common == real_source:
        refuse("OUT '%s' must not be inside IN '%s': the next call would map its own results" % (out, source))
    if common == real_out:
        refuse("IN '%s' must not be inside OUT '%s'" % (source, out))


def check_command_line(program, arguments, outputs):
    """square_map reads its command line before its input, which is empty here"""
    named = [word for option, name in outputs.items() for word in (option, name)]
    tried = subprocess.run([program, '-', *arguments, *named], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    message = os.fsdecode(tried.stderr).strip()
    if tried.returncode == 2:
        refuse(message.removeprefix('square_map: '))
    if tried.returncode != 3:
        refuse("cannot run '%s': status %d %s" % (program, tried.returncode, message))


def prepare(out, settings):
    """makes OUT, or finds that it is of an earlier call with the same settings"""
    state = os.path.join(out, os.fsdecode(STATE))
    kept = os.path.join(state, 'settings.json')
    try:
        os.makedirs(out, exist_ok=True)
        if os.listdir(out) and not os.path.isdir(state):
            refuse("OUT '%s' is not empty, and was not made by map_folder.sh" % out)
        os.makedirs(state, exist_ok=True)
        if os.path.exists(kept):
            with open(kept, encoding='utf-8') as file:
                if json.load(file) != settings:
                    refuse("OUT '%s' has maps that were made with other options or by another version" % out)
        unfinished = '%s.%d' % (kept, os.getpid())
        with open(unfinished, 'w', encoding='utf-8') as file:
            json.dump(settings, file)
        os.replace(unfinished, kept)
    except OSError as error:
        refuse("cannot write to OUT '%s': %s" % (out, error.strerror))


def faces_at_most(mesh, size):
    return size // BYTES_IN_FILE[mesh[-4:].lower()]


def memory_of(faces, threads):
    return BYTES_OF_PROGRAM + faces * (BYTES_OF_FACE + (threads - 1) * BYTES_OF_FACE_AND_THREAD)


def free_memory():
    with open('/proc/meminfo', encoding='ascii') as file:
        return next(int(line.split()[1]) << 10 for line in file if line.startswith('MemAvailable'))


def number_of_cores():
    """those that this process may use, in a job of Slurm those that it was given"""
    cores = len(os.sched_getaffinity(0))
    return min(cores, int(os.environ.get('SLURM_CPUS_PER_TASK', cores)))


def threads_for(faces, all_faces, cores, machines, memory):
    """a power of two, or all: one, unless the mesh is so large a part of the work that the others would be done long
    before, or maps of such meshes on all cores would not fit into the memory"""
    threads = 1
    while 2 * threads <= cores and (2 * threads * all_faces <= faces * cores * machines or
                                    memory_of(faces, threads) * (cores // threads) > memory):
        threads *= 2
    return cores if 2 * threads > cores else threads


def main():
    given, options = parse_arguments()
    check_folders(given.source, given.out)
    try:
        arguments, outputs, threads = arguments_and_outputs(options)
        part, parts = (int(number) for number in given.part.split('/'))
        if not 1 <= part <= parts:
            raise ValueError
    except Unusable as error:
        refuse(str(error))
    except ValueError:
        refuse("--part takes K/N, the K-th of N parts counted from 1; not '%s'" % given.part)
    check_command_line(given.program, arguments, outputs)
    source, out = os.fsencode(given.source), os.fsencode(given.out)
    meshes = meshes_below(source, lambda sentence: fail(sentence))
    if not meshes:
        refuse("there is no mesh (.off, .obj, .ply, .stl) below '%s'" % given.source)
    version = subprocess.run([given.program, '--version'], capture_output=True, text=True, check=True).stdout.strip()
    prepare(given.out, {'version': version, 'arguments': arguments, 'outputs': outputs})

    faces = {mesh: faces_at_most(mesh, size) for mesh, size in meshes.items()}
    largest_first = sorted(meshes, key=lambda mesh: (-faces[mesh], mesh))[part - 1::parts]
    left = [mesh for mesh in largest_first if not is_mapped(read_record(out, mesh), source, out, mesh)]
    cores, memory = number_of_cores(), free_memory()
    all_faces = max(1, sum(faces[mesh] for mesh in left))
    passes = {}
    for mesh in left:
        own = threads_for(faces[mesh], all_faces, cores, given.machines, memory) if threads is None else threads or cores
        passes.setdefault(own, []).append(mesh)
    for own, its_meshes in sorted(passes.items(), reverse=True):
        jobs = max(1, cores // own)
        needed = min(max(memory_of(faces[mesh], own) for mesh in its_meshes), memory // 2)
        print('pass', own, jobs, max(1, 100 // own), needed)
        for mesh in its_meshes:
            print('mesh', own, word_of(b'./' + mesh))
    print('total', len(meshes))


if __name__ == '__main__':
    main()
