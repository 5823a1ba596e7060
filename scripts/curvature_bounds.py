"""What the choices that the paper leaves open in the contact law change: one bed, hit once under each of them.

    yade -n -x scripts/curvature_bounds.py [OUTPUT_FOLDER]

Pours the default bed of scripts/impact.py once (folder/bed; taken up again where it exists, finished or not) and lets the impactor fall on it for each
variant. Prints a table and writes it as curvature_bounds.csv into the folder (default: results/curvature_bounds).
"""
import csv
import os
import shutil
import sys

from yade import O
from yade.superquadric import ImpactRun
from yade.superquadric.engines import engine
from yade.wrapper import InteractionLoop

VARIANTS = (
    ('default', {}),
    ('overlapLimit 0.03', {'overlapLimit': 0.03}),
    ('overlapLimit 0.3', {'overlapLimit': 0.3}),
    ("the paper's m* to the letter", {'leverArms': False}),
)
COLUMNS = ('variant', 'peak [N]', 'duration [ms]', 'buffering ratio')


def pouredBed(folder):
    """Folder with the checkpoint of the bed at rest, the impactor above it."""
    begun = os.path.exists(os.path.join(folder, 'checkpoint.json'))
    run = ImpactRun.resume(folder) if begun else ImpactRun.begin(study.defaults(), folder)
    run.run(until='impact')
    return folder


def impact(bed, folder, law):
    """Summary of the impact on a copy of the bed, with the attributes `law` of the contact law."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(bed, folder)
    run = ImpactRun.resume(folder)
    engine(InteractionLoop).lawDispatcher.functors[0].updateAttrs(law)
    return run.run()


def main(output):
    bed = pouredBed(os.path.join(output, 'bed'))
    table = []
    for number, (name, law) in enumerate(VARIANTS):
        summary = impact(bed, os.path.join(output, f'variant{number}'), law)
        table.append((name, round(summary['impact']['peak'], 1), round(1e3 * summary['impact']['duration'], 3), round(summary['bufferingRatio'], 4)))
        print('%-30s P = %7.1f N, duration %.3f ms, buffering %.4f' % table[-1], flush=True)
        O.reset()
    with open(os.path.join(output, 'curvature_bounds.csv'), 'w', newline='') as file:
        csv.writer(file).writerows([COLUMNS, *table])


main(sys.argv[1] if len(sys.argv) > 1 else 'results/curvature_bounds')
