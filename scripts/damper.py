"""Particles in a box on a spring, under a harmonic force: how the box answers, how the particles move, and where the energy goes.

    yade -n -x scripts/damper.py --output results/damper/30.2 --frequency 30.2

One run is one frequency. YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the
script's own after it. SI units. What is measured, and how, is told in docs/damper.md.
"""
import argparse
import os
import sys

from yade.superquadric import Interrupted
from yade.superquadric.damper import DamperRun
from yade.superquadric.damperparameters import PARAMETERS
from yade.superquadric.damperreport import FILES, text
from yade.superquadric.parameterlist import addOptions, fromFile, given

BAD_INPUT, INTERRUPTED = 2, 130  # exit codes


def parser():
    """The command line: an option for every parameter of the study."""
    result = argparse.ArgumentParser(prog='yade -n -x scripts/damper.py', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('--output', metavar='FOLDER', default=os.path.join('results', 'damper'),
                        help='folder for the results (default: %(default)s)')
    result.add_argument('--resume', action='store_true', help='go on with the interrupted run in that folder; parameters are those it was '
                        'started with')
    result.add_argument('--takeUp', action='store_true', help='the same where the folder holds an interrupted run; else begin one')
    result.add_argument('--noPictures', action='store_true', help='draw none')
    result.add_argument('--parameters', metavar='FILE', help='JSON file {name: value} of parameters; options override it')
    result.add_argument('--quiet', action='store_true', help='no progress')
    addOptions(result, PARAMETERS)
    return result


def start(options):
    """The run, begun, or taken up where it was interrupted."""
    stream = None if options.quiet else sys.stderr
    if options.resume or (options.takeUp and DamperRun.isInterrupted(options.output)):
        return DamperRun.resume(options.output, stream)
    return DamperRun.begin({**fromFile(options.parameters), **given(options, PARAMETERS)}, options.output, stream)


def main():
    options = parser().parse_args(sys.argv[1:])
    try:
        run = start(options)
        run.pictures = not options.noPictures
        summary = run.run()
    except Interrupted:
        print(f'Stopped. A checkpoint is in {options.output}; go on with:\n  yade -n -x {sys.argv[0]} --output {options.output} --resume',
              file=sys.stderr)
        return INTERRUPTED
    except (OSError, ValueError) as error:
        print(f'damper.py: {error}', file=sys.stderr)
        return BAD_INPUT
    print(text(summary))
    print(f'results    {options.output}/{", ".join(FILES[:2] if options.noPictures else FILES)}')
    return 0


sys.exit(main())
