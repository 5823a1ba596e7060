// YADE's headers, read before everything else in each file of the plugin (CMakeLists.txt): a quarter of the time to compile one, the same program.
//
// A class of YADE defines, by its macros, in each file that sees it how Python reads, sets and lists its attributes, with all that Boost.Python
// instantiates for that. YADE's libraries have these functions already. So the macros are replaced, while YADE's headers are read, by ones that only
// declare them; our own classes, which come after, are defined in full. The functions and their order are the same, and so is the layout of the
// classes; for a YADE whose macros are not those below in full, CMake leaves this file out.
#pragma once

#include <lib/serialization/Serializable.hpp>

#pragma push_macro("_REGISTER_ATTRIBUTES_DEPREC")
#pragma push_macro("_YADE_CLASS_BASE_DOC_ATTRS_DEPREC_PY")
#pragma push_macro("_STATCLASS_PY_REGISTER_CLASS")
#undef _REGISTER_ATTRIBUTES_DEPREC
#undef _YADE_CLASS_BASE_DOC_ATTRS_DEPREC_PY
#undef _STATCLASS_PY_REGISTER_CLASS

// clang-format off
#define _REGISTER_ATTRIBUTES_DEPREC(thisClass, baseClass, attrs, deprec)                                                                               \
	_REGISTER_BOOST_ATTRIBUTES(baseClass, attrs)                                                                                                   \
public:                                                                                                                                                \
	void pySetAttr(const std::string& key, const ::boost::python::object& value) override;                                                         \
	::boost::python::dict pyDict() const override;                                                                                                 \
	void callPostLoad() override;
#define _YADE_CLASS_BASE_DOC_ATTRS_DEPREC_PY(thisClass, baseClass, docString, attrs, deprec, extras)                                                   \
	_REGISTER_ATTRIBUTES_DEPREC(thisClass, baseClass, attrs, deprec)                                                                               \
	REGISTER_CLASS_AND_BASE(thisClass, baseClass)                                                                                                  \
	BOOST_PP_SEQ_FOR_EACH(_ACCESS_DEPREC, thisClass, deprec)                                                                                       \
	void pyRegisterClass(::boost::python::object scope) override;
#define _STATCLASS_PY_REGISTER_CLASS(thisClass, baseClass, docString, attrs) void pyRegisterClass(::boost::python::object scope) override;
// clang-format on

// All that the adapters include of YADE. What is missing here costs time, no more.
#include <core/Body.hpp>
#include <core/Dispatching.hpp>
#include <core/EnergyTracker.hpp>
#include <core/InteractionLoop.hpp>
#include <core/Omega.hpp>
#include <core/PartialEngine.hpp>
#include <core/Scene.hpp>
#include <pkg/common/Collider.hpp>
#include <pkg/common/ElastMat.hpp>
#include <pkg/common/Facet.hpp>
#include <pkg/common/MatchMaker.hpp>
#include <pkg/common/NormShearPhys.hpp>
#include <pkg/common/PeriodicEngines.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/common/Wall.hpp>
#include <pkg/dem/FrictPhys.hpp>
#include <pkg/dem/Ig2_Sphere_Sphere_ScGeom.hpp>
#include <pkg/dem/NewtonIntegrator.hpp>
#include <pkg/dem/ScGeom.hpp>
#ifdef YADE_OPENGL
#include <pkg/common/GLDrawFunctors.hpp>
#endif

#pragma pop_macro("_REGISTER_ATTRIBUTES_DEPREC")
#pragma pop_macro("_YADE_CLASS_BASE_DOC_ATTRS_DEPREC_PY")
#pragma pop_macro("_STATCLASS_PY_REGISTER_CLASS")
