"""Every attribute of every class of the plugin, set to anything: it takes the value, or refuses it and stays as it was."""
import pytest
from fuzzing import anything, assignable, fuzz, refused, same
from hypothesis import assume
from hypothesis import strategies as st
from yade import wrapper

CLASSES = ('Superquadric', 'HollowCylinder', 'CurvatureMat', 'ElastoplasticMat', 'BreakableMat', 'BreakableState', 'BreakageEngine',
           'VibratingBoxEngine', 'VibrationRecorder', 'Law2_ScGeom_CurvaturePhys_HertzMindlin', 'Law2_ScGeom_ElastoplasticPhys_LoadingUnloading',
           'SuperquadricGeom', 'CurvaturePhys', 'ElastoplasticPhys', 'Bo1_Superquadric_Aabb', 'Bo1_HollowCylinder_Aabb',
           'Ig2_Superquadric_Superquadric_SuperquadricGeom', 'Ip2_CurvatureMat_CurvatureMat_CurvaturePhys',
           'Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys', 'SuperquadricInteractionLoop')
# YADE's own answers: to the name of no attribute, or of one that is read only; Boost.Python's to a whole number that is too large; and what comes
# of YADE's conversion to a MatchMaker, which leaves Python's error unhandled.
YADES = (AttributeError, OverflowError, SystemError)


def ownAttributes(name):
    """Of the class, and inherited ones that it checks."""
    return sorted(getattr(wrapper, name)().dict())


NO_TEXT = b'\xff\x80'  # bytes that are no UTF-8


def unreadableLabel(key, value):
    """Whether it is what YADE takes as a `label` (of any of its classes) and then cannot hand to Python any more."""
    try:
        return key == 'label' and isinstance(value, bytes) and value.decode() is None
    except UnicodeDecodeError:
        return True


attribute = st.sampled_from([(name, key) for name in CLASSES for key in ownAttributes(name)])


@fuzz(weight=10, which=attribute, value=assignable)
def test_attributesTakeOrRefuse(which, value):
    name, key = which
    assume(not unreadableLabel(key, value))
    thing = getattr(wrapper, name)()
    before = thing.dict()
    _, no = refused(lambda: setattr(thing, key, value), key, also=YADES)
    after = thing.dict()
    assert {k: v for k, v in after.items() if k != key and not same(v, before[k])} == {}
    if no:
        assert same(after[key], before[key])


@fuzz(weight=4, which=st.sampled_from(CLASSES), data=st.data())
def test_constructorsAndUpdatesTakeOrRefuse(which, data):
    keys = ownAttributes(which)
    values = data.draw(st.dictionaries(st.sampled_from([*keys, 'noSuchAttribute']), assignable, min_size=1, max_size=4))
    assume(not any(unreadableLabel(*item) for item in values.items()))
    _, no = refused(lambda: getattr(wrapper, which)(**values), *values, also=YADES)
    thing = getattr(wrapper, which)()
    _, alsoNo = refused(lambda: thing.updateAttrs(values), *values, also=YADES)
    if not no and not alsoNo:
        assert thing.dict().keys() == getattr(wrapper, which)().dict().keys()


@pytest.mark.parametrize('name', CLASSES)
def test_bytesThatAreNoText(name):
    """Every attribute but YADE's own `label` refuses them, or takes them as a list of numbers: it can be read afterwards."""
    for key in set(ownAttributes(name)) - {'label'}:
        thing = getattr(wrapper, name)()
        before = thing.dict()
        _, no = refused(lambda: setattr(thing, key, NO_TEXT), key, also=YADES)
        after = thing.dict()
        assert same(after, before) or not no and same(list(after[key]), list(NO_TEXT)), key


METHODS = {'CurvatureMat': (('criticalTimeStep', 1),), 'ElastoplasticMat': (('criticalTimeStep', 1),), 'BreakableMat': (('strength', 2),)}


@fuzz(weight=2, which=st.sampled_from([(name, *method) for name, methods in METHODS.items() for method in methods]), data=st.data())
def test_methodsOfMaterials(which, data):
    name, method, count = which
    arguments = [data.draw(anything) for _ in range(count)]
    answer, no = refused(lambda: getattr(getattr(wrapper, name)(), method)(*arguments), 'minHalfSize', 'size', 'survival', also=OverflowError)
    assert no or answer >= 0
