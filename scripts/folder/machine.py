# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What this machine has, and what a map takes of it."""
import os

# Measured, with all outputs: see BYTES_OF_FACE in the manual's page on folders
BYTES_OF_PROGRAM, BYTES_OF_FACE, BYTES_OF_FACE_AND_THREAD = 40 << 20, 3000, 1800
# the least that a face takes in a file, with its share of the vertices, in the tersest form of each format
BYTES_IN_FILE = {b'.off': 22, b'.obj': 24, b'.ply': 19, b'.stl': 50}


def faces_at_most(mesh, size):
    """how many faces a file of this name and size can have"""
    return size // BYTES_IN_FILE.get(mesh[-4:].lower(), min(BYTES_IN_FILE.values()))


def memory_of(faces, threads):
    """the bytes that a map takes at most"""
    return BYTES_OF_PROGRAM + faces * (BYTES_OF_FACE + (threads - 1) * BYTES_OF_FACE_AND_THREAD)


def free_memory():
    with open('/proc/meminfo', encoding='ascii') as file:
        return next(int(line.split()[1]) << 10 for line in file if line.startswith('MemAvailable'))


def number_of_cores():
    """those that this process may use, in a job of Slurm those that it was given"""
    cores = len(os.sched_getaffinity(0))
    return min(cores, int(os.environ.get('SLURM_CPUS_PER_TASK', cores)))
