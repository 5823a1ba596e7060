"""Write the table of a study's finished runs: `python3 scripts/study/collect.py --plan plan.json --folder FOLDER --output results.csv`."""
import argparse
import sys

from yade.superquadric.files import results
from yade.superquadric.study import table


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--plan', required=True, help='the plan of the study, JSON')
    parser.add_argument('--folder', required=True, help='the folder of the study, which holds the runs\'')
    parser.add_argument('--output', required=True, help='the table, CSV')
    options = parser.parse_args()
    try:
        plan = results.readJson(options.plan)
        rows = table.tableOf(plan, options.folder)
    except (OSError, ValueError) as error:
        print(f'collect.py: {error}', file=sys.stderr)
        return 2
    table.write(rows, options.output)
    print(f'{len(rows)} of {len(plan["runs"])} runs are in {options.output}')
    return 0


sys.exit(main())
