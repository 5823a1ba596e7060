"""The directive `packagemodules`: a section for each module of a Python package and of the packages in it, written by autodoc."""
import importlib
import pkgutil
import re

from docutils import nodes
from docutils.parsers.rst import directives
from docutils.statemachine import StringList
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

ROOT = 'yade.superquadric'


def modulesOf(package, shallow):
    """Names of all modules in `package` (its dotted name) that are no packages, those of packages in it last; `shallow`: without these."""
    own = list(pkgutil.iter_modules(importlib.import_module(package).__path__))
    names = [f'{package}.{module.name}' for module in sorted(own) if not module.ispkg]
    inner = () if shallow else (f'{package}.{module.name}' for module in sorted(own) if module.ispkg)
    return names + [name for each in inner for name in modulesOf(each, shallow)]


class PackageModules(SphinxDirective):
    """`.. packagemodules:: PACKAGE`; with `:shallow:` without the packages in it."""

    required_arguments = 1
    option_spec = {'shallow': directives.flag}

    def run(self):
        package, shallow = self.arguments[0], 'shallow' in self.options
        if not shallow:
            self.env.metadata[self.env.docname]['packagemodules'] = package
        return [node for name in modulesOf(package, shallow) for node in self.section(name, name.removeprefix(f'{package}.'))]

    def section(self, name, title):
        lines = [title, '-' * len(title), '', f'.. automodule:: {name}', '   :members:', '']
        parent = nodes.section()
        parent.document = self.state.document
        self.state.memo.title_styles, styles = [], self.state.memo.title_styles
        level, self.state.memo.section_level = self.state.memo.section_level, 0
        self.state.nested_parse(StringList(lines, name), 0, parent, match_titles=True)
        self.state.memo.title_styles, self.state.memo.section_level = styles, level
        return parent.children


def fieldsOnLinesOfTheirOwn(app, what, name, object, options, lines):
    """Docstrings here may have several fields in a line: `:param a: ...; :param b: ...`."""
    lines[:] = [part for line in lines for part in re.split(r'(?<=\S)[;.,]? (?=:(?:param|ivar|returns|raises) ?[^:]*:)', line)]


def checkComplete(app, env):
    """Every folder of the package has its place in the reference."""
    shown = {data['packagemodules'] for data in env.metadata.values() if 'packagemodules' in data}
    for module in pkgutil.iter_modules(importlib.import_module(ROOT).__path__):
        if module.ispkg and f'{ROOT}.{module.name}' not in shown:
            logging.getLogger(__name__).warning('no page of docs/reference has ".. packagemodules:: %s.%s"', ROOT, module.name)


def setup(app):
    app.connect('autodoc-process-docstring', fieldsOnLinesOfTheirOwn)
    app.connect('env-check-consistency', checkComplete)
    app.add_directive('packagemodules', PackageModules)
    return {'parallel_read_safe': True, 'parallel_write_safe': True}
