"""An oedometer test: a bed of particles that break is compressed in a rigid container by a plate. Stress and strain, gradings, contacts.

    yade -n -x scripts/oedometer.py --output results/cube --mode cube
    yade -n -x scripts/oedometer.py --output results/modes --modes cube,balls4,balls18

YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the script's own after it. SI units. What is
measured, and how, is told in docs/oedometer.md.
"""
import argparse
import os
import sys

from yade.superquadric import Interrupted, oedometercomparison
from yade.superquadric.oedometer import OedometerRun
from yade.superquadric.oedometerparameters import PARAMETERS
from yade.superquadric.oedometerreport import FILES, text
from yade.superquadric.parameterlist import addOptions, fromFile, given

BAD_INPUT, INTERRUPTED = 2, 130  # exit codes


def parser():
    """The command line: an option for every parameter of the test."""
    result = argparse.ArgumentParser(prog='yade -n -x scripts/oedometer.py', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('--output', metavar='FOLDER', default=os.path.join('results', 'oedometer'),
                        help='folder for the results (default: %(default)s)')
    result.add_argument('--resume', action='store_true', help='go on with the interrupted run in that folder; parameters are those it was '
                        'started with')
    result.add_argument('--takeUp', action='store_true', help='the same where the folder holds an interrupted run; else begin one')
    result.add_argument('--bed', metavar='FOLDER', help='take the finished bed in that folder instead of making one')
    result.add_argument('--bedOnly', action='store_true', help='stop when the plate sits on the bed, and leave it in the output folder for --bed')
    result.add_argument('--modes', metavar='MODE,...', help='crush the same bed by each of these modes, in folders of their own, and compare; '
                        'goes on where it was stopped')
    result.add_argument('--noPictures', action='store_true', help='draw none')
    result.add_argument('--parameters', metavar='FILE', help='JSON file {name: value} of parameters; options override it')
    result.add_argument('--quiet', action='store_true', help='no progress')
    addOptions(result, PARAMETERS)
    return result


def parametersOf(options):
    """From file and command line."""
    return {**fromFile(options.parameters), **given(options, PARAMETERS)}


def checkOptions(options):
    """ValueError for options that do not go together."""
    if options.bed and options.bedOnly:
        raise ValueError(f'bedOnly: the bed in {options.bed!r} is finished; there is nothing to do')
    for name in ('resume', 'takeUp', 'bed', 'bedOnly', 'mode'):
        if options.modes and getattr(options, name, None):
            raise ValueError(f'modes = {options.modes!r}: not together with {name}')


def start(options, stream):
    """The run, begun, or taken up where it was interrupted."""
    if options.resume or (options.takeUp and OedometerRun.isInterrupted(options.output)):
        return OedometerRun.resume(options.output, stream)
    if options.bed:
        return OedometerRun.onBed(options.bed, parametersOf(options), options.output, stream)
    return OedometerRun.begin(parametersOf(options), options.output, stream)


def single(options, stream):
    """One test, or one bed."""
    run = start(options, stream)
    run.pictures = not options.noPictures
    summary = run.run(until='prepare' if options.bedOnly else 'done')
    if options.bedOnly:
        print(f'bed        {options.output}, for --bed')
    else:
        print(text(summary))
        if run.pictures and renderer.missing():
            print(f'pictures   {renderer.missing()}')
        print(f'results    {options.output}/{", ".join(name for name in FILES if os.path.exists(run.path(name)))}')


def comparison(options, stream):
    """Several tests on one bed."""
    modes = oedometercomparison.modesOf(options.modes)
    print(oedometercomparison.text(oedometercomparison.compare(modes, parametersOf(options), options.output, stream, not options.noPictures)))
    print(f'results    {options.output}/{oedometercomparison.TABLE}, and a folder for each mode')


def main():
    options = parser().parse_args(sys.argv[1:])
    stream = None if options.quiet else sys.stderr
    try:
        checkOptions(options)
        (comparison if options.modes else single)(options, stream)
    except Interrupted:
        again = f'--modes {options.modes}' if options.modes else '--resume' + (' --bedOnly' if options.bedOnly else '')
        print(f'Stopped. A checkpoint is in {options.output}; go on with:\n  yade -n -x {sys.argv[0]} --output {options.output} {again}'
              + (' and the same parameters' if options.modes else ''), file=sys.stderr)
        return INTERRUPTED
    except (OSError, ValueError) as error:
        print(f'oedometer.py: {error}', file=sys.stderr)
        return BAD_INPUT
    return 0


sys.exit(main())
