"""The directive `packagemodules`: a section for each module of a Python package, written by autodoc."""
import importlib
import pkgutil
import re

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective


class PackageModules(SphinxDirective):
    """`.. packagemodules:: PACKAGE`. Packages in the package get pages of their own."""

    required_arguments = 1

    def run(self):
        package = importlib.import_module(self.arguments[0])
        names = [f'{package.__name__}.{module.name}' for module in pkgutil.iter_modules(package.__path__) if not module.ispkg]
        return [node for name in sorted(names) for node in self.section(name)]

    def section(self, name):
        title = name.rpartition('.')[2]
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


def setup(app):
    app.connect('autodoc-process-docstring', fieldsOnLinesOfTheirOwn)
    app.add_directive('packagemodules', PackageModules)
    return {'parallel_read_safe': True, 'parallel_write_safe': True}
