#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs map_folder.sh and brute_force_on_many.sh as users do, on a few small meshes, and compares with single runs of
square_map: test_folder.py SQUARE_MAP SCRIPTS MESHES [NAME...]; names choose tests."""
import csv
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SQUARE_MAP, SCRIPTS, MESHES = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
ENVIRONMENT = {**os.environ, 'SQUARE_MAP': str(SQUARE_MAP)}
EVIL_NAMES = [b'plain.off', b'-o.off', b'new\nline.off', b' .off', b"it's \"q\" $(x) `y` {} {.}\\.off", 'ü–漢.off'.encode(),
              b'\xff\xfe.off', b'*.off', b'%41 &?#<b>.OFF', b'a.off/b.off', b'a.ply/-/c d.off']
TIMES = ('seconds', 'memory_mib')


def script(name, *words, cwd):
    return subprocess.run([SCRIPTS / name, *words], cwd=cwd, env=ENVIRONMENT, capture_output=True, check=False)


def put(folder, name, mesh):
    place = os.path.join(os.fsencode(folder), name)
    os.makedirs(os.path.dirname(place), exist_ok=True)
    shutil.copy(MESHES / mesh, place)


def rows(out):
    """the table, by mesh, without what was measured"""
    with open(out / 'summary.csv', encoding='utf-8', errors='surrogateescape', newline='') as file:
        table = list(csv.DictReader(file))
    return {row['mesh']: {key: value for key, value in row.items() if key not in TIMES} for row in table}


def results(out):
    """the bytes of all files but the table, by name; and the table without what was measured"""
    found = {}
    for path, folders, files in os.walk(os.fsencode(out)):
        if b'.map_folder' in folders:
            folders.remove(b'.map_folder')
        for name in files:
            full = os.path.join(path, name)
            with open(full, 'rb') as file:
                found[os.path.relpath(full, os.fsencode(out))] = file.read()
    del found[b'summary.csv']
    return found, rows(out)


def check(condition, *words):
    if not condition:
        raise AssertionError(' '.join(str(word) for word in words))


def check_call(finished, status):
    check(finished.returncode == status, 'status', finished.returncode, 'not', status, finished.stdout, finished.stderr)


def test_any_names(folder):
    """evil names, broken files and links: each mesh as square_map maps it alone, the others with their reasons"""
    meshes = folder / 'in'
    for name in EVIL_NAMES:
        put(meshes, name, 'open_cube.off')
    put(meshes, b'hand.off', 'hand.off')
    put(meshes, b'quads.off', 'cube_quad.off')  # not without --triangulate
    (meshes / 'empty.off').write_bytes(b'')
    (meshes / 'broken.ply').write_bytes(b'hello\n')
    (meshes / 'dangling.stl').symlink_to('nowhere.stl')
    (meshes / 'link.off').symlink_to('hand.off')
    (meshes / 'folder.off').mkdir()
    (meshes / 'notes.txt').write_bytes(b'no mesh')
    os.mkfifo(meshes / 'pipe.off')
    check_call(script('map_folder.sh', 'in', 'out', cwd=folder), 1)
    found, table = results(folder / 'out')
    statuses = {name: row['status'] for name, row in table.items()}
    expected = {os.fsdecode(name): '0' for name in [*EVIL_NAMES, b'hand.off', b'link.off']}
    expected.update({'quads.off': '4', 'empty.off': '3', 'broken.ply': '3', 'dangling.stl': '3'})
    check(statuses == expected, statuses)
    check('line 1: ply was expected' in table['broken.ply']['message'], table['broken.ply'])
    for name, status in expected.items():
        files = [file for file in found if file.startswith(os.fsencode(name) + b'/')]
        outputs = {b'map.obj', b'map.html', b'thumbnail.png', b'report.json', b'log.txt'} if status == '0' else {b'log.txt'}
        check({os.path.basename(file) for file in files} == outputs, name, files)
    alone = folder / 'alone.obj'
    subprocess.run([SQUARE_MAP, MESHES / 'hand.off', '-o', alone, '--json', folder / 'alone.json', '-q'], check=True)
    check(alone.read_bytes() == found[b'hand.off/map.obj'] == found[b'link.off/map.obj'])
    report, row = json.loads((folder / 'alone.json').read_text()), table['hand.off']
    check([float(row[key]) for key in ('l2', 'linf')] == [report['best'][key] for key in ('l2', 'linf')], row)
    check(int(row['evaluations']) == report['evaluations'] and float(row['cut_length']) == report['conditioned']['cut_length'])
    page = found[b'index.html'].decode()
    check(page.count('<figure>') == 13 and page.count('log.txt') == 4 and '14 of 17' not in page, page)
    # with the option, what had no map is tried again, and the rest is as it was; other options need another folder
    check_call(script('map_folder.sh', 'in', 'out', '--triangulate', cwd=folder), 2)
    check(results(folder / 'out') == (found, table))


def test_refusals(folder):
    """calls that make no sense: one sentence, status 2, and nothing is made"""
    (folder / 'in/deep').mkdir(parents=True)
    (folder / 'empty').mkdir()
    (folder / 'others').mkdir()
    (folder / 'others/file').write_bytes(b'')
    (folder / 'file').write_bytes(b'')
    put(folder, b'in/a.off', 'open_cube.off')
    cases = [([], 'IN, the folder'), (['in'], 'IN, the folder'), (['missing', 'out'], 'there is no folder'),
             (['file', 'out'], 'no folder'), (['empty', 'out'], 'no mesh'), (['in', 'in'], 'must not be inside IN'),
             (['in', 'in/out'], 'must not be inside IN'), (['in', 'in/deep/../out'], 'must not be inside IN'),
             (['in/deep', 'in'], 'must not be inside OUT'), (['in', 'others'], 'not empty'), (['in', 'file'], 'cannot write'),
             (['in', '/proc/out'], 'cannot write'), (['in', 'out', '--step', '3'], '--step goes with'),
             (['in', 'out', '--strategy', 'x'], '--strategy is one of'), (['in', 'out', '--json', 'x'], '--json is of one mesh'),
             (['in', 'out', '-o', 'x.obj'], 'ending'), (['in', 'out', '-o', '.txt'], 'must end in .obj'),
             (['in', 'out', 'more'], 'no option'), (['in', 'out', '--threads', 'x'], '--threads'),
             (['in', 'out', '--part', '3/2'], '--part takes'), (['in', 'out', '--hosts', 'missing'], 'cannot be read'),
             (['in', 'out', '--hosts', 'file'], 'names none'), (['in', 'out', '--hosts'], 'needs a value')]
    for words, sentence in cases:
        finished = script('map_folder.sh', *words, cwd=folder)
        check_call(finished, 2)
        message = finished.stderr.decode()
        check(message.startswith('map_folder.sh: ') and sentence in message and message.count('\n') == 1, words, message)
        check(not (folder / 'out').exists() and not finished.stdout, words)


def descendants(process):
    """all processes below one, from /proc"""
    children = {}
    for entry in pathlib.Path('/proc').glob('[0-9]*/stat'):
        try:
            parent = int(entry.read_text().rpartition(')')[2].split()[1])
        except (OSError, ValueError):
            continue
        children.setdefault(parent, []).append(int(entry.parent.name))
    found, left = [], [process]
    while left:
        found += children.get(left[-1], [])
        left += children.get(left.pop(), [])
    return found


def test_killed_and_called_again(folder):
    """SIGKILL at five random moments, of the script alone or of all that it started: the bytes of one go in the end"""
    for name in ('hand', 'open_cube', 'patch-01', 'nefertiti', 'tetrahedron', 'mushroom', 'plane', 'cube_quad'):
        put(folder, b'in/%s.off' % name.encode(), name + '.off')
    words = ['--report', 'none', '--svg', '.svg']
    start = time.monotonic()
    check_call(script('map_folder.sh', 'in', 'once', *words, cwd=folder), 1)
    duration = time.monotonic() - start
    moments = random.Random()
    for kill in range(5):
        process = subprocess.Popen([SCRIPTS / 'map_folder.sh', 'in', 'often', *words], cwd=folder, env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(moments.uniform(0, duration / 2))
        for victim in ([] if kill % 2 else descendants(process.pid)) + [process.pid]:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass
        process.wait()
        for file in folder.glob('often/*.off/map.*'):  # whatever has its name is whole
            check(file.read_bytes() == (folder / 'once' / file.relative_to(folder / 'often')).read_bytes(), file)
    check_call(script('map_folder.sh', 'in', 'often', *words, cwd=folder), 1)
    check(results(folder / 'often') == results(folder / 'once'))


def test_parts(folder):
    """the parts of an array job, one after the other, are the whole; a mesh that was mapped is not mapped again"""
    for name in ('open_cube', 'patch-01', 'nefertiti', 'tetrahedron'):
        put(folder, b'in/%s.off' % name.encode(), name + '.off')
    check_call(script('map_folder.sh', 'in', 'whole', '-o', '.glb', cwd=folder), 0)
    check_call(script('map_folder.sh', 'in', 'parts', '-o', '.glb', '--part', '1/2', cwd=folder), 0)
    statuses = sorted(row['status'] for row in rows(folder / 'parts').values())
    check(statuses == ['', '', '0', '0'], statuses)
    first = {path: path.stat().st_mtime_ns for path in folder.glob('parts/*/map.glb')}
    check(len(first) == 2)
    check_call(script('map_folder.sh', 'in', 'parts', '-o', '.glb', '--part', '2/2', cwd=folder), 0)
    check(results(folder / 'parts') == results(folder / 'whole'))
    check(all(path.stat().st_mtime_ns == moment for path, moment in first.items()))
    put(folder, b'in/tetrahedron.off', 'open_cube.off')  # another mesh of the same name is mapped
    check_call(script('map_folder.sh', 'in', 'parts', '-o', '.glb', cwd=folder), 0)
    found = results(folder / 'parts')[0]
    check(found[b'tetrahedron.off/map.glb'] == found[b'open_cube.off/map.glb'])


def test_brute_force_in_slices(folder):
    """the same bytes as brute force on one machine, but for the times"""
    for mesh, options in (('mushroom.off', ['--minimizer', 'iterative']),
                          ('patch-01.off', ['--strategy', 'quarter-brute-force', '--aspect', 'best'])):
        put(folder, b'in/{} x.off', mesh)
        outputs = ['-o', 'map.obj', '--svg', 'map.svg', '--json', 'map.json', '--grid-mesh', 'grid.off', '--resolution', '33']
        words = [*options, *outputs]
        one, many = folder / ('one' + options[0]), folder / ('many' + options[0])
        one.mkdir()
        many.mkdir()
        strategy = [] if '--strategy' in options else ['--strategy', 'brute-force']
        subprocess.run([SQUARE_MAP, '../in/{} x.off', *words, *strategy, '-q'], cwd=one, check=True)
        check_call(script('brute_force_on_many.sh', '../in/{} x.off', 'work', *words, cwd=many), 0)
        reports = [json.loads((place / 'map.json').read_text()) for place in (one, many)]
        for report in reports:
            del report['seconds']
        check(reports[0] == reports[1])
        for name in ('map.obj', 'map.svg', 'grid.off'):
            check((one / name).read_bytes() == (many / name).read_bytes(), name)
        slices = sorted(many.glob('work/slice-*.json'))
        check(len(slices) > 2, slices)
        slices[1].unlink()  # as if it had been stopped
        moment = slices[0].stat().st_mtime_ns
        check_call(script('brute_force_on_many.sh', '../in/{} x.off', 'work', *words, cwd=many), 0)
        check(slices[1].exists() and slices[0].stat().st_mtime_ns == moment)
        check((one / 'map.obj').read_bytes() == (many / 'map.obj').read_bytes())
    for words, status in ((['in/{} x.off', 'work', '--strategy', 'hybrid'], 2), (['in/{} x.off', 'work', '--time-limit', '3'], 2),
                          (['in/missing.off', 'work'], 3), (['in/{} x.off', 'in'], 2), (['in/{} x.off'], 2)):
        finished = script('brute_force_on_many.sh', *words, cwd=folder)
        check_call(finished, status)
        check(finished.stderr.count(b'\n') == 1, finished.stderr)


def main():
    failed = 0
    tests = {name: test for name, test in globals().items() if name.startswith('test_')}
    for name, test in tests.items():
        if len(sys.argv) > 4 and name not in sys.argv[4:]:
            continue
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(pathlib.Path(folder))
                print('%s: passed, %.1f s' % (name, time.monotonic() - start), flush=True)
            except AssertionError as error:
                failed += 1
                print('%s: FAILED: %s' % (name, error), flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
