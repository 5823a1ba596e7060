"""Particles that break once, each for itself: the sizes of their fragments, after Zhao & Chi, J. Northeastern Univ. Nat. Sci. 44(3), 408 (2023).

    yade -n -x scripts/single_particle_crushing.py [OUTPUT_FOLDER] [--parents 100]

Parents of 28-30 mm are broken by cuts u^p with p = 1, 2, 3 and held against the exact distribution (figure 2), again with other seeds (figure 3), and
parents of ten classes from 20-22 to 38-40 mm against each other (figure 4). The eight fragments of a parent depend on each other: p-values come
from simulating, or exchanging, whole parents. Writes single_particle_crushing.csv, .json and, without --noPictures, .png (figure 2),
_repetitions.png (3), _classes.png (4).
"""
import argparse
import os
import sys

from yade.superquadric import checks
from yade.superquadric.files import results
from yade.superquadric.runs.versions import versions
from yade.superquadric.validations import crushingplots, cutdistribution, singlecrushing

EXPONENTS, CHOSEN = (1, 2, 3), 2  # of the cut; the one that fits tests on rock, as the paper finds
NAME = 'single_particle_crushing'  # all its files begin with it
CLASS, LARGEST = (28e-3, 30e-3), 30e-3  # [m]
CLASSES = [(low * 1e-3, (low + 2) * 1e-3) for low in range(20, 40, 2)]  # [m]
REPETITIONS = 10


def options():
    parser = argparse.ArgumentParser(prog='yade -n -x scripts/single_particle_crushing.py', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('output', metavar='FOLDER', nargs='?', default=os.path.join('results', NAME), help='(default: %(default)s)')
    parser.add_argument('--parents', metavar='NUMBER', default=100, help='number of particles in each class (default: %(default)s)')
    parser.add_argument('--seed', metavar='NUMBER', default=1, help='of their sizes and cuts (default: %(default)s)')
    parser.add_argument('--noPictures', action='store_true', help='draw none')
    given = parser.parse_args(sys.argv[1:])
    given.parents, given.seed = checks.wholeNumber('parents', given.parents, 2), checks.wholeNumber('seed', given.seed, 0)
    return given


def broken(bounds, exponent, number, sizeSeed, cutSeed):
    """Sizes of parents in a class and of their fragments [m]."""
    parents = singlecrushing.uniformSizes(*bounds, number, sizeSeed)
    return parents, singlecrushing.breakEach(parents, exponent, cutSeed)


def byExponent(number, seed):
    """{p: (parents, fragments)}, of the same parents and uniform numbers."""
    return {exponent: broken(CLASS, exponent, number, seed, seed) for exponent in EXPONENTS}


def byClass(number, seed):
    """{class: (parents, fragments)} with cuts of their own."""
    return {bounds: broken(bounds, CHOSEN, number, seed + i, seed + i) for i, bounds in enumerate(CLASSES)}


def summaryOf(exponents, classes):
    summary = {'exponents': {}, 'classes': {}}
    for exponent, (parents, fragments) in exponents.items():
        found, pValue = cutdistribution.agreement(fragments, exponent, parents, LARGEST)
        summary['exponents'][exponent] = {'distance': found, 'pValue': pValue, 'meanSize': float((fragments / LARGEST).mean())}
    for name, groups in (('overLargest', [fragments / bounds[1] for bounds, (_, fragments) in classes.items()]),
                         ('overParents', [(fragments.T / parents).T for parents, fragments in classes.values()])):
        found, pValue = cutdistribution.sameDistribution(groups)
        summary['classes'][name] = {'distance': found, 'pValue': pValue}
    return summary


def rows(exponents, classes):
    """(class from, class to, p, parent's size, fragment's size) [m]"""
    groups = [(CLASS, exponent, *group) for exponent, group in exponents.items()] + [(bounds, CHOSEN, *group) for bounds, group in classes.items()]
    for bounds, exponent, parents, fragments in groups:
        for parent, row in zip(parents, fragments):
            for size in row:
                yield (*bounds, exponent, parent, size)


def draw(folder, exponents, repeated, classes):
    ratios = [parent / LARGEST for parent in exponents[CHOSEN][0]]
    crushingplots.exponents(os.path.join(folder, f'{NAME}.png'), {p: fragments / LARGEST for p, (_, fragments) in exponents.items()}, ratios)
    crushingplots.repetitions(os.path.join(folder, f'{NAME}_repetitions.png'), [fragments / LARGEST for fragments in repeated], CHOSEN, ratios)
    crushingplots.classes(os.path.join(folder, f'{NAME}_classes.png'), {bounds: fragments / bounds[1] for bounds, (_, fragments) in classes.items()})


def report(summary):
    for exponent, found in summary['exponents'].items():
        print(f'p = {exponent}: mean size {found["meanSize"]:.4f} d_max; Kolmogorov\'s distance from the exact distribution {found["distance"]:.4f}, '
              f'p-value {found["pValue"]:.3f}')
    for name, what in (('overLargest', 'd_max of the class'), ('overParents', 'the parent\'s size')):
        found = summary['classes'][name]
        print(f'classes, sizes over {what}: largest distance of one from all {found["distance"]:.4f}, p-value {found["pValue"]:.3f}')


def main():
    try:
        given = options()
        os.makedirs(given.output, exist_ok=True)
    except (OSError, ValueError) as error:
        print(f'single_particle_crushing.py: {error}', file=sys.stderr)
        return 2
    exponents, classes = byExponent(given.parents, given.seed), byClass(given.parents, given.seed)
    summary = summaryOf(exponents, classes)
    results.writeCsv(os.path.join(given.output, f'{NAME}.csv'), ('classFrom', 'classTo', 'exponent', 'parent', 'fragment'),
                     rows(exponents, classes))
    results.writeJson(os.path.join(given.output, f'{NAME}.json'),
                      {'parents': given.parents, 'seed': given.seed, **summary, 'versions': versions()})
    if not given.noPictures:
        repeated = [singlecrushing.breakEach(exponents[CHOSEN][0], CHOSEN, given.seed + 100 + i) for i in range(REPETITIONS)]
        draw(given.output, exponents, repeated, classes)
    report(summary)
    print(f'results    {given.output}')
    return 0


sys.exit(main())
