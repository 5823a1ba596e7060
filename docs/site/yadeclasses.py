"""The directive `yadeclasses`: the classes of the plugin as the running YADE describes them, and the role `yref` of its docstrings."""
import re
from pathlib import Path

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from sphinx.util.nodes import nested_parse_with_titles
from yade import wrapper

PKG = Path(__file__).resolve().parents[2] / 'pkg'
YADES = 'https://yade-dem.org/doc/yade.wrapper.html#yade.wrapper.'
READ_ONLY = 2  # of YADE's flags of an attribute (lib/serialization/Serializable.hpp), and
HIDDEN = 8     # not for users
FIELD = re.compile(r':y(default|attrtype|attrflags):`([^`]*)`')
STATIC = re.compile(r'\.\. ystaticattr:: \w+\.(\w+)\(=(.*)\)')
SIGNATURE = re.compile(r'\s*\w+\( (?P<arguments>.*)\) -> (?P<result>\w+) :\s*(?P<text>.*)', re.S)
ARGUMENT = re.compile(r'\((\w+)\)(\w+)')
PYTHON = {'Real': 'float', 'std::string': 'str', 'Vector3r': 'Vector3', 'Quaternionr': 'Quaternion', 'Matrix3r': 'Matrix3', 'long': 'int',
          'Body::id_t': 'int', 'std::vector<Real>': 'list of float', 'std::vector<int>': 'list of int', 'std::vector<Body::id_t>': 'list of int',
          'std::vector<Vector3r>': 'list of Vector3', 'Vector3i': 'Vector3i'}


def registered(folder):
    """Names of the classes that the sources in pkg/`folder` register with YADE, shapes and materials before what works on them."""
    text = ''.join(path.read_text() for path in sorted((PKG / folder).glob('*.cpp')))
    names = [name for group in re.findall(r'YADE_PLUGIN\(((?:\(\w+\))+)\)', text) for name in re.findall(r'\w+', group)]
    return sorted(names, key=lambda name: (re.match(r'(Bo1|Ig2|Ip2|Law2|Gl1)_', name) is not None, name))


def pluginClasses():
    """The names of all classes of the plugin."""
    return {name for folder in PKG.iterdir() for name in registered(folder.name)}


def rest(text):
    """A docstring's text as reStructuredText: $...$ is mathematics, and YADE's notes on types are left out."""
    text = text.replace('|yupdate|', 'Updated in every step.').replace('|ydeprecated|', 'Deprecated.')
    text = re.sub(r'\$([^$]+)\$', r':math:`\1`', FIELD.sub('', text.replace('[defined below]', '')))
    text = STATIC.sub(r'.. py:attribute:: \1\n :value: \2', text)
    return re.sub(r'[ \t]+', ' ', text).strip()


def indented(text, depth):
    return ['   ' * depth + line if line.strip() else '' for line in text.splitlines()] + ['']


def attribute(name, doc):
    """Lines that describe a property of a class; none for one that is not for users."""
    fields = dict(FIELD.findall(doc))
    flags = int(fields.get('attrflags') or 0)
    if flags & HIDDEN:
        return []
    kind = fields.get('attrtype', '')
    lines = [f'   .. py:attribute:: {name}']
    if kind:
        lines.append(f'      :type: {PYTHON.get(kind, kind)}')
    if fields.get('default') and 'numeric_limits' not in fields['default']:
        lines.append('      :value: ' + re.sub(r'Vector3r::(\w+)\(\)', r'Vector3.\1', fields['default']))
    return [*lines, '', *indented(rest(doc) + (' Read only.' if flags & READ_ONLY else ''), 2)]


def method(name, doc):
    """Lines that describe a method."""
    found = SIGNATURE.fullmatch(doc)
    arguments = ARGUMENT.findall(found['arguments'])[1:]  # but self
    result = '' if found['result'] == 'None' else f' -> {found["result"]}'
    shown = ', '.join(f'{argument}: {kind}' for kind, argument in arguments)
    return [f'   .. py:method:: {name}({shown}){result}', '', *indented(rest(found['text']), 2)]


def described(name):
    """The class as lines of reStructuredText."""
    cls = getattr(wrapper, name)
    lines = [name, '^' * len(name), '', f'.. py:class:: {name}', '', f'   A :yref:`{cls.__bases__[0].__name__}`.', '']
    lines += indented(rest(cls.__doc__), 1)
    members = {key: value for key, value in sorted(vars(cls).items()) if not key.startswith('_') and value.__doc__}
    for key, value in members.items():
        if isinstance(value, property):
            lines += attribute(key, value.__doc__)
    for key, value in members.items():
        if SIGNATURE.fullmatch(value.__doc__):
            lines += method(key, value.__doc__)
    return lines


class YadeClasses(SphinxDirective):
    """`.. yadeclasses:: FOLDER`: all classes that pkg/FOLDER registers."""

    required_arguments = 1

    def run(self):
        folder = self.arguments[0]
        self.env.metadata[self.env.docname]['yadeclasses'] = folder
        parent = nodes.section()
        parent.document = self.state.document
        lines = [line for name in registered(folder) for line in described(name)]
        nested_parse_with_titles(self.state, StringList(lines, f'pkg/{folder}'), parent)
        return parent.children


def yref(role, rawtext, text, line, inliner, options=None, content=None):
    """`:yref:` to a class or a member: of this plugin, in these pages; of YADE, in its documentation."""
    found = re.fullmatch(r'(.*?)\s*<(.*)>', text)
    title, target = found.groups() if found else (text, text)
    if target.split('.')[0] in pluginClasses():
        kind = 'attr' if '.' in target else 'class'
        return inliner.interpreted(f'{title} <{target}>', f'{title} <{target}>', f'py:{kind}', line)
    return [nodes.reference(rawtext, '', nodes.literal(title, title), refuri=YADES + target)], []


def checkComplete(app, env):
    """Every class has its place in the reference."""
    shown = {data['yadeclasses'] for data in env.metadata.values() if 'yadeclasses' in data}
    for folder in sorted(path.name for path in PKG.iterdir()):
        if registered(folder) and folder not in shown:
            logging.getLogger(__name__).warning('no page of docs/reference has ".. yadeclasses:: %s"', folder)


def setup(app):
    app.add_directive('yadeclasses', YadeClasses)
    app.add_role('yref', yref)
    app.connect('env-check-consistency', checkComplete)
    return {'parallel_read_safe': True, 'parallel_write_safe': True}
