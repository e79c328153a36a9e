# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells the options of square_map that name outputs from the others."""
import os

SHORT = {'-o': '--output', '-q': '--quiet', '-h': '--help'}
# the outputs, each with the name that it has in the folder of a mesh
NAMES = {'--output': 'map', '--report': 'map', '--svg': 'map', '--image': 'image', '--normal-map': 'normals',
         '--attributes': 'attributes', '--grid-mesh': 'grid'}
DEFAULT_ENDINGS = {'--output': '.obj', '--report': '.html'}
# of all outputs: they have no effect without one
OF_OUTPUTS = ('--resolution', '--texture')
SWITCHES = ('--quiet', '--help', '--version', '--quarter-corners', '--cut-disk', '--triangulate')
# what only one mesh can have
OF_ONE_MESH = ('--json', '--thumbnail', '--seams', '--candidates', '--curve')


class Unusable(Exception):
    """an option that cannot be used, in one sentence"""


def pairs(options):
    """options as pairs of the long name and the value, None for a switch"""
    words = list(options)
    result = []
    while words:
        word = words.pop(0)
        if word.startswith('--'):
            name, equals, value = word.partition('=')
        else:
            name, equals, value = SHORT.get(word[:2], word), word[2:], word[2:]
        if not name.startswith('--'):
            raise Unusable("'%s' is no option of square_map, and each has one input" % word)
        if name in SWITCHES:
            result.append((name, None))
        elif equals:
            result.append((name, value))
        elif words:
            result.append((name, words.pop(0)))
        else:
            raise Unusable('%s needs a value' % name)
    return result


def words_of(options):
    """the words of the command line again"""
    return [word for name, value in options for word in ([name] if value is None else ['%s=%s' % (name, value)])]


def split_outputs(options):
    """the options that search and map, and those of the outputs, as pairs"""
    outputs = [pair for pair in options if pair[0] in (*NAMES, *OF_OUTPUTS, '--json', '--thumbnail')]
    return [pair for pair in options if pair not in outputs], outputs


def arguments_and_outputs(options):
    """the arguments of each call of square_map but for the threads, its outputs as names by option, and the number of
    threads; None when none is given"""
    arguments, outputs, threads = [], dict(DEFAULT_ENDINGS), None
    for name, value in pairs(options):
        if name in OF_ONE_MESH:
            raise Unusable('%s is of one mesh, and not of a folder' % name)
        if name in ('--help', '--version'):
            raise Unusable('%s goes with square_map alone' % name)
        if name in NAMES:
            if value != 'none' and not (value.startswith('.') and '/' not in value):
                raise Unusable("%s takes the ending of the files of all meshes, such as .png, or none; not '%s'" %
                               (name, value))
            outputs[name] = value
        elif name == '--threads':
            threads = value
        elif name == '--texture' and value != 'checker':
            arguments.append((name, os.path.abspath(value)))
        elif name != '--quiet':
            arguments.append((name, value))
    named = {name: NAMES[name] + ending for name, ending in outputs.items() if ending != 'none'}
    if threads is not None and not (threads.isdecimal() and int(threads) <= 1000000):
        raise Unusable("--threads must be a whole number from 0 to 1000000; not '%s'" % threads)
    return words_of(arguments), named, None if threads is None else int(threads)
