#!/usr/bin/env python3
"""Stands in for `yade -j1 -n -x scripts/impact.py ...` in the tests of the workflow: makes beds and impacts of nothing, at once.

Like the real one it needs the bed for an impact, gives its results their names when they are complete, leaves a checkpoint on SIGTERM or Ctrl-C
and goes on from it. Files in the folder FAKE_ORDERS tell it what to do in the job of a name: `hold.NAME` (wait while it is there),
`fail.NAME`; it writes `begun.NAME` with its process id, and `done.NAME` with how it began.
"""
import argparse
import hashlib
import json
import os
import signal
import sys
import time

orders = os.environ['FAKE_ORDERS']


def order(kind, name):
    return os.path.join(orders, f'{kind}.{name}')


def write(path, text):
    with open(path + '.part', 'w', encoding='utf-8') as file:
        file.write(text)
    os.replace(path + '.part', path)


def stop(number, frame):
    write('checkpoint.json', '{}')
    sys.exit(130)


def summary(parameters, force):
    return {
        'parameters': parameters, 'particle': {'number': 100}, 'P0': 4000.0, 'bufferingRatio': 1 - force / 4000, 'threads': 1,
        'bed': {'thickness': parameters['thickness'], 'packingFraction': 0.6, 'innerPackingFraction': None, 'staticForce': 10.0,
                'weight': 10.1, 'atRest': {'soft': True, 'true': True}, 'pours': [{}], 'wallSeconds': 1.0},
        'impactor': {'surfaceSpeed': 5.5}, 'timeStep': {'impact': 1e-6}, 'wallSeconds': 2.0,
        'impact': {'peak': force, 'peakTime': 1e-3, 'duration': 2e-3, 'lastTime': 3e-3, 'impulse': 1.0, 'over': True},
        'solver': {'solves': 5, 'iterations': 9, 'fallbacks': 0, 'uncertified': 0},
        'versions': {'yade': '1', 'yade-superquadric': '2', 'python': '3', 'numpy': '4'}}


def main():
    parser = argparse.ArgumentParser()
    for name in ('--parameters', '--output', '--bed'):
        parser.add_argument(name)
    for name in ('--quiet', '--noPictures', '--takeUp', '--bedOnly'):
        parser.add_argument(name, action='store_true')
    options = parser.parse_args(sys.argv[sys.argv.index('-x') + 2:])
    with open(options.parameters, encoding='utf-8') as file:
        parameters = json.load(file)
    if not options.bedOnly:
        with open(os.path.join(options.bed, 'bed.json'), encoding='utf-8') as file:
            assert json.load(file)['parameters']['thickness'] == parameters['thickness']
    os.chdir(options.output)
    name = os.path.basename(os.getcwd())
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
    takenUp = os.path.exists('checkpoint.json')
    write(order('begun', name), str(os.getpid()))
    while os.path.exists(order('hold', name)):
        time.sleep(0.02)
    if os.path.exists(order('fail', name)):
        print('impact.py: thickness = 1: not today', file=sys.stderr)
        return 2
    force = 100 + int(hashlib.sha256(name.encode()).hexdigest()[:3], 16) / 10
    write('force.csv', f'time,baseForce\n0.0,10.0\n0.001,{force + 10}\n0.004,10.0\n')
    if options.bedOnly:
        from yade.superquadric.files import sealed  # takes a second, and impacts do not need it
        write('bed.yade.gz', f'scene of {name}')
        sealed.write('bed.json', {'parameters': parameters}, ('bed.yade.gz',))
    else:
        write('summary.json', json.dumps(summary(parameters, force)))
    if takenUp:
        os.remove('checkpoint.json')
    write(order('done', name), 'taken up' if takenUp else 'new')
    return 0


sys.exit(main())
