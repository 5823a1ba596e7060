"""Sphinx's settings for the site (`make docs`): pages are docs/*.md, the reference comes from the docstrings. Nothing is fetched from the network."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from yade.superquadric import __version__ as release

project = 'yade-superquadric'
author = 'The yade-superquadric authors'
copyright = f'2026, {author}'
version = release

extensions = ['myst_parser', 'sphinx.ext.autodoc', 'yadeclasses', 'packagemodules', 'mathml']
default_role = 'code'  # `name` in docstrings is code, as in Markdown

html_theme = 'furo'
html_title = f'yade-superquadric {release}'
html_show_sphinx = False
html_copy_source = False

myst_heading_anchors = 4

autodoc_member_order = 'bysource'
autodoc_typehints = 'signature'
autodoc_typehints_format = 'fully-qualified'
# Where a module is described without being run, its annotations are short names, and classes of different folders may share one (State, Material).
suppress_warnings = ['ref.python']
autodoc_mock_imports = ['getfem', 'pandas', 'pyvista', 'scipy', 'vtkmodules']  # their modules are described without running them
html_math_renderer = 'mathml'

# Pages of the project's top folder, which Sphinx does not read: each is included by a page of the site.
TOP_PAGES = {'](../CONTRIBUTING.md': '](site/contributing.md', '](../CHANGELOG.md': '](site/changes.md'}


def linkTopPages(app, name, source):
    for theirs, here in TOP_PAGES.items():
        source[0] = source[0].replace(theirs, here)


def setup(app):
    app.connect('source-read', linkTopPages)
