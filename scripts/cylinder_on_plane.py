"""Validation 1 of the paper: rebound of a cylinder from a plane at 0-90 degrees, table and figure.

    yade -n -x scripts/cylinder_on_plane.py [OUTPUT_FOLDER]

Writes cylinder_on_plane.csv and .png into the folder (default: results/cylinder_on_plane) and prints the table's worst errors.
"""
import csv
import os
import sys

import matplotlib

from yade.superquadric.validations import cylinderimpact

matplotlib.use('Agg')
import matplotlib.pyplot as plt

ANGLES = range(0, 91, 5)
EXPONENTS = (8.0, 12.0, 20.0)
COLUMNS = ('n1', 'angle [deg]', 'Vz+/V', 'closed form', 'r wy+/V', 'closed form', 'ideal cylinder Vz+/V', 'ideal cylinder r wy+/V')
SCALE = cylinderimpact.DIAMETER / 2 / cylinderimpact.SPEED  # of the spin, as in the paper's figure 7


def rows():
    """One row an angle and exponent, in the order of COLUMNS."""
    for n1 in EXPONENTS:
        for angle in ANGLES:
            measured, expected = cylinderimpact.impact(angle, n1)
            ideal = cylinderimpact.closedForm(cylinderimpact.idealLever(angle), cylinderimpact.MASS, cylinderimpact.INERTIA)
            yield (n1, angle, measured.velocity / cylinderimpact.SPEED, expected.velocity / cylinderimpact.SPEED,
                   SCALE * measured.spin, SCALE * expected.spin, ideal.velocity / cylinderimpact.SPEED, SCALE * ideal.spin)


def draw(table, path):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    inner = [row for row in table if row[0] == EXPONENTS[0] and 0 < row[1] < 90]
    for axis, measured, ideal, label in zip(axes, (2, 4), (6, 7), ('velocity $V_z^+/V$', 'spin $r\\,\\omega_y^+/V$')):
        axis.plot([r[1] for r in inner], [r[ideal] for r in inner], 'k--', lw=1, label='ideal cylinder, rigid')
        for color, n1 in enumerate(EXPONENTS):
            mine = [row for row in table if row[0] == n1]
            axis.plot([r[1] for r in mine], [r[measured] for r in mine], 'o', color=f'C{color}', ms=4, label=f'simulated, $n_1$ = {n1:g}')
            lines = [row for row in mine if 0 < row[1] < 90]
            axis.plot([r[1] for r in lines], [r[measured + 1] for r in lines], '-', color=f'C{color}', lw=1, label='its closed form')
        axis.set_xlabel('angle of the axis with the normal [degrees]')
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.suptitle('Cylinder on a plane, restitution 0.85: rounded edges shorten the lever arm, more so for small $n_1$')
    figure.savefig(path, dpi=130)


def main(folder):
    os.makedirs(folder, exist_ok=True)
    table = list(rows())
    with open(os.path.join(folder, 'cylinder_on_plane.csv'), 'w', newline='') as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows([f'{value:.5g}' for value in row] for row in table)
    draw(table, os.path.join(folder, 'cylinder_on_plane.png'))
    for n1 in EXPONENTS:
        mine = [row for row in table if row[0] == n1]
        print(f'n1 = {n1:4g}: worst error of Vz+/V {max(abs(r[2] - r[3]) for r in mine):.4f}, of r wy+/V {max(abs(r[4] - r[5]) for r in mine):.4f};'
              f' distance from the ideal cylinder at 5-85 degrees {max(abs(r[2] - r[6]) for r in mine if 0 < r[1] < 90):.3f}')


main(sys.argv[1] if len(sys.argv) > 1 else 'results/cylinder_on_plane')
