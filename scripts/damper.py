"""Particles in a box on a spring, under a harmonic force: how the box answers, how the particles move, and where the energy goes.

    yade -n -x scripts/damper.py --output results/damper/30.2 --frequency 30.2

One run is one frequency. YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the
script's own after it. SI units. What is measured, and how, is told in docs/damper.md.
"""
import os
import sys

from yade.superquadric import Interrupted
from yade.superquadric.experiments.damper.parameters import DamperParameters
from yade.superquadric.experiments.damper.report import FILES, text
from yade.superquadric.experiments.damper.run import DamperRun
from yade.superquadric.runs import commandline
from yade.superquadric.runs.commandline import BAD_INPUT, INTERRUPTED
from yade.superquadric.runs.parameters import addOptions


def parser():
    """The command line: an option for every parameter of the study."""
    result = commandline.parser('scripts/damper.py', __doc__, os.path.join('results', 'damper'))
    addOptions(result, DamperParameters)
    return result


def start(options):
    """The run, begun, or taken up where it was interrupted."""
    stream = None if options.quiet else sys.stderr
    if commandline.resumes(options, DamperRun, options.output):
        return DamperRun.resume(options.output, stream)
    return DamperRun.begin(commandline.parametersOf(options, DamperParameters), options.output, stream)


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
