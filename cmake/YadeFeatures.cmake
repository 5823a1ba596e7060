# The preprocessor macros that follow from YADE's features.
#
# YADE's class layouts depend on these macros, so they must be the ones that the installed binary was
# compiled with. The table repeats what YADE's own CMakeLists.txt does for each feature that it lists in
# `yade.config.features`. A feature which is not in the table stops the build: guessing would give
# a plugin that loads and then corrupts memory.

# No macro, or none that a header outside the feature's own files looks at.
foreach(feature USEFUL_ERRORS MPC ASAN FAST_NATIVE)
  set(yadeMacros_${feature} "")
endforeach()

set(yadeMacros_LOGGER YADE_BOOST_LOG BOOST_LOG_DYN_LINK)
set(yadeMacros_COMPLEX_MP YADE_COMPLEX_MP)
set(yadeMacros_MPFR YADE_MPFR)
set(yadeMacros_VTK YADE_VTK)
set(yadeMacros_OPENMP YADE_OPENMP)
set(yadeMacros_GTS YADE_GTS)
set(yadeMacros_QT5 YADE_OPENGL YADE_QT5 QT_NO_KEYWORDS)
set(yadeMacros_CGAL YADE_CGAL CGAL_DISABLE_ROUNDING_MATH_CHECK)
set(yadeMacros_PFVFLOW FLOW_ENGINE)
set(yadeMacros_LINSOLV LINSOLV)
set(yadeMacros_TWOPHASEFLOW TWOPHASEFLOW)
set(yadeMacros_THERMAL THERMAL)
set(yadeMacros_PARTIALSAT PARTIALSAT)
set(yadeMacros_MPI YADE_MPI)
set(yadeMacros_SPH YADE_SPH)
set(yadeMacros_LS_DEM YADE_LS_DEM)
set(yadeMacros_DEFORM YADE_DEFORM)
set(yadeMacros_FEMLIKE YADE_FEM)
set(yadeMacros_LIQMIGRATION YADE_LIQMIGRATION)
set(yadeMacros_GL2PS YADE_GL2PS)
set(yadeMacros_LBMFLOW LBM_ENGINE)
set(yadeMacros_PROFILING USE_TIMING_DELTAS ISC_TIMING)
set(yadeMacros_POTENTIAL_PARTICLES YADE_POTENTIAL_PARTICLES)
set(yadeMacros_POTENTIAL_BLOCKS YADE_POTENTIAL_BLOCKS)

# yade_macros(<result> <feature>...): the macros for these features, with those that every build in
# double precision has. VECTORIZE and MASK_ARBITRARY are left out of the table on purpose: the first
# contradicts the Eigen macros of this project, the second has a size that no feature tells.
function(yade_macros result)
  set(macros YADE_REAL_BIT=64 YADE_REAL_DEC=15 YADE_ODEINT MAX_LOG_LEVEL=5)
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
    list(APPEND macros YADE_FLOAT128_UNAVAILABLE)
  endif()
  foreach(feature ${ARGN})
    if(NOT DEFINED yadeMacros_${feature})
      message(FATAL_ERROR "The installed YADE has the feature \"${feature}\", which cmake/YadeFeatures.cmake does "
        "not know. Look up in YADE's CMakeLists.txt which macro it defines and add it to the table.")
    endif()
    list(APPEND macros ${yadeMacros_${feature}})
  endforeach()
  set(${result} ${macros} PARENT_SCOPE)
endfunction()
