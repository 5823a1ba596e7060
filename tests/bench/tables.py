"""The tables of the benchmark, in Markdown, from the samples of bench.json. What the columns mean: docs/benchmarks.md."""
import re

import numpy as np

KERNEL_GROUPS = (('shape', 'Contact solver by shape [ns a call]', 'shape, n1-n2'),
                 ('exponent', 'Contact solver by exponent, n1 = n2, equal half sizes [ns a call]', 'exponent'),
                 ('aspect', 'Contact solver by aspect ratio c/a, n = 8 [ns a call]', 'c/a'))
SOLVER_ALONE = {'bed/touching': 'its pairs that touch', 'bed/apart': 'its pairs apart, if all were asked'}
NEGLIGIBLE = 1e-3  # of a step: parts of engines below are left out


def report(result):
    """All tables as one text."""
    parts = [machineLine(result), bedTable(result), ratioTable(result), threadTable(result), phaseTable(result)]
    parts += [kernelTable(result['kernel'], *group) for group in KERNEL_GROUPS]
    parts += [solverTable(result)]
    return '\n\n'.join(part for part in parts if part) + '\n'


def replaceSection(path, text):
    """Put the text between the two marks of a Markdown file."""
    begin, end = '<!-- figures -->\n', '<!-- end of figures -->'
    pattern = re.compile(re.escape(begin) + '.*?' + re.escape(end), re.DOTALL)
    old = path.read_text()
    if not pattern.search(old):
        raise ValueError(f'{path.name}: has no section between {begin.strip()} and {end}')
    path.write_text(pattern.sub(lambda _: f'{begin}\n{text}\n{end}', old))


def table(title, header, rows):
    """A Markdown table, numbers to the right of the first column."""
    lines = [f'**{title}**', '', '| ' + ' | '.join(header) + ' |', '| --- |' + ' ---: |' * (len(header) - 1)]
    return '\n'.join(lines + ['| ' + ' | '.join(str(cell) for cell in row) + ' |' for row in rows])


def spread(samples, form='{:.2f}'):
    """Median and quartiles: `1.23 (1.20-1.30)`."""
    low, middle, high = np.percentile(samples, [25, 50, 75])
    return f'{form} ({form}-{form})'.format(middle, low, high)


def perStep(runs, clock='cpu'):
    """Seconds per step of all blocks of all runs of a scene, (N,)."""
    return np.concatenate([np.array(run[clock]) / run['steps'] for run in runs])


def contacts(runs):
    """Mean numbers of contacts and of candidate pairs."""
    return np.mean([run['contacts'] for run in runs]), np.mean([run['pairs'] for run in runs])


def machineLine(result):
    machine = result['machine']
    return (f"{machine['processor']}, {machine['cores']} cores, load {machine['loadAverage']:.1f} at the start; {machine['system']}, "
            f"YADE {machine['yade']}, g++ {machine['compiler']}; commit {machine['commit']}, {machine['date']}; {result['rounds']} rounds.")


def bedTable(result):
    rows = []
    for name, runs in result['scenes'].items():
        if 'threads' in name:
            continue
        time, (touching, pairs) = 1e6 * perStep(runs), contacts(runs)
        rows.append((name, f'{touching:.0f}', f'{pairs:.0f}', spread(time / runs[0]['count']), spread(time / touching, '{:.3f}'),
                     spread(time / pairs, '{:.3f}'), f"{max(max(run['kineticEnergy']) for run in runs):.0e}"))
    beds = table('Settled beds, one thread, CPU time [us]',
                 ('bed', 'contacts', 'pairs', 'a step and body', 'a contact', 'a pair', 'E_kin/mgd'), rows)
    levelSets = any(name.startswith('levelSet') for name in result['scenes'])
    return beds if levelSets else beds + '\n\nThis YADE has no level sets (feature LS_DEM).'


def ratioTable(result):
    """Each bed over YADE's spheres of the same number and over its level sets: per contact, round by round."""
    rows = []
    for name, runs in result['scenes'].items():
        kind, count = name.split(',')[0].split()
        for rival, title in (('yadeSphere', "YADE's Hertz-Mindlin spheres"), ('levelSet', "YADE's level-set cubes")):
            rivals = result['scenes'].get(f'{rival} {count}')
            if rivals and kind != rival and 'threads' not in name:
                rows.append((name, title, spread(perContact(runs) / perContact(rivals), '{:.3g}'),
                             spread(perBody(runs) / perBody(rivals), '{:.3g}')))
    return table('Ratios in the same round', ('bed', 'over', 'a contact', 'a step and body'), rows)


