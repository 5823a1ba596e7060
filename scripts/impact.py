"""An impactor falls on a bed of particles in a rigid cylinder: the force on the base, its peak, the buffering ratio.

    yade -n -x scripts/impact.py --output demo --shape cube --thickness 0.025
    yade-batch scripts/impact.table scripts/impact.py

YADE's own options (-n: no 3D view, -x: leave at the end, -j 2: two threads) come before the script, the script's own
after it. SI units. What is measured, and how, is told in docs/impact.md.
"""
import os
import sys

from yade import O, utils

from yade.superquadric import ImpactRun, Interrupted
from yade.superquadric.experiments.impact import pictures as impactpictures
from yade.superquadric.experiments.impact import report
from yade.superquadric.experiments.impact.parameters import ImpactParameters
from yade.superquadric.pictures import renderer
from yade.superquadric.runs import commandline
from yade.superquadric.runs.commandline import BAD_INPUT, INTERRUPTED, parametersOf
from yade.superquadric.runs.parameters import addOptions
from yade.superquadric.runs.staged import DONE
from yade.superquadric.vtk import polydata


def parser():
    """The command line: an option for every parameter of the study."""
    result = commandline.parser('scripts/impact.py', __doc__, None, "results/impact, or results/ and the batch table's description")
    result.add_argument('--bed', metavar='FOLDER', help='take the finished bed in that folder instead of pouring one')
    result.add_argument('--bedOnly', action='store_true', help='stop when the bed is at rest, and leave it in the output folder for --bed')
    result.add_argument('--vtk', action='store_true', help='also write the impact as a series for ParaView (folder vtk, see docs/view.md)')
    addOptions(result, ImpactParameters)
    return result


def fromTable():
    """Parameters of this job's line in the batch table, and its description; nothing and "impact" without yade-batch."""
    if not os.environ.get('YADE_BATCH'):
        return {}, 'impact'
    rows = utils.TableParamReader(os.environ['YADE_BATCH'].rsplit(':', 1)[0]).paramDict()
    columns = {name for row in rows.values() for name in row if name != 'description' and not name.startswith('!')}
    utils.readParamsFromTable(unknownOk=True, **ImpactParameters.defaults())
    from yade.params import table
    return {name: getattr(table, name) for name in columns}, O.tags['description']


def start(options):
    """The run, begun, or taken up where it was interrupted, and its folder."""
    if options.bed and options.bedOnly:
        raise ValueError(f'bedOnly: the bed in {options.bed!r} is finished; there is nothing to do')
    if options.vtk and options.bedOnly:
        raise ValueError('vtk: the series is of the impact; not together with bedOnly')
    table, description = fromTable()
    output = options.output or os.path.join('results', description)
    stream = None if options.quiet else sys.stderr
    if commandline.resumes(options, ImpactRun, output):
        return ImpactRun.resume(output, stream), output
    parameters = parametersOf(options, ImpactParameters, table)
    if options.bed:
        return ImpactRun.onBed(options.bed, parameters, output, stream), output
    return ImpactRun.begin(parameters, output, stream), output


def main():
    options = parser().parse_args(sys.argv[1:])
    try:
        if options.vtk:
            polydata.requireVtk()
        run, output = start(options)
        run.pictures = not options.noPictures
        run.state.vtk = options.vtk or run.state.vtk
        if run.state.vtk:  # resumed, perhaps elsewhere
            polydata.requireVtk()
    except (ImportError, OSError, ValueError) as error:
        print(f'impact.py: {error}', file=sys.stderr)
        return BAD_INPUT
    try:
        summary = run.run(until=ImpactRun.AFTER_BED if options.bedOnly else DONE)
    except Interrupted:
        print(f'Stopped. Data and checkpoint are in {output}; go on with:\n'
              f'  yade -n -x {sys.argv[0]} --output {output} --resume{" --bedOnly" if options.bedOnly else ""}', file=sys.stderr)
        return INTERRUPTED
    except ValueError as error:
        print(f'impact.py: {error}\nData and checkpoint are in {output}.', file=sys.stderr)
        return BAD_INPUT
    if options.bedOnly:
        print(f'bed        {output}, for --bed')
        return 0
    print(report.text(summary))
    if run.pictures and renderer.missing():
        print(f'pictures   {renderer.missing()}')
    print(f'results    {output}/{", ".join([report.SUMMARY, report.RECORD, *impactpictures.made(run)])}')
    return 0


sys.exit(main())
