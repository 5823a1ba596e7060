"""Parameters that have another name now. The old ones are still read, with a warning: from the command line, batch tables, JSON files and study
files. (Checkpoints and finished beds of version 0.1 lack other fields as well, and are refused.)"""

# {experiment: {old name: name now}}. All changed with version 0.2.0, in which one name means one thing in all experiments.
RENAMED = {
    'impact': {
        'softening': 'pouringSoftening',        # the damper's `softening` holds for the whole run
        'leverArms': 'effectiveMassAtContact',
    },
    'damper': {
        'settlingTime': 'maxSettlingTime',
        'particleMass': 'totalParticleMass',    # it is the mass of all of them
    },
    'oedometer': {
        'settlingTime': 'maxSettlingTime',
        'width': 'containerWidth',
        'damping': 'numericalDamping',          # YADE's, beside those of the contact law
    },
}
