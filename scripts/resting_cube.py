"""Cubes come to rest and stay: drift and residual energy over many steps, on a wall and on another cube.

    yade -n -x scripts/resting_cube.py [STEPS]

Prints a table; 1,000,000 steps each by default, which takes about a minute and a half. m g d is weight times overlap. At rest means a kinetic energy
below 1e-10 m g d; the drift is counted from then on, or after 1,000,000 steps of a cube that never was.
"""
import sys

from yade.superquadric.validations.restingcube import HALF, RestingCube

CASES = (
    ('wall, E = 1e8', dict(floor='wall', young=1e8)),
    ('wall', dict(floor='wall')),
    ('wall, n = 20', dict(floor='wall', n=20)),
    ('cube, E = 1e8', dict(floor='cube', young=1e8)),
    ('cube', dict(floor='cube')),
    ('cube, n = 20', dict(floor='cube', n=20)),
    ('cube, 0.6 off the middle', dict(floor='cube', offset=0.6)),
    ('wall, slope 0.3', dict(floor='wall', slope=0.3)),
    ('cube, slope 0.3', dict(floor='cube', slope=0.3)),
    ('wall, no rolling friction', dict(floor='wall', rollingFriction=0)),
    ('cube, no rolling friction', dict(floor='cube', rollingFriction=0)),
)
MOST = 1000000  # steps to come to rest


def main(steps):
    print(f'{"floor":27} {"at rest after":>14} {"overlap/a":>10} {"drift/a":>10} {"turn [rad]":>10} {"energy/mgd":>10}')
    for name, case in CASES:
        cube = RestingCube(**case)
        settled = cube.settle(MOST)
        drift = cube.watch(steps)
        values = cube.overlap() / HALF, drift.shift / HALF, drift.turn, drift.energy
        print(f'{name:27} {settled or "not":>14} ' + ' '.join(f'{value:10.1e}' for value in values), flush=True)


main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000000)
