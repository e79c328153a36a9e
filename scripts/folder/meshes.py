# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of a folder and what became of each: what the programs of map_folder.sh share.

Names of files are bytes, and may be any. Where they pass through a shell, a list or a log, they are words of plain
ASCII, encoded as in the addresses of web pages.
"""
import fcntl
import hashlib
import json
import os
import sys
import urllib.parse

import state

ENDINGS = (b'.off', b'.obj', b'.ply', b'.stl')
STATE = state.STATE.encode()


def word_of(name):
    """a name of a file, bytes, as one word of ASCII"""
    return urllib.parse.quote_from_bytes(name, safe='/')


def name_of(word):
    """the name that a word stands for, as bytes"""
    return urllib.parse.unquote_to_bytes(word)


def meshes_below(folder, complain):
    """the meshes below a folder, relative to it, with their sizes in bytes, in the order of their names

    A link to a file counts as a file, one to a folder is not followed. `complain` gets a sentence about each folder
    that cannot be read.
    """
    found = {}

    def complain_of(error):
        complain("cannot read the folder '%s': %s" % (os.fsdecode(error.filename), error.strerror))

    for path, folders, files in os.walk(folder, onerror=complain_of):
        if path == folder and STATE in folders:
            folders.remove(STATE)  # of an earlier call, if IN was its OUT
        for name in files:
            full = os.path.join(path, name)
            if name.lower().endswith(ENDINGS) and (os.path.isfile(full) or not os.path.exists(full)):
                found[os.path.relpath(full, folder)] = os.path.getsize(full) if os.path.exists(full) else 0
    return dict(sorted(found.items()))


class Record:
    """what became of one mesh; who has it open is the only one to map it, on any machine"""

    def __init__(self, out, mesh):
        self.path = os.path.join(out, STATE, b'records', key_of(mesh) + b'.json')

    def __enter__(self):
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        self.file = os.fdopen(os.open(self.path, os.O_RDWR | os.O_CREAT, 0o666), 'r+b')
        fcntl.flock(self.file, fcntl.LOCK_EX)
        return self

    def __exit__(self, *error):
        self.file.close()

    def read(self):
        """the record; None when there is none, or one that was not written to its end"""
        self.file.seek(0)
        return parsed(self.file.read())

    def write(self, record):
        self.file.seek(0)
        self.file.truncate()
        self.file.write(json.dumps(record).encode())
        self.file.flush()


def key_of(mesh):
    """a short name of a mesh that may be any file's"""
    return hashlib.sha256(mesh).hexdigest()[:32].encode()


def parsed(text):
    try:
        return json.loads(text)
    except ValueError:
        return None


def read_record(out, mesh):
    """the record of a mesh, which another may be writing: None then, and where there is none"""
    try:
        with open(Record(out, mesh).path, 'rb') as file:
            return parsed(file.read())
    except FileNotFoundError:
        return None


def state_of(path):
    """what tells whether a file is still the one that was mapped"""
    try:
        status = os.stat(path)
        return [status.st_size, status.st_mtime_ns]
    except OSError:
        return None


def is_mapped(record, source, out, mesh):
    """indicates whether a mesh was mapped as it is now. One that could not be is tried again by each call."""
    return (record is not None and record['status'] == 0 and record['state'] == state_of(os.path.join(source, mesh))
            and os.path.exists(os.path.join(out, mesh, b'report.json')))


if __name__ == '__main__':  # for shells: the words of names
    print(*(word_of(os.fsencode(name)) for name in sys.argv[1:]), sep='\n')
