# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder that a call leaves for the next one, so that it goes on: with the settings that both must have in common."""
import json
import os
import subprocess
import sys

STATE = '.map_folder'  # the folder in OUT with all that is not a result


def refuse(sentence):
    """tells why and ends, with the status of a bad command line"""
    print('%s: %s' % (os.environ.get('CALLED', 'map_folder.sh'), sentence), file=sys.stderr)
    sys.exit(2)


def read_settings(out):
    with open(os.path.join(os.fsdecode(out), STATE, 'settings.json'), encoding='utf-8') as file:
        return json.load(file)


def keep_settings(out, settings):
    """makes OUT, or finds that it is of an earlier call with the same settings"""
    state = os.path.join(out, STATE)
    kept = os.path.join(state, 'settings.json')
    try:
        os.makedirs(out, exist_ok=True)
        if os.listdir(out) and not os.path.isdir(state):
            refuse("the folder '%s' is not empty, and was not made by this script" % out)
        os.makedirs(state, exist_ok=True)
        if os.path.exists(kept) and read_settings(out) != settings:
            refuse("the folder '%s' has what was made with other options, from other input or by another version" % out)
        unfinished = '%s.%d' % (kept, os.getpid())
        with open(unfinished, 'w', encoding='utf-8') as file:
            json.dump(settings, file)
        os.replace(unfinished, kept)
    except OSError as error:
        refuse("cannot write to the folder '%s': %s" % (out, error.strerror))


def check_command_line(program, arguments):
    """square_map reads its command line before its input, which is empty here"""
    tried = subprocess.run([program, '-', *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, check=False)
    message = os.fsdecode(tried.stderr).strip()
    if tried.returncode == 2:
        refuse(message.removeprefix('square_map: '))
    if tried.returncode != 3:
        refuse("cannot run '%s': status %d %s" % (program, tried.returncode, message))


def version_of(program):
    return subprocess.run([program, '--version'], capture_output=True, text=True, check=True).stdout.strip()
