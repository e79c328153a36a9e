#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a call of map_folder.sh, prepares OUT and prints what is to be done, a line each:

    pass THREADS JOBS PERCENT BYTES   run JOBS jobs of THREADS threads at a time; on other machines as many as PERCENT of
                                      their cores; start none while less than BYTES of memory are free
    meshes THREADS WORD,...           a job of that pass, the largest first: a mesh, or several small ones
    total COUNT                       all meshes, with those that are done already

A call that makes no sense ends with status 2 and one sentence.
"""
import argparse
import os
import sys

from machine import faces_at_most, free_memory, memory_of, number_of_cores
from meshes import is_mapped, meshes_below, read_record, word_of
from options import Unusable, arguments_and_outputs
from state import check_command_line, keep_settings, refuse, version_of

SMALL, MOST_IN_A_JOB = 5000, 8  # faces of a mesh that shares its job with others, and how many do


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


def threads_for(faces, all_faces, cores, machines, memory):
    """a power of two, or all: one, unless the mesh is so large a part of the work that the others would be done long
    before, or maps of such meshes on all cores would not fit into the memory"""
    threads = 1
    while 2 * threads <= cores and (2 * threads * all_faces <= faces * cores * machines or
                                    memory_of(faces, threads) * (cores // threads) > memory):
        threads *= 2
    return cores if 2 * threads > cores else threads


def jobs_of(meshes, faces, workers):
    """the meshes in jobs: to begin a job takes a tenth of a second, in which small meshes are mapped"""
    small = [mesh for mesh in meshes if faces[mesh] < SMALL]
    in_a_job = max(1, min(MOST_IN_A_JOB, len(small) // (4 * workers)))
    large = meshes[:len(meshes) - len(small)]
    return [[mesh] for mesh in large] + [small[k:k + in_a_job] for k in range(0, len(small), in_a_job)]


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
    check_command_line(given.program, [*arguments, *(word for pair in outputs.items() for word in pair)])
    source, out = os.fsencode(given.source), os.fsencode(given.out)
    meshes = meshes_below(source, lambda sentence: print('map_folder.sh: ' + sentence, file=sys.stderr))
    if not meshes:
        refuse("there is no mesh (.off, .obj, .ply, .stl) below '%s'" % given.source)
    keep_settings(given.out, {'version': version_of(given.program), 'arguments': arguments, 'outputs': outputs})

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
        for job in jobs_of(its_meshes, faces, jobs * given.machines):
            print('meshes', own, ','.join(word_of(b'./' + mesh) for mesh in job))
    print('total', len(meshes))


if __name__ == '__main__':
    main()
