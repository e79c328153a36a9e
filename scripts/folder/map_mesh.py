#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps meshes of a folder: map_mesh.py PROGRAM IN OUT THREADS MESH,..., words as meshes.py has them.

OUT gets a folder of the name of each mesh, all at once: the map, the pages and report.json, or log.txt alone for a mesh
without a map. What differs from run to run, time and memory, is in the record of the mesh and nowhere else. Whoever
comes second, after a kill or on another machine, waits for the first and finds the mesh mapped.

The status is 0 when all meshes have a record, also one of a failure; GNU parallel tries again otherwise.

With --check PROGRAM OUT it tells instead which program this machine has, and which settings it finds in OUT.
"""
import hashlib
import json
import os
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import time

from meshes import STATE, Record, is_mapped, key_of, name_of, state_of
from state import read_settings

STOPPED = (-signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP, *(128 + s for s in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)))


def read_json(path):
    with open(path, encoding='utf-8') as file:
        return json.load(file)


def run(command, source, lock):
    """runs square_map in the folder of the meshes; returns its status, its messages, and what it took"""
    start = time.monotonic()
    with subprocess.Popen(command, cwd=source, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, pass_fds=[lock]) as process:
        messages = process.stderr.read()
        _, ended, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(ended)
    return process.returncode, messages, {'seconds': time.monotonic() - start, 'memory_mib': usage.ru_maxrss / 1024,
                                          'host': socket.gethostname()}


def message_of(status, messages):
    """why there is no map, in one line"""
    if status < 0:
        return 'square_map was ended by signal %d' % -status
    lines = messages.decode(errors='replace').strip().splitlines()
    return lines[-1].removeprefix('square_map: ') if lines else ''


def figures_of(report):
    """what the table has of a map"""
    conditioned, best = report['conditioned'], report['best']
    return {'vertices': conditioned['vertices'], 'faces': conditioned['faces'], 'seam_edges': conditioned['seam_edges'],
            'cut_length': conditioned['cut_length'], 'l2': best['l2'], 'linf': best['linf'], 'aspect': best['aspect'],
            'evaluations': report['evaluations']}


def take_times(path, measured):
    """moves what depends on the machine from the report to what was measured; returns the report"""
    report = read_json(path)
    for key in ('seconds', 'threads'):
        measured['report_' + key] = report.pop(key)
    with open(path, 'w', encoding='utf-8') as file:
        json.dump(report, file, indent=2)
        file.write('\n')
    return report


def write_log(path, command, status, messages):
    with open(path, 'wb') as file:
        file.write(os.fsencode(shlex.join(command)) + b'\n' + messages + b'exit status %d\n' % status)


def replace(stage, place):
    """puts the finished folder in its place"""
    os.makedirs(os.path.dirname(place), exist_ok=True)
    if os.path.lexists(place):
        shutil.rmtree(place)
    os.rename(stage, place)


def map_mesh(program, source, out, threads, mesh, lock):
    """maps a mesh, and returns its record; None when it was stopped"""
    settings = read_settings(out)
    stage = os.path.join(out, STATE, b'work', key_of(mesh))
    shutil.rmtree(stage, ignore_errors=True)
    os.makedirs(stage)
    arguments = [os.fsdecode(os.path.join(b'.', mesh)), *settings['arguments']]
    outputs = {**settings['outputs'], '--thumbnail': 'thumbnail.png', '--json': 'report.json'}
    named = [word for option, name in outputs.items() for word in (option, os.fsdecode(os.path.join(stage, os.fsencode(name))))]
    state = state_of(os.path.join(source, mesh))
    status, messages, measured = run([os.fsdecode(program), *arguments, *named, '--threads', threads, '--quiet'], source, lock)
    if status in STOPPED:
        shutil.rmtree(stage)
        return None
    record = {'state': state, 'status': status, 'message': message_of(status, messages) if status != 0 else ''}
    if status == 0:
        record['figures'] = figures_of(take_times(os.path.join(stage, b'report.json'), measured))
    else:  # a process that was killed may leave unfinished files
        shutil.rmtree(stage)
        os.makedirs(stage)
    words = [word for option, name in outputs.items() for word in (option, name)]
    write_log(os.path.join(stage, b'log.txt'), ['square_map', *arguments, *words], status, messages)
    replace(stage, os.path.join(out, mesh))
    return {**record, 'measured': measured}


def keep_mapped(program, source, out, threads, mesh):
    """maps a mesh that is not mapped yet; false when it was stopped"""
    with Record(out, mesh) as record:
        if is_mapped(record.read(), source, out, mesh):
            return True
        result = map_mesh(program, source, out, threads, mesh, record.file.fileno())
        if result is not None:
            record.write(result)
    return result is not None


def check(program, out):
    with open(program, 'rb') as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    version = subprocess.run([program, '--version'], capture_output=True, check=True).stdout
    print(digest, version.decode().strip(), hashlib.sha256(json.dumps(read_settings(out)).encode()).hexdigest(),
          os.access(out, os.W_OK))


def main():
    if sys.argv[1] == '--check':
        check(*(name_of(word) for word in sys.argv[2:]))
        return 0
    program, source, out, threads = (name_of(word) for word in sys.argv[1:5])
    meshes = [os.path.normpath(name_of(word)) for word in sys.argv[5].split(',')]
    ends = [keep_mapped(program, source, out, threads.decode(), mesh) for mesh in meshes]
    return 0 if all(ends) else 1


if __name__ == '__main__':
    sys.exit(main())
