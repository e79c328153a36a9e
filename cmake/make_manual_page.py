#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the manual page of square_map: make_manual_page.py PROGRAM TEMPLATE OUTPUT. The options are those that the
program lists itself."""
import pathlib
import re
import subprocess
import sys


def options_of(help_text):
    """the options as pairs: the names with the value, and the description in one line"""
    lines = help_text.split('options:\n')[1].split('exit status:')[0].splitlines()
    column = re.search(r'show this text', lines[0]).start()  # in which all descriptions begin
    options = []
    for line in lines:
        names, description = line[:column].strip(), line[column:].strip()
        if names.startswith('-') and len(line[:column].rstrip()) < column and description:
            options.append([names, description])
        elif line.strip().startswith('-') and not description:  # too long to have its description beside it
            options.append([line.strip(), ''])
        elif description:
            options[-1][1] = (options[-1][1] + ' ' + description).strip()
    return options


def escaped(text):
    return text.replace('\\', '\\e').replace('-', '\\-')


def paragraph(names, description):
    """an option as roff has it: names in bold, the value in italics"""
    short = re.fullmatch(r'(-\w) \[ (--[\w-]+) \] ?(.*)', names)
    words = list(short.groups()) if short else [None, *(names.split(' ', 1) + [''])[:2]]
    head = ', '.join('\\fB%s\\fR' % escaped(name) for name in words[:2] if name)
    value = ' \\fI%s\\fR' % escaped(words[2]) if words[2] else ''
    return '.TP\n%s%s\n%s\n' % (head, value, re.sub(r'^([.\'])', r'\\&\1', escaped(description)))


def main():
    program, template, output = sys.argv[1:]

    def said(option):
        return subprocess.run([program, option], capture_output=True, text=True, check=True).stdout

    options = ''.join(paragraph(*option) for option in options_of(said('--help')))
    page = pathlib.Path(template).read_text().replace('@VERSION@', said('--version').split(' (')[0])
    pathlib.Path(output).write_text(page.replace('@OPTIONS@\n', options))


if __name__ == '__main__':
    main()
