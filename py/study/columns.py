"""The columns of a study's table (results.csv), known without reading any result."""
from ..parameters import PARAMETERS

IDS = ('run', 'bed', 'seed')
GIVEN = tuple(p.name for p in PARAMETERS if p.name != 'seed')  # parameters, as asked for: `thickness` is the given one
# Column: where its value is found in summary.json.
MEASURED = {
    'number': ('particle', 'number'),
    'H': ('bed', 'thickness'),
    'C0': ('bed', 'packingFraction'),
    'innerC0': ('bed', 'innerPackingFraction'),
    'staticForce': ('bed', 'staticForce'),
    'weight': ('bed', 'weight'),
    'peak': ('impact', 'peak'),
    'peakTime': ('impact', 'peakTime'),
    'duration': ('impact', 'duration'),
    'lastTime': ('impact', 'lastTime'),
    'impulse': ('impact', 'impulse'),
    'P0': ('P0',),
    'bufferingRatio': ('bufferingRatio',),
    'surfaceSpeed': ('impactor', 'surfaceSpeed'),
    'over': ('impact', 'over'),
    'solves': ('solver', 'solves'),
    'iterations': ('solver', 'iterations'),
    'fallbacks': ('solver', 'fallbacks'),
    'uncertified': ('solver', 'uncertified'),
    'dtImpact': ('timeStep', 'impact'),
    'bedSeconds': ('bed', 'wallSeconds'),
    'impactSeconds': ('wallSeconds',),
    'threads': ('threads',),
    'versionYade': ('versions', 'yade'),
    'versionPlugin': ('versions', 'yade-superquadric'),
    'versionPython': ('versions', 'python'),
    'versionNumpy': ('versions', 'numpy'),
}
COUNTED = ('pours', 'atRest')  # a number of attempts, and soft and true together
COLUMNS = (*IDS, *GIVEN, *MEASURED, *COUNTED)
MAY_BE_MISSING = ('innerC0',)  # null in a thin bed