def perBody(runs):
    """Median CPU time per step and body of each round [s], (rounds,)."""
    return np.array([np.median(run['cpu']) / run['steps'] / run['count'] for run in runs])


def perContact(runs):
    """The same per contact."""
    return perBody(runs) * np.array([run['count'] / np.mean(run['contacts']) for run in runs])


def threadTable(result):
    rows = []
    for name, runs in result['scenes'].items():
        if 'threads' in name:
            single = result['scenes'][name.split(',')[0]]
            walls = [np.array([np.median(run['wall']) / run['steps'] for run in each]) for each in (single, runs)]
            rows.append((name, spread(1e3 * walls[0]), spread(1e3 * walls[1]), spread(walls[0] / walls[1])))
    return table('Threads, wall clock', ('bed', '1 thread [ms a step]', 'threads [ms a step]', 'speed-up'), rows)


def phaseTable(result):
    """Where a step of the 3,000 cubes goes; the solver's part of the interaction loop from the same bed's pairs, replayed alone."""
    phases = result['phases']
    total = np.median([sum(phase['seconds'] for phase in run.values()) for run in phases])
    rows = []

    def add(title, times):
        rows.append((title, spread(1e6 * np.array(times), '{:.0f}'), f'{100 * np.median(times) / total:.1f} %'))

    for name in phases[0]:
        add(name, [run[name]['seconds'] for run in phases])
        for part in phases[0][name]['parts']:
            times = [run[name]['parts'][part] for run in phases]
            if np.median(times) > NEGLIGIBLE * total:
                add(f'- {part}', times)
        if name.endswith('InteractionLoop'):
            for part, title in SOLVER_ALONE.items():
                samples = result['bedKernel'][part]
                add(solverAlone(title, samples), [1e-9 * sample['cpu_time'] * sample['pairs'] for sample in samples])
    return table('A step of 3,000 cubes, by engine', ('phase', 'us a step', 'of the step'), rows)


def solverAlone(title, samples):
    count, cost = (np.median([sample[key] for sample in samples]) for key in ('pairs', 'cpu_time'))
    return f'- solver alone: {title}, {count:.0f} at {cost:.0f} ns'


def kernelTable(kernel, group, title, first):
    names = {name.split('/')[1] for name in kernel if name.startswith(group + '/')}
    if not names:
        return ''
    names = sorted(names, key=None if group == 'shape' else float)
    rows = [(name, *(spread([sample['cpu_time'] for sample in kernel[f'{group}/{name}/{kind}']], '{:.0f}')
                     for kind in ('warm', 'rejected', 'cold')),
             *(f"{kernel[f'{group}/{name}/{kind}'][0]['iterations']:.2f}" for kind in ('warm', 'cold')),
             f"{kernel[f'{group}/{name}/cold'][0]['fallbacks']:.2%}") for name in names]
    return table(title, (first, 'warm', 'rejected', 'cold', 'iterations warm', 'cold', 'fallbacks cold'), rows)


def solverTable(result):
    """What the solver met, in the timed runs and while the 3,000 cubes were poured."""
    settling = result['settling']
    runs = {f'{name}, timed': (counted[0]['solver'], counted[0]['solverSteps']) for name, counted in result['scenes'].items()
            if counted[0]['solver'] and 'threads' not in name}
    by = f" by {settling['commit']}" if settling.get('commit') else ''
    rows = [solverRow(f"{settling['kind']} {settling['count']}, while it was poured{by}", settling['solver'], settling['steps'])]
    return table('The contact solver in the beds', ('bed', 'steps', 'solves a step', 'without a solve by spheres, direction, boxes',
                                                    'iterations a solve left', 'cold starts', 'fallbacks', 'uncertified'),
                 rows + [solverRow(name, *run) for name, run in runs.items()])


def solverRow(name, solver, steps):
    rejected = sum(count for key, count in solver.items() if key.startswith('rejected'))
    left = solver['solves'] - rejected
    return (name, steps, f"{solver['solves'] / steps:.0f}", f"{rejected / max(solver['solves'], 1):.1%}",
            f"{solver['iterations'] / max(left, 1):.2f}", solver['coldStarts'], solver['fallbacks'], solver['uncertified'])
