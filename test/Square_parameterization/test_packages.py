#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the packages of a build folder, and looks into them: test_packages.py BUILD CPACK."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BUILD, CPACK = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
FILES = ['bin/square_map', 'share/man/man1/square_map.1', 'share/bash-completion/completions/square_map',
         'include/CGAL_ext/Square_parameterization/parameterize_onto_square.h', 'share/doc/*/LICENSE', 'share/doc/*/CHANGES.md',
         'share/doc/*/README.md', 'share/doc/*/copyright', 'lib/**/cmake/CGAL_ext/CGAL_extConfig.cmake',
         'lib/**/pkgconfig/CGAL_ext.pc']


def check_files(prefix):
    """all that belongs into a package is there; the program runs, and its manual page has its options"""
    for pattern in FILES:
        assert list(prefix.glob(pattern)), '%s is not in the package' % pattern
    program = prefix / 'bin/square_map'
    version = subprocess.run([program, '--version'], capture_output=True, text=True, check=True).stdout.split()[1]
    page = (prefix / 'share/man/man1/square_map.1').read_text()
    assert 'square_map ' + version in page
    text = page.replace('\\-', '-').replace('\\fR', ' ')
    options = re.findall(r'^  (?:-\w \[ )?(--[\w-]+)', subprocess.run([program, '--help'], capture_output=True, text=True,
                                                                    check=True).stdout, re.MULTILINE)
    assert len(options) > 30, options
    for option in options:
        assert re.search(r'^.*\\fB%s .*\n.+' % option, text, re.MULTILINE), option + ' is not in the manual page'
    if shutil.which('groff'):
        warnings = subprocess.run(['groff', '-man', '-ww', '-z', prefix / 'share/man/man1/square_map.1'], capture_output=True,
                                  text=True, check=True).stderr
        assert not warnings, warnings
    return version


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        generators = 'DEB;TGZ' if shutil.which('dpkg-deb') and shutil.which('dpkg-shlibdeps') else 'TGZ'
        subprocess.run([CPACK, '-G', generators, '--config', BUILD / 'CPackConfig.cmake', '-B', folder], cwd=BUILD,
                       stdout=subprocess.DEVNULL, check=True)
        archive, = folder.glob('*.tar.gz')
        shutil.unpack_archive(archive, folder / 'archive')
        prefix, = (folder / 'archive').iterdir()
        version = check_files(prefix if (prefix / 'bin').exists() else prefix / 'usr')
        assert version in archive.name
        print('%s: passed' % archive.name)
        for package in folder.glob('*.deb'):
            subprocess.run(['dpkg-deb', '-x', package, folder / 'package'], check=True)
            check_files(folder / 'package/usr')
            fields = subprocess.run(['dpkg-deb', '-f', package], capture_output=True, text=True, check=True).stdout
            assert 'libcgal-dev' in fields and 'libeigen3-dev' in fields and 'libc6' in fields, fields
            assert 'Version: ' + version in fields
            print('%s: passed' % package.name)


if __name__ == '__main__':
    main()
