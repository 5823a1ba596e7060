"""What `yade.superquadric` hands on: each name from one place, old names with a warning."""
import importlib

import pytest

import yade.superquadric as sq


def test_oldNamesWarnAndAreTheNewOnes():
    with pytest.warns(DeprecationWarning, match='yade.superquadric.Frame is called SceneSnapshot'):
        assert sq.Frame is sq.SceneSnapshot
    from yade.superquadric.pictures import view
    with pytest.warns(DeprecationWarning, match='pictures.view.frame is called grabImage'):
        assert view.frame is view.grabImage


def test_oldNamesAreNotOffered():
    assert set(sq._RENAMED.values()) <= set(sq.__all__) and not set(sq._RENAMED) & {*sq.__all__, *dir(sq)}


def test_namesThatAreNone():
    with pytest.raises(AttributeError, match="has no attribute 'superball'"):
        _ = sq.superball


def test_plainNamesAreThere():
    """The rest needs YADE: tests/system uses it."""
    for module in ('scene.shapes', 'scene.container', 'scene.expectedbed', 'scene.restitution', 'measure.bed', 'measure.scenesnapshot'):
        for name in sq._HANDED_ON[module]:
            assert getattr(sq, name) is getattr(importlib.import_module(f'yade.superquadric.{module}'), name)
