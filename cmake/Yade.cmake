# The installed YADE as the host of the plugin: what it is, its headers, and the target `yade_host` that
# carries its include paths, macros and libraries.
include(YadeFeatures)

if(NOT "$ENV{YADE_EXECUTABLE}" STREQUAL "")
  set(YADE_EXECUTABLE "$ENV{YADE_EXECUTABLE}" CACHE FILEPATH "The YADE that will load the plugin")
endif()
find_program(YADE_EXECUTABLE NAMES yade-double yade REQUIRED)

# Without YADE_PREFIX, so that a shell inside `tools/env` describes the installed YADE, not the overlay.
execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=YADE_PREFIX --unset=DISPLAY
    ${YADE_EXECUTABLE} -n -x ${PROJECT_SOURCE_DIR}/cmake/describe_yade.py
  OUTPUT_VARIABLE yadeAnswer ERROR_VARIABLE yadeErrors RESULT_VARIABLE yadeFailed)
foreach(key version features decimalPlaces libDir libPath suffix python)
  if(yadeFailed OR NOT yadeAnswer MATCHES "@${key}=([^\n]*)")
    message(FATAL_ERROR "${YADE_EXECUTABLE} did not say its ${key}:\n${yadeAnswer}\n${yadeErrors}")
  endif()
  set(YADE_${key} "${CMAKE_MATCH_1}")
endforeach()
message(STATUS "YADE ${YADE_version} in ${YADE_libDir}")

# A build from YADE's git has the date of its commit and the commit for a version.
set(yadeRelease ${YADE_version})
if(YADE_version MATCHES "^([0-9]+)-([0-9]+)-[0-9]+[.]git-([0-9a-f]+)$")
  set(yadeRelease ${CMAKE_MATCH_1}.${CMAKE_MATCH_2})
  set(yadeCommit ${CMAKE_MATCH_3})
endif()
if(yadeRelease VERSION_LESS 2025.2)
  message(FATAL_ERROR "YADE ${YADE_version} is installed (${YADE_EXECUTABLE}); 2025.2 or newer is needed.")
endif()
if(NOT YADE_decimalPlaces EQUAL 15)
  message(FATAL_ERROR "${YADE_EXECUTABLE} computes with ${YADE_decimalPlaces} decimal places; the plugin is for "
    "double precision (15). Name another one with -DYADE_EXECUTABLE=...")
endif()

# Headers: no YADE package has any, they come from the source of exactly the same version.
set(YADE_SOURCE "$ENV{YADE_SOURCE}" CACHE PATH "YADE's source tree, of the installed version")
if(NOT EXISTS ${YADE_SOURCE}/core/Scene.hpp)
  message(FATAL_ERROR "YADE_SOURCE=\"${YADE_SOURCE}\" is not a YADE source tree (it has no core/Scene.hpp). "
    "Fetch one with `apt-get source --tar-only yade` and name it with -DYADE_SOURCE=...")
endif()
if(EXISTS ${YADE_SOURCE}/RELEASE)
  file(STRINGS ${YADE_SOURCE}/RELEASE YADE_sourceVersion LIMIT_COUNT 1)
elseif(DEFINED yadeCommit)
  execute_process(COMMAND git -C ${YADE_SOURCE} rev-parse HEAD OUTPUT_VARIABLE YADE_sourceVersion OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(YADE_sourceVersion MATCHES "^${yadeCommit}")
    set(YADE_sourceVersion ${YADE_version})
  endif()
else()
  message(FATAL_ERROR "${YADE_SOURCE} has no file RELEASE, so its version is unknown. Use the source of a release.")
endif()
if(NOT YADE_sourceVersion STREQUAL YADE_version)
  message(FATAL_ERROR "The installed YADE is ${YADE_version}, the source in ${YADE_SOURCE} is ${YADE_sourceVersion}. "
    "They must be the same version: the plugin shares class layouts with the binary.")
endif()

# pkg/support/YadeHeaders.hpp stands for the macros in this very file of YADE (2025.2.0 and 2026.1.0 have the same one).
file(SHA256 ${YADE_SOURCE}/lib/serialization/Serializable.hpp classMacros)
if(classMacros STREQUAL "cdd0ba24468287380ccf600cc98688dfa9104a13326677e69a6a918763ba335a")
  set(yadeHeadersFirst -include ${PROJECT_SOURCE_DIR}/pkg/support/YadeHeaders.hpp)
else()
  message(STATUS "The class macros of this YADE are not known: the plugin takes longer to compile.")
endif()

find_package(Python3 REQUIRED COMPONENTS Development.Module)
set(boostPython python${Python3_VERSION_MAJOR}${Python3_VERSION_MINOR})
find_package(Boost REQUIRED CONFIG COMPONENTS serialization iostreams log thread ${boostPython})
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(Threads REQUIRED)

# All of YADE's libraries (not an installed plugin), of which the linker keeps those that are used.
file(GLOB yadeLibraries ${YADE_libDir}/lib*.so)
list(REMOVE_ITEM yadeLibraries ${YADE_libDir}/libsuperquadric.so)

add_library(yade_host INTERFACE)
yade_macros(yadeMacros ${YADE_features})
target_compile_definitions(yade_host INTERFACE ${yadeMacros})
target_include_directories(yade_host SYSTEM INTERFACE ${YADE_SOURCE})
# The compiler may call a system header by its real path.
file(REAL_PATH ${YADE_SOURCE} realSource)
target_compile_options(yade_host INTERFACE -ftrack-macro-expansion=0 -ffile-prefix-map=${YADE_SOURCE}/=yade/ -ffile-prefix-map=${realSource}/=yade/)
target_link_options(yade_host INTERFACE -Wl,--as-needed)
target_link_libraries(yade_host INTERFACE ${yadeLibraries} Eigen3::Eigen Boost::serialization Boost::iostreams
  Boost::log Boost::thread Boost::${boostPython} Python3::Module OpenMP::OpenMP_CXX Threads::Threads)

if("MPI" IN_LIST YADE_features)
  find_package(MPI REQUIRED COMPONENTS CXX)
  target_link_libraries(yade_host INTERFACE MPI::MPI_CXX)
endif()

# The 3D view.
if("YADE_OPENGL" IN_LIST yadeMacros)
  find_package(OpenGL REQUIRED)
  target_link_libraries(yade_host INTERFACE OpenGL::GL)
endif()
