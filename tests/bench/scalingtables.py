"""Tables and figure of `scaling`, from the samples of scaling.json. What the columns mean: docs/scaling.md."""
import csv

import matplotlib

matplotlib.use('Agg')
import numpy as np
from matplotlib import pyplot
from tables import machineLine, spread, table

MIB = 2 ** 20
WINDOWS, FLOOR = 25, 1e-17  # of the figure of agreement
QUANTITIES = {'momentum': slice(2, 5), 'force': slice(5, 8), 'energy': slice(8, None)}  # columns of the totals in parallel_bed.py


def report(result):
    """All tables as one text."""
    parts = [part(result) for part in (machineLine, sizeTable, memoryTable, rankTable) if 'scenes' in result]
    parts += [agreementTable(result)] if 'agreement' in result else []
    return '\n\n'.join(parts) + '\n'


def scenes(result):
    """(count, threads, ranks), samples; in order."""
    return [(tuple(map(int, name.split())), samples) for name, samples in result['scenes'].items()]


def stepTimes(samples):
    """Seconds per step of all blocks."""
    return np.array([wall / sample['steps'] for sample in samples for wall in sample['wall']])


def ratios(samples, others):
    """Time of `others` over that of `samples`, each in the same round."""
    return [np.median(stepTimes([other])) / np.median(stepTimes([sample])) for sample, other in zip(samples, others)]


def sizeTable(result):
    known = dict(scenes(result))
    rows = []
    for (count, threads, ranks), samples in known.items():
        if ranks > 1:
            continue
        single = known[count, 1, 1]
        first = single[0]
        rows.append((count, threads, f"{first['contacts'] / count:.2f}", f"{first['pairs'] / count:.1f}", spread(1e3 * stepTimes(samples)),
                     spread(1e6 * stepTimes(samples) / count), spread(ratios(samples, single)), f"{first['kineticEnergy']:.0e}"))
    return table('Threads, wall clock', ('bodies', 'threads', 'contacts a body', 'pairs a body', 'a step [ms]', 'a step and body [us]',
                                         'speed-up', 'E_kin/mgd'), rows)


def memoryTable(result):
    rows = []
    for (count, threads, ranks), samples in scenes(result):
        if threads > 1 or ranks > 1:
            continue
        before, placed, after = np.median([sample['memory'] for sample in samples], axis=0)
        first = samples[0]
        body, contact, whole = (placed - before) / count, (after - placed) / first['contacts'], (after - before) / count
        rows.append((count, f'{before / MIB:.0f}', f'{after / MIB:.0f}', f'{body:.0f}', f'{contact:.0f}', f'{whole:.0f}'))
    return table('Memory, one thread', ('bodies', 'YADE without bodies [MiB]', 'in all [MiB]', 'a body [bytes]',
                                        'a contact, with its share of the pairs apart [bytes]', 'all, over the bodies [bytes]'), rows)


def rankTable(result):
    known = dict(scenes(result))
    count = max(count for count, _, ranks in known if ranks > 1)
    single, rows = known[count, 1, 1], []
    for (bodies, threads, ranks), samples in known.items():
        if bodies == count:
            rows.append((f"{ranks} process{'es' if ranks > 1 else ''}", max(ranks - 1, 1), threads, spread(1e3 * stepTimes(samples)),
                         spread(ratios(samples, single))))
    return table(f'Processes, {count} bodies, wall clock', ('', 'domains', 'threads each', 'a step [ms]', 'speed-up'), rows)


def differences(files):
    """Of the totals of several processes from those of one, over the largest value of the latter in the whole run; `files`: {(speed, ranks): CSV}.
    For each of them a dict with the speed, the number of processes, the times [s] and a list per quantity."""
    totals = {key: _read(path) for key, path in files.items()}
    found = []
    for (speed, ranks), values in totals.items():
        reference = totals[speed, 1]
        if ranks > 1:
            found.append({'speed': speed, 'ranks': ranks, 'times': list(reference[:, 0]),
                          **{name: list(np.abs(values - reference)[:, columns].max(axis=1) / np.abs(reference[:, columns]).max())
                             for name, columns in QUANTITIES.items()}})
    return found


def _read(path):
    with open(path, newline='') as file:
        return np.array([[float(value) for value in row] for row in list(csv.reader(file))[1:]])


def agreementTable(result):
    rows = []
    for each in result['agreement']['runs']:
        half = len(each['times']) // 2
        rows.append(('at rest' if each['speed'] == 0 else f"hit at {each['speed']} m/s", each['ranks'],
                     *(f'{max(each[name][part]):.0e}' for name in QUANTITIES for part in (slice(half), slice(half, None)))))
    return table(f"{result['agreement']['count']} cubes: difference from one process over the largest value of the run, by halves of the steps",
                 ('bed', 'processes', *(f'{name}, {half}' for name in QUANTITIES for half in ('first', 'second'))), rows)


def draw(result, path):
    figure, (times, memory, agreement) = pyplot.subplots(1, 3, figsize=(14, 4), layout='constrained')
    if 'scenes' in result:
        drawSizes(times, memory, scenes(result))
    styles = {0: 'o-', 3: 's--'}
    for each in result.get('agreement', {'runs': ()})['runs']:
        label = f"{'at rest' if each['speed'] == 0 else 'hit'}, {each['ranks']} processes"
        agreement.semilogy(*largestInTurn(1e3 * np.array(each['times']), each['force']), styles[each['speed']], label=label)
    agreement.set(xlabel='time [ms]', ylabel='difference of the base force / its largest value', ylim=(FLOOR / 2, 1e-12))
    agreement.legend(fontsize='small', loc='upper right')
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def largestInTurn(times, values):
    """The largest value of each of WINDOWS parts of the time, and where the parts begin; at least FLOOR, for an axis that is logarithmic."""
    parts = np.array_split(np.maximum(values, FLOOR), WINDOWS)
    return [part[0] for part in np.array_split(times, WINDOWS)], [part.max() for part in parts]


def drawSizes(times, memory, known):
    for threads, marker in ((1, 'o-'), (2, 's-')):
        points = [(count, 1e6 * np.median(stepTimes(samples)) / count) for (count, used, ranks), samples in known if (used, ranks) == (threads, 1)]
        times.semilogx(*zip(*points), marker, label=f"{threads} thread{'s' * (threads > 1)}")
    times.set(xlabel='bodies', ylabel='wall clock of a step and body [us]', ylim=(0, None))
    times.legend()
    points = [(count, np.median([sample['memory'][2] for sample in samples]) / MIB) for (count, *used), samples in known if used == [1, 1]]
    memory.semilogx(*zip(*points), 'o-')
    memory.set(xlabel='bodies', ylabel='memory of the process [MiB]', ylim=(0, None))
