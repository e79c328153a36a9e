#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes OUT/summary.csv and OUT/index.html from the records of the meshes: write_summary.py IN OUT PART. Prints how many
meshes are mapped; status 0 when all are, or in one of several parts (K/N) all that any part has tried; 1 otherwise."""
import collections
import csv
import fcntl
import html
import io
import os
import sys

from meshes import STATE, meshes_below, read_record, word_of

FIGURES = ['vertices', 'faces', 'seam_edges', 'cut_length', 'l2', 'linf', 'aspect', 'evaluations']
COLUMNS = ['mesh', 'status', *FIGURES, 'seconds', 'memory_mib', 'message']

STYLE = '''body { font: 15px/1.4 system-ui, sans-serif; margin: 2em; color: #222; background: #fff }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(176px, 1fr)); gap: 14px; padding: 0 }
figure { margin: 0; padding: 7px; border: 1px solid #ccc; border-radius: 6px }
figure a { display: block; text-align: center }
figure img { width: 160px; height: 160px }
figcaption { overflow-wrap: anywhere } small { color: #555 }
table { border-collapse: collapse } td, th { border: 1px solid #ccc; padding: 3px 8px; text-align: left; overflow-wrap: anywhere }'''


def table(rows):
    """the rows as the bytes of a CSV file; names of files are the bytes that they are"""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator='\n')
    writer.writerow(COLUMNS)
    for mesh, record in rows:
        if record is None:
            writer.writerow([os.fsdecode(mesh), ''] + [''] * (len(COLUMNS) - 3) + ['not mapped yet'])
            continue
        figures = record.get('figures', {})
        writer.writerow([os.fsdecode(mesh), record['status'], *(figures.get(name, '') for name in FIGURES),
                         '%.3f' % record['measured']['seconds'], '%.1f' % record['measured']['memory_mib'],
                         record['message']])
    return text.getvalue().encode(errors='surrogateescape')


def shown(mesh):
    """a name of a file as text of a page"""
    text = ''.join(c if c.isprintable() else '\N{SYMBOL FOR SUBSTITUTE}' for c in mesh.decode(errors='replace'))
    return html.escape(text)


def card(mesh, figures, page):
    """a mesh that has a map"""
    folder = './' + word_of(mesh) + '/'
    cut = ', cut %.3g' % figures['cut_length'] if figures['seam_edges'] else ''
    return ('<figure><a href="%s%s"><img loading="lazy" alt="" src="%sthumbnail.png"></a><figcaption>%s<br><small>L2 '
            '%.4f%s, %d faces</small></figcaption></figure>\n' %
            (folder, page, folder, shown(mesh), figures['l2'], cut, figures['faces']))


def page_of(rows, out):
    """the page: the meshes with their thumbnails, and those without a map"""
    mapped = [(mesh, record) for mesh, record in rows if record is not None and record['status'] == 0]
    others = [(mesh, record) for mesh, record in rows if record is not None and record['status'] != 0]
    count = '%d of %d meshes mapped' % (len(mapped), len(rows))
    text = ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" '
            'content="width=device-width"><title>%s</title>\n<style>\n%s\n</style></head><body>\n<h1>%s</h1>\n'
            '<p><a href="summary.csv">summary.csv</a> has the figures.</p>\n<main>\n' % (count, STYLE, count))
    for mesh, record in mapped:
        has_page = os.path.exists(os.path.join(out, mesh, b'map.html'))
        text += card(mesh, record['figures'], 'map.html' if has_page else 'report.json')
    text += '</main>\n'
    if others:
        text += '<h2>Without a map</h2>\n<table><tr><th>mesh</th><th>status</th><th>reason</th></tr>\n'
        for mesh, record in others:
            text += '<tr><td><a href="./%s/log.txt">%s</a></td><td>%d</td><td>%s</td></tr>\n' % (
                word_of(mesh), shown(mesh), record['status'], html.escape(record['message']))
        text += '</table>\n'
    return (text + '</body></html>\n').encode()


def write(path, content):
    """replaces a file at once"""
    unfinished = path + b'.%d' % os.getpid()
    with open(unfinished, 'wb') as file:
        file.write(content)
    os.replace(unfinished, path)


def tell(rows, out):
    """prints the counts; returns the kinds of ends that meshes had"""
    statuses = collections.Counter('not mapped yet' if record is None else
                                   'mapped' if record['status'] == 0 else 'with status %d' % record['status']
                                   for _, record in rows)
    print('%d meshes: %s' % (len(rows), ', '.join('%d %s' % (count, what) for what, count in sorted(statuses.items()))))
    done = [(record['measured'], mesh) for mesh, record in rows if record is not None]
    if done:
        slowest = max(done, key=lambda entry: entry[0]['seconds'])
        largest = max(done, key=lambda entry: entry[0]['memory_mib'])
        print('slowest: %s, %.1f s; most memory: %s, %.0f MiB' % (
            slowest[1].decode(errors='replace'), slowest[0]['seconds'], largest[1].decode(errors='replace'),
            largest[0]['memory_mib']))
    print('see %s' % os.fsdecode(os.path.join(out, b'index.html')))
    return set(statuses)


def main():
    source, out = (os.fsencode(word) for word in sys.argv[1:3])
    sys.stdout.reconfigure(errors='surrogateescape')
    with open(os.path.join(out, STATE, b'lock'), 'wb') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # of two that end at the same time, the second sees all
        rows = [(mesh, read_record(out, mesh)) for mesh in meshes_below(source, lambda sentence: None)]
        write(os.path.join(out, b'summary.csv'), table(rows))
        write(os.path.join(out, b'index.html'), page_of(rows, out))
    is_one_of_several = not sys.argv[3].endswith('/1')
    return 0 if tell(rows, out) <= {'mapped', *(['not mapped yet'] if is_one_of_several else [])} else 1


if __name__ == '__main__':
    sys.exit(main())
