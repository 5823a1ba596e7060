"""An oedometer test: a bed of particles that break is compressed in a rigid container by a plate. Stress and strain, gradings, contacts.

    yade -n -x scripts/oedometer.py --output results/cube --mode cube
    yade -n -x scripts/oedometer.py --output results/modes --modes cube,balls4,balls18

YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the script's own after it. SI units. What is
measured, and how, is told in docs/oedometer.md.
"""
import os
import sys

from yade.superquadric import Interrupted
from yade.superquadric.experiments.oedometer import comparison as oedometercomparison
from yade.superquadric.experiments.oedometer.parameters import OedometerParameters
from yade.superquadric.experiments.oedometer.report import FILES, text
from yade.superquadric.experiments.oedometer.run import OedometerRun
from yade.superquadric.pictures import renderer
from yade.superquadric.runs import commandline
from yade.superquadric.runs.commandline import BAD_INPUT, INTERRUPTED, parametersOf
from yade.superquadric.runs.parameters import addOptions
from yade.superquadric.runs.staged import DONE


def parser():
    """The command line: an option for every parameter of the test."""
    result = commandline.parser('scripts/oedometer.py', __doc__, os.path.join('results', 'oedometer'))
    result.add_argument('--bed', metavar='FOLDER', help='take the finished bed in that folder instead of making one')
    result.add_argument('--bedOnly', action='store_true', help='stop when the plate sits on the bed, and leave it in the output folder for --bed')
    result.add_argument('--modes', metavar='MODE,...', help='crush the same bed by each of these modes, in folders of their own, and compare; '
                        'goes on where it was stopped')
    addOptions(result, OedometerParameters)
    return result


def checkOptions(options):
    """ValueError for options that do not go together."""
    if options.bed and options.bedOnly:
        raise ValueError(f'bedOnly: the bed in {options.bed!r} is finished; there is nothing to do')
    for name in ('resume', 'takeUp', 'bed', 'bedOnly', 'mode'):
        if options.modes and getattr(options, name, None):
            raise ValueError(f'modes = {options.modes!r}: not together with {name}')


def start(options, stream):
    """The run, begun, or taken up where it was interrupted."""
    if commandline.resumes(options, OedometerRun, options.output):
        return OedometerRun.resume(options.output, stream)
    if options.bed:
        return OedometerRun.onBed(options.bed, parametersOf(options, OedometerParameters), options.output, stream)
    return OedometerRun.begin(parametersOf(options, OedometerParameters), options.output, stream)


def single(options, stream):
    """One test, or one bed."""
    run = start(options, stream)
    run.pictures = not options.noPictures
    summary = run.run(until=OedometerRun.AFTER_BED if options.bedOnly else DONE)
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
    summaries = oedometercomparison.compare(modes, parametersOf(options, OedometerParameters), options.output, stream, not options.noPictures)
    print(oedometercomparison.text(summaries))
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
