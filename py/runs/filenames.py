"""Names of files in the folder of a run that more than one part of the package knows."""

SUMMARY = 'summary.json'    # of the results, written when all others are complete
BEFORE = 'before.npz'       # particles of a bed at rest
BED = 'bed.json'            # state of the run that made a finished bed
CHECKPOINT = 'checkpoint.json'  # of an interrupted run
