#!/usr/bin/env python3
"""The constants of the elastoplastic contact law of a metal, from its stress-strain curve by finite elements:

    tools/env --with fem python3 scripts/identify_plasticity.py MATERIAL.yaml --output FOLDER [--quick] [--largest 0.15]

MATERIAL.yaml: see yade.superquadric.plasticity.materialfile; what it has of `hardening` and `fit` is found anew. FOLDER gets the identified
material file under the same name, curves (CSV), pictures, and page.md, which says how far to trust it.
"""
import argparse
import os
import sys
import time

os.environ['OPENBLAS_NUM_THREADS'] = '1'   # the same bit for bit, and no waiting of threads for each other; before numpy is loaded

from yade.superquadric import checks
from yade.superquadric.materials import materialfile
from yade.superquadric.plasticity import cases
from yade.superquadric.plasticity.contact import NotConverged
from yade.superquadric.plasticity.identify import Identification

FAILED, BAD_INPUT = 1, 2
LARGEST = 0.3   # beyond, strains and slopes are not small


def parser():
    result = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('material', metavar='MATERIAL.yaml', help='name, source, young, poisson, density, yieldStress, stressStrain; SI units')
    result.add_argument('--output', metavar='FOLDER', required=True, help='is made where it is missing')
    result.add_argument('--quick', action='store_true', help='a coarse mesh and fewer loads: minutes; the constants change by some percent')
    result.add_argument('--largest', type=float, default=cases.FULL.largest, metavar='RATIO',
                        help='sqrt(R d)/R of the largest load (%(default)s); smaller, and the law fits slow collisions better')
    return result


def main():
    options = parser().parse_args()
    begin = time.monotonic()
    report = lambda line: print(f'{time.monotonic() - begin:5.0f} s  {line}', flush=True)
    name = os.path.splitext(os.path.basename(options.material))[0]
    try:
        material = materialfile.read(options.material, identified=False)
        largest = checks.within('largest', options.largest, 0.02, LARGEST)
        os.makedirs(options.output, exist_ok=True)
    except (ValueError, OSError) as error:
        print(f'identify_plasticity.py: {error}', file=sys.stderr)
        return BAD_INPUT
    settings = (cases.QUICK if options.quick else cases.FULL)._replace(largest=largest)
    return identify(material, settings, options.output, name, report)


def identify(material, settings, output, name, report):
    """Compute and write everything. Returns the exit code."""
    try:
        found = Identification(material, settings, report)
        found.write(output, name)
    except (ValueError, OSError, NotConverged) as error:
        print(f'identify_plasticity.py: {error}', file=sys.stderr)
        return FAILED
    law = found.law
    print(*(f'{key:10}{law.constants[key]:.4g}  [{low:.4g}, {high:.4g}]' for key, (low, high) in law.intervals.items()), sep='\n')
    print(f'{"error":10}{100 * law.rms:.2f} % of the force (rms), {100 * law.largest:.1f} % at most; Hertz within {100 * found.hertzError:.2f} %')
    print(f'{"results":10}{output}/{name}.yaml, page.md')
    return 0


if __name__ == '__main__':
    sys.exit(main())
