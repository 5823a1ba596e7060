"""What a run leaves: time series as CSV, a summary as JSON."""
import csv
import json
import os
import platform

import numpy

from yade import config

from .version import __version__


def versions():
    """Versions of what took part in the computation."""
    return {'yade': config.version, 'yade-superquadric': __version__, 'python': platform.python_version(),
            'numpy': numpy.__version__}


def writeCsv(path, columns, rows):
    """Write `rows` under the names `columns`; numbers keep all their digits."""
    with Replacing(path) as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in rows)


def readCsv(path):
    """Columns and rows of floats, as `writeCsv` wrote them."""
    with open(path, newline='', encoding='utf-8') as file:
        reader = csv.reader(file)
        columns = tuple(next(reader))
        return columns, [tuple(map(float, row)) for row in reader]


def writeJson(path, content):
    with Replacing(path) as file:
        json.dump(content, file, indent=2)
        file.write('\n')


def readJson(path):
    with open(path, encoding='utf-8') as file:
        return json.load(file)


def flush(path):
    """See to it that the file is on the disk, also after a power cut, before another one says that it is there."""
    with open(path, 'rb') as file:
        os.fsync(file.fileno())


class Replacing:
    """A text file that takes the place of `path` only when it has been written completely."""

    def __init__(self, path):
        self.path, self.partial = path, f'{path}.part'

    def __enter__(self):
        self.file = open(self.partial, 'w', newline='', encoding='utf-8')
        return self.file

    def __exit__(self, failed, *_):
        if not failed:
            self.file.flush()
            os.fsync(self.file.fileno())
        self.file.close()
        if failed:
            os.remove(self.partial)
        else:
            os.replace(self.partial, self.path)
