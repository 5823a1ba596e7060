"""Print what the build must know about the installed YADE, one `@key=value` a line.

Run by YADE itself (`yade -n -x cmake/describe_yade.py`), so that the answers are those of the binary
that will load the plugin.
"""

import os
import sys

from yade import config

# The libraries themselves, also when the running YADE is an overlay of links to them.
libDir = os.path.dirname(os.path.realpath(os.path.join(config.libDir, 'libyade.so')))
answers = {
    'version': config.version,
    'features': ';'.join(config.features),
    'decimalPlaces': config.highPrecisionDecimalPlaces,
    'libDir': libDir,
    'libPath': os.path.relpath(config.libDir, config.prefix),
    'suffix': config.suffix,
    'python': sys.executable,
}
for key, value in answers.items():
    print(f'@{key}={value}')
