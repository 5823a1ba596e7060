"""A sphere on a wall under the elastoplastic law: loading, unloading and reloading, and restitution over speed.

    yade -n -x scripts/elastoplastic_collision.py [OUTPUT_FOLDER]

Writes path.csv, restitution.csv and elastoplastic_collision.png into the folder (default: results/elastoplastic_collision) and prints
the fitted exponents of the restitution far above yield, to be held against their limits (H - 3)/(H + 2): for H = 2, which is a constant mean
pressure, Johnson's -1/4 (Contact Mechanics, section 11.5).
"""
import csv
import os
import sys

import matplotlib
from yade.wrapper import ElastoplasticMat

from yade.superquadric.validations import elastoplasticimpact

matplotlib.use('Agg')
import matplotlib.pyplot as plt

RADIUS = 2.5e-3  # [m]
TURNING_POINTS = (10, 5, 20, 8, 20, 30, 0)  # overlaps over that at yield
HARDENINGS = (1.6, 2.0, 2.4)  # exponents H
SPEEDS = [10 ** (i / 4) for i in range(-2, 17)]  # over the one that just reaches yield
FITTED_FROM = 300  # the same


def pathTable():
    """(path, overlap over dy, force over fy)"""
    point = elastoplasticimpact.yieldPoint(ElastoplasticMat(**elastoplasticimpact.ALUMINIUM), RADIUS)
    paths = elastoplasticimpact.pressedPath(elastoplasticimpact.ALUMINIUM, RADIUS, [part * point.overlap for part in TURNING_POINTS])
    return [(number, overlap / point.overlap, force / point.force) for number, path in enumerate(paths, 1) for overlap, force in path]


def restitutionTable():
    """(H, speed over that at yield, restitution)"""
    for exponent in HARDENINGS:
        properties = dict(elastoplasticimpact.ALUMINIUM, exponent=exponent)
        yieldSpeed = elastoplasticimpact.yieldPoint(ElastoplasticMat(**properties), RADIUS).speed
        for part in SPEEDS:
            yield exponent, part, elastoplasticimpact.restitution(properties, RADIUS, part * yieldSpeed)


def fits(table):
    """{H: PowerLaw} of the restitutions far above yield."""
    far = {exponent: [row[1:] for row in table if row[0] == exponent and row[1] >= FITTED_FROM] for exponent in HARDENINGS}
    return {exponent: elastoplasticimpact.powerLaw(*zip(*rows)) for exponent, rows in far.items()}


def drawPath(axis, table):
    deepest = 0
    for number in range(1, len(TURNING_POINTS) + 1):
        path = [row[1:] for row in table if row[0] == number]
        axis.plot(*zip(*[point for point in path if point[0] <= deepest]), '--', color='C0', lw=1.6)
        axis.plot(*zip(*[point for point in path if point[0] >= deepest]), '-', color='C3', lw=1.6)
        deepest = max(deepest, path[-1][0])
    hertz = [(i / 10, (i / 10) ** 1.5) for i in range(121)]
    axis.plot(*zip(*hertz), color='0.6', lw=1, label='Hertz')
    axis.plot([], [], 'C3-', label='loading')
    axis.plot([], [], 'C0--', label='unloading and reloading')
    axis.plot([1], [1], 'k.', label='yield')
    axis.set(xlabel='overlap $d/d_y$', ylabel='force $f/f_y$', xlim=(0, None), ylim=(0, None))
    axis.set_title(f'Four paths, $H$ = {elastoplasticimpact.ALUMINIUM["exponent"]:g}')


def drawRestitution(axis, table, laws):
    for exponent, law in laws.items():
        rows = [row[1:] for row in table if row[0] == exponent]
        line, = axis.loglog(*zip(*rows), 'o', ms=4, label=f'$H$ = {exponent:g}: $V^{{{law.exponent:.3f} \\pm {law.halfWidth:.3f}}}$')
        far = [FITTED_FROM, max(SPEEDS)]
        axis.loglog(far, [law.factor * part ** law.exponent for part in far], '-', color=line.get_color(), lw=1)
    axis.loglog(SPEEDS, [1.3 * part ** -0.25 for part in SPEEDS], 'k:', lw=1.2, label='slope $-1/4$ (Johnson)')
    axis.axvline(1, color='0.8', lw=1, zorder=0)
    axis.set(xlabel='speed $V/V_y$', ylabel='restitution', ylim=(0.04, 1.3), title='Restitution')
    axis.set_yticks([0.05, 0.1, 0.2, 0.5, 1], ['0.05', '0.1', '0.2', '0.5', '1'])


def draw(path, restitution, laws, file):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    drawPath(axes[0], path)
    drawRestitution(axes[1], restitution, laws)
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    figure.suptitle('Sphere on a wall under the elastoplastic law')
    figure.savefig(file, dpi=130)


def write(file, columns, table):
    with open(file, 'w', newline='') as output:
        writer = csv.writer(output)
        writer.writerow(columns)
        writer.writerows([f'{value:.6g}' for value in row] for row in table)


def main(folder):
    os.makedirs(folder, exist_ok=True)
    path, restitution = pathTable(), list(restitutionTable())
    laws = fits(restitution)
    write(os.path.join(folder, 'path.csv'), ('path', 'd/dy', 'f/fy'), path)
    write(os.path.join(folder, 'restitution.csv'), ('H', 'V/Vy', 'restitution'), restitution)
    draw(path, restitution, laws, os.path.join(folder, 'elastoplastic_collision.png'))
    for exponent, law in laws.items():
        print(f'H = {exponent:g}: restitution falls as V^({law.exponent:.4f} +- {law.halfWidth:.4f}) '
              f'from {FITTED_FROM} to {max(SPEEDS):g} times the yield speed; '
              f'limit {elastoplasticimpact.limitExponent(exponent):.4f}')


main(sys.argv[1] if len(sys.argv) > 1 else 'results/elastoplastic_collision')
