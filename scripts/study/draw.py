#!/usr/bin/env python3
"""Draws the figures of a study and judges its findings, from what is finished of it.

    python3 scripts/study/draw.py --plan plan.json --table results.csv --records impacts --output figures
"""
import argparse
import sys

import pandas

from yade.superquadric.files import results
from yade.superquadric.study.page import drawStudy


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    for option, what in (('plan', 'the plan, JSON'), ('table', 'table of results, CSV, a row per finished run'),
                         ('records', 'folder with a folder for each run'), ('output', 'folder for figures and findings')):
        parser.add_argument('--' + option, required=True, help=what)
    options = parser.parse_args()
    try:
        content = drawStudy(results.readJson(options.plan), pandas.read_csv(options.table), options.records, options.output)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    verdicts = [finding['verdict'] for finding in content['findings']]
    print(f'{content["runs"]} of {content["plannedRuns"]} runs: '
          f'{sum(bool(figure["runs"]) for group in content["groups"] for figure in group["figures"])} figures'
          + ''.join(f', {verdicts.count(verdict)} {verdict}' for verdict in dict.fromkeys(verdicts)))
    return 0


if __name__ == '__main__':
    sys.exit(main())
