"""Fenced code blocks of a Markdown page, run in the console's way, and commands held against the scripts' own parsers."""
import ast
import contextlib
import io
import math
import re
from collections import namedtuple

Block = namedtuple('Block', 'line kind text skipped')
Block.__doc__ = """A fenced block: the line in the page on which it begins, the words behind the fence, its text, and why it is not run, or None.

The reason stands in a comment just above the fence: `<!-- not run: REASON -->`."""

FENCE = re.compile(r'^(?:<!-- not run:(?P<reason>.*)-->\n)?```(?P<kind>[^\n`{]*)\n(?P<text>.*?)^```$', re.M | re.S)
NUMBER = re.compile(r'-?\d+\.?\d*(?:e[-+]?\d+)?')
EXACT, ABOUT = 1e-3, 0.5  # relative difference of a printed number from the page's; beds are chaotic: another processor gives another bed


def blocks(page):
    """All Blocks of the page (a Path)."""
    text = page.read_text()
    found = []
    for match in FENCE.finditer(text):
        reason = match['reason']
        assert reason is None or reason.strip(), f'{page.name}: a block is left out without a reason'
        found.append(Block(text[:match.start('text')].count('\n'), match['kind'].strip(), match['text'], reason))
    return found


def run(source, scope, name):
    """Run the `source` in `scope` as the console does, values of expressions shown. Returns what it printed."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        for statement in ast.parse(source).body:
            exec(compile(ast.Interactive([statement]), name, 'single'), scope)
    return output.getvalue()


def same(printed, expected, tolerance):
    """Whether two texts have the same words and, within a relative `tolerance`, the same numbers."""
    if NUMBER.split(' '.join(printed.split())) != NUMBER.split(' '.join(expected.split())):
        return False
    return all(math.isclose(float(a), float(b), rel_tol=tolerance, abs_tol=1e-12)
               for a, b in zip(NUMBER.findall(printed), NUMBER.findall(expected)))


def tolerance(kind):
    """Of the numbers in a block of what was printed."""
    return ABOUT if kind == 'text about' else EXACT
