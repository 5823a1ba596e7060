#!/usr/bin/env python3
"""The constants of the elastoplastic contact law of a metal, from its stress-strain curve by finite elements:

    tools/env --with fem python3 scripts/identify_plasticity.py MATERIAL.yaml --output FOLDER [--quick]

MATERIAL.yaml: see yade.superquadric.plasticity.materialfile; what it has of `hardening` and `fit` is found anew. FOLDER gets the identified
material file under the same name, curves (CSV), pictures, and page.md, which says how far to trust it.
"""
import argparse
import os
import sys
import time

os.environ['OPENBLAS_NUM_THREADS'] = '1'   # the same bit for bit, and no waiting of threads for each other; before numpy is loaded

from yade.superquadric.plasticity import cases, materialfile

FAILED, BAD_INPUT = 1, 2


def parser():
    result = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('material', metavar='MATERIAL.yaml', help='name, source, young, poisson, density, yieldStress, stressStrain; SI units')
    result.add_argument('--output', metavar='FOLDER', required=True, help='is made where it is missing')
    result.add_argument('--quick', action='store_true', help='a coarse mesh and fewer loads: minutes; the constants change by some percent')
    return result


def main():
    options = parser().parse_args()
    begin = time.monotonic()
    report = lambda line: print(f'{time.monotonic() - begin:5.0f} s  {line}', flush=True)
    name = os.path.splitext(os.path.basename(options.material))[0]
    try:
        material = materialfile.read(options.material, identified=False)
        os.makedirs(options.output, exist_ok=True)
    except (ValueError, OSError) as error:
        print(f'identify_plasticity.py: {error}', file=sys.stderr)
        return BAD_INPUT
    return identify(material, options, name, report)


def identify(material, options, name, report):
    """Compute and write everything. Returns the exit code."""
    from yade.superquadric.plasticity.contact import NotConverged
    from yade.superquadric.plasticity.identify import Identification
    try:
        found = Identification(material, cases.QUICK if options.quick else cases.FULL, report)
        found.write(options.output, name)
    except (ValueError, OSError, NotConverged) as error:
        print(f'identify_plasticity.py: {error}', file=sys.stderr)
        return FAILED
    law = found.law
    print(*(f'{key:10}{law.constants[key]:.4g}  [{low:.4g}, {high:.4g}]' for key, (low, high) in law.intervals.items()), sep='\n')
    print(f'{"error":10}{100 * law.rms:.2f} % of the force (rms), {100 * law.largest:.1f} % at most; Hertz within {100 * found.hertzError:.2f} %')
    print(f'{"results":10}{options.output}/{name}.yaml, page.md')
    return 0


if __name__ == '__main__':
    sys.exit(main())
