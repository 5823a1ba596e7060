"""What the documentation says to type works: Python blocks run, page by page, and give what stands below them; commands name scripts, options and
targets that exist; links lead somewhere."""
import functools
import re
import shlex
import subprocess

import docblocks
import pytest
from project import LIMIT, PROJECT
from yade import O

import __main__

PAGES = [PROJECT / 'README.md', PROJECT / 'CONTRIBUTING.md', *sorted((PROJECT / 'docs').glob('*.md'))]
CONSOLE = dict(vars(__main__))  # the names that YADE's console offers: pytest runs in one
# A line that begins with a command, and those that go on with it after a backslash.
COMMAND = re.compile(r'^(?: {4})?(?:sudo )?(?:tools/env|yade|yade-batch|make|tests/bench/run|tests/run) (?:.*\\\n)*.*', re.M)

LINK = re.compile(r'\]\((?!https?:)([^)#\s]*)(?:#([^)\s]*))?\)')


def named(page):
    return str(page.relative_to(PROJECT))


def kinds(page):
    return {block.kind for block in docblocks.blocks(page) if not block.skipped}


def commands(page):
    """Command lines of the page, in fences and in indented text: (line number, words)."""
    text = page.read_text()
    for found in COMMAND.finditer(text):
        yield text.count('\n', 0, found.start()) + 1, shlex.split(found[0].replace('\\\n', ' '), comments=True)


@functools.cache
def anchors(page):
    """What links may name behind the # of a Markdown page: its headings, in lower case, with hyphens for spaces, without punctuation."""
    headings = re.findall(r'^#+ +(.*)', page.read_text(), re.M)
    return {re.sub(r'[^\w -]', '', heading.lower()).replace(' ', '-') for heading in headings}


def deadLinks(page):
    """Links of the page to files or headings that are not there, images included."""
    for target, anchor in LINK.findall(page.read_text()):
        file = page.parent / target if target else page
        if not file.exists() or (anchor and file.suffix == '.md' and anchor not in anchors(file)):
            yield f'{target}#{anchor}' if anchor else target


@functools.cache
def helpOf(script):
    """What a script says to --help."""
    program = ['python3'] if script == 'scripts/study.py' else ['yade', '-n', '-x']
    if not script.startswith('scripts/'):
        program = []
    done = subprocess.run([*program, str(PROJECT / script), '--help'], capture_output=True, text=True, timeout=LIMIT)
    assert done.returncode == 0, f'{script} --help: {done.stderr}'
    return done.stdout


def wrong(words):
    """What is wrong with a command, a sentence each."""
    script = None
    for before, word in zip(['', *words], words):
        if before == 'make' and not re.search(rf'^{re.escape(word)}:', (PROJECT / 'Makefile').read_text(), re.M):
            yield f'make has no target {word}'
        if before == '--with' and not (PROJECT / 'tools' / 'packages' / word).is_file():
            yield f'there is no package list {word}'
        if re.match(r'(scripts|tests|tools|docs|cmake)/', word) and not (PROJECT / word).exists():
            yield f'there is no {word}'
        if script and word.startswith('--') and not re.search(rf'(?<![\w-]){re.escape(word.split("=")[0])}(?![\w-])', helpOf(script)):
            yield f'{script} has no option {word}'
        if re.fullmatch(r'(?:/usr/share/yade-superquadric/)?scripts/\w+\.py|tests/bench/run', word):
            script = word.removeprefix('/usr/share/yade-superquadric/')
        elif word in ('>', '|', '&&', ';'):
            script = None


@pytest.mark.parametrize('page', [page for page in PAGES if 'python' in kinds(page)], ids=named)
def test_python_blocks(page, tmp_path, monkeypatch):
    """The blocks of a page share a scene and their names, as when they are typed one after the other."""
    monkeypatch.chdir(tmp_path)
    O.reset()
    scope, printed = dict(CONSOLE), None
    for block in docblocks.blocks(page):
        if block.kind == 'python' and not block.skipped:
            printed = docblocks.run('\n' * block.line + block.text, scope, named(page))  # so that a traceback has the page's line numbers
        elif block.kind.startswith('text') and printed is not None:
            assert docblocks.same(printed, block.text, docblocks.tolerance(block.kind)), f'{named(page)}:{block.line}: printed\n{printed}'
            printed = None
    O.reset()


@pytest.mark.parametrize('page', [page for page in PAGES if any(commands(page))], ids=named)
def test_commands(page):
    problems = [f'{named(page)}:{number}: {problem}' for number, words in commands(page) for problem in wrong(words)]
    assert not problems, '\n'.join(problems)


@pytest.mark.parametrize('page', [*PAGES[:2], *sorted((PROJECT / 'docs').rglob('*.md'))], ids=named)
def test_links(page):
    assert not list(deadLinks(page))


def test_pages_and_commands_are_found():
    """The tests above look at something: the pages for newcomers have Python, the README has commands with options."""
    withPython = {named(page) for page in PAGES if 'python' in kinds(page)}
    assert {'README.md', 'docs/first-steps.md', 'docs/tutorial.md'} <= withPython
    assert any('--aspect' in words for _, words in commands(PROJECT / 'README.md'))


def test_untrue_pages_are_noticed(tmp_path):
    (tmp_path / 'page.md').write_text('# One, two\n[here](#one-two) [there](page.md#three) ![picture](none.png)')
    assert list(deadLinks(tmp_path / 'page.md')) == ['page.md#three', 'none.png']
    assert list(wrong(['make', 'coffee'])) == ['make has no target coffee']
    assert list(wrong(['yade', 'scripts/none.py'])) == ['there is no scripts/none.py']
    assert list(wrong(['yade', '-n', 'scripts/impact.py', '--aspects', '2'])) == ['scripts/impact.py has no option --aspects']
    assert not docblocks.same('peak 82 N', 'peak 30 N', docblocks.ABOUT)
    assert not docblocks.same('(0.005, False)', '(0.005, True)', docblocks.EXACT)
    assert docblocks.same('peak 82 N', 'peak 70 N', docblocks.ABOUT)
