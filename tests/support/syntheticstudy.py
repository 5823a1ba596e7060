"""A study of known truth: plan, table and records as a real one leaves them, made from formulas and seeded noise."""
import json
import os

import numpy
import pandas

FIXED = {'P0': 4671.0, 'lastTime': 4e-3, 'impulse': 2.0, 'bufferingRatio': 0.5, 'peakTime': 2e-3, 'number': 900, 'staticForce': 12.0,
         'weight': 11.6, 'pours': 1, 'surfaceSpeed': 5.558, 'atRest': True, 'over': True, 'solves': 1000, 'iterations': 9000, 'fallbacks': 0,
         'uncertified': 0, 'dtImpact': 3.5e-6, 'bedSeconds': 1800.0, 'impactSeconds': 900.0, 'threads': 1, 'versionYade': '2025.2',
         'versionPlugin': '1.0', 'versionPython': '3.13.5', 'versionNumpy': '2.2.4', 'innerC0': float('nan'),
         'particles': float('nan'), 'thicknessTolerance': 0.03}

COLUMNS = [*FIXED, 'run', 'bed', 'seed', 'thickness', 'peak', 'duration', 'H', 'C0']


def group(name, truth, x, series, seeds, xName='thickness', figures=None, findings=(), scatter=0.05, seed=1,
          bedScatter=None):
    """A group of a plan, and the rows of its table.

    :param truth: function (series, x) -> mean peak [N]; :param scatter: relative standard deviation of the peak, or
        a function x -> it
    :param bedScatter: if given, all points of a seed are on the same bed, and beds have this standard deviation of their own
    """
    random = numpy.random.default_rng(seed)
    points, rows = [], []
    common = {number: numpy.exp(bedScatter * random.standard_normal()) if bedScatter is not None else 1 for number in seeds}
    for label in series:
        for value in x:
            for number in seeds:
                run = f'{name}-{label}-{value}-s{number}'.replace(' ', '')
                points.append({'series': label, 'x': value, 'seed': number, 'run': run})
                deviation = scatter(value) if callable(scatter) else scatter
                peak = truth(label, value) * common[number] * numpy.exp(deviation * random.standard_normal())
                bed = run + 'b' if bedScatter is None else f'{name}-s{number}'
                rows.append({**FIXED, 'run': run, 'bed': bed, 'seed': number, 'peak': peak, 'duration': 2e-3 * (4671 / peak) ** 0.3,
                             **dict.fromkeys(('thickness', 'H'), value if xName == 'thickness' else 0.025),
                             'C0': 0.65 + 0.005 * random.standard_normal()})
    plan = {'name': name, 'title': name.capitalize(), 'xName': xName, 'xLabel': None, 'series': list(series), 'figures': figures or {},
            'findings': list(findings), 'points': points}
    return plan, rows


def study(*groups, title='Synthetic'):
    """(plan, table) of groups as `group` makes them."""
    rows = [row for _, rows in groups for row in rows]
    runs = {row['run']: {'bed': row['bed'], 'parameters': {}} for row in rows}
    plan = {'title': title, 'experiment': 'impact', 'runs': runs,
            'beds': {row['bed']: {'parameters': {}} for row in rows}, 'groups': [plan for plan, _ in groups]}
    return plan, pandas.DataFrame(rows, columns=COLUMNS)


def writeRecords(table, folder, step=2e-5):
    """A force.csv for each run: free fall of 0.3 ms, then a pulse of the run's peak and duration on the static force."""
    for row in table.itertuples():
        time = numpy.arange(0, 9e-3, step)
        phase = (time - 3e-4 - 0.15 * row.duration) / row.duration
        force = row.peak * numpy.where((phase > 0) & (phase < 1), numpy.sin(numpy.pi * numpy.clip(phase, 0, 1)) ** 1.5, 0) + row.staticForce
        touch = numpy.where(time >= 3e-4 - 1e-12, row.peak, 0) * (time < 5e-3)
        os.makedirs(os.path.join(folder, row.run))
        numpy.savetxt(os.path.join(folder, row.run, 'force.csv'),
                      numpy.stack([time, force, 0 * time, touch, 0.1 - 5 * time, -5 + 0 * time], axis=1), delimiter=',', comments='',
                      header='time,baseForce,wallForce,impactorForce,impactorHeight,impactorVelocity')


def write(plan, table, folder):
    """plan.json, results.csv and impacts/ in `folder`."""
    with open(os.path.join(folder, 'plan.json'), 'w', encoding='utf-8') as file:
        json.dump(plan, file)
    table.to_csv(os.path.join(folder, 'results.csv'), index=False)
    writeRecords(table, os.path.join(folder, 'impacts'))
