"""An impactor falls on a bed of particles in a rigid cylinder: the force on the base, its peak, the buffering ratio.

    yade -n -x scripts/impact.py --output demo --shape cube --thickness 0.025
    yade-batch scripts/impact.table scripts/impact.py

YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the script's own
after it. SI units. What is measured, and how, is told in docs/impact.md.
"""
import argparse
import os
import sys

from yade import O, utils
from yade.superquadric import Interrupted, ImpactRun, report, study

BAD_INPUT, INTERRUPTED = 2, 130  # exit codes


def parser():
    """The command line: an option for every parameter of the study."""
    result = argparse.ArgumentParser(prog='yade -n -x scripts/impact.py', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('--output', metavar='FOLDER', help='folder for the results (default: results/impact, or '
                        'results/ and the batch table\'s description)')
    result.add_argument('--resume', action='store_true', help='go on with the interrupted run in that folder; '
                        'parameters are those it was started with')
    result.add_argument('--quiet', action='store_true', help='no progress')
    for parameter in study.PARAMETERS:
        unit = f' [{parameter.unit}]' if parameter.unit else ''
        default = '' if parameter.default is None else f' (default: {parameter.default})'
        # Values stay text here: the study's own checks turn them into numbers and name what is wrong.
        result.add_argument('--' + parameter.name, metavar='VALUE', default=argparse.SUPPRESS,
                            help=(parameter.help + unit + default).replace('%', '%%'))
    return result


def fromTable():
    """Parameters of this job's line in the batch table, and its description; nothing and "impact" without yade-batch."""
    if not os.environ.get('YADE_BATCH'):
        return {}, 'impact'
    rows = utils.TableParamReader(os.environ['YADE_BATCH'].rsplit(':', 1)[0]).paramDict()
    columns = {name for row in rows.values() for name in row if name != 'description' and not name.startswith('!')}
    utils.readParamsFromTable(unknownOk=True, **study.defaults())
    from yade.params import table
    return {name: getattr(table, name) for name in columns}, O.tags['description']


def main():
    options = vars(parser().parse_args(sys.argv[1:]))
    output, resume, quiet = (options.pop(name) for name in ('output', 'resume', 'quiet'))
    stream = None if quiet else sys.stderr
    try:
        parameters, description = fromTable()
        parameters.update(options)
        output = output or os.path.join('results', description)
        run = ImpactRun.resume(output, stream) if resume else ImpactRun.begin(parameters, output, stream)
    except ValueError as error:
        print(f'impact.py: {error}', file=sys.stderr)
        return BAD_INPUT
    try:
        print(report.text(run.run()))
    except Interrupted:
        print(f'Stopped. Data and checkpoint are in {output}; go on with:\n'
              f'  yade -n -x {sys.argv[0]} --output {output} --resume', file=sys.stderr)
        return INTERRUPTED
    except ValueError as error:
        print(f'impact.py: {error}\nData and checkpoint are in {output}.', file=sys.stderr)
        return BAD_INPUT
    print(f'results    {output}/summary.json, force.csv, force.png, bed.png')
    return 0


sys.exit(main())
