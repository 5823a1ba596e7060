# How YADE gets to see the plugin.
#
# YADE loads every lib*.so that it finds below its library directory, and that directory follows the
# environment variable YADE_PREFIX. So the build directory holds an overlay: a tree laid out like YADE's
# own, of links to YADE's files, plus the plugin and the Python package. Nothing of YADE is
# copied or changed. `overlay/bin/yade` starts YADE on it.
set(overlay ${PROJECT_BINARY_DIR}/overlay)
set(overlayLibDir ${overlay}/${YADE_libPath})
set(overlayPackage ${overlayLibDir}/py/yade)

# link_all(<from> <to> <except>...): link all entries of a directory into another one.
function(link_all from to)
  file(MAKE_DIRECTORY ${to})
  file(GLOB entries RELATIVE ${from} ${from}/*)
  list(REMOVE_ITEM entries __pycache__ ${ARGN})
  foreach(entry ${entries})
    file(CREATE_LINK ${from}/${entry} ${to}/${entry} SYMBOLIC)
  endforeach()
endfunction()

# Links to the libraries may be outdated (a YADE with other features): start afresh, but keep the plugin.
file(GLOB oldLinks ${overlayLibDir}/lib*.so)
list(REMOVE_ITEM oldLinks ${overlayLibDir}/libsuperquadric.so)
file(REMOVE_RECURSE ${oldLinks} ${overlayLibDir}/py ${overlay}/bin)
# Not the plugin of an earlier system-wide installation.
link_all(${YADE_libDir} ${overlayLibDir} py libsuperquadric.so)
link_all(${YADE_libDir}/py ${overlayLibDir}/py yade)
link_all(${YADE_libDir}/py/yade ${overlayPackage} superquadric)
file(CREATE_LINK ${overlayLibDir}/py ${overlay}/python SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/py ${overlayPackage}/superquadric SYMBOLIC)
set_target_properties(superquadric PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${overlayLibDir} INSTALL_RPATH $ORIGIN)

# Under YADE's own name, and as plain `yade` (which a YADE that was built from source may not have).
foreach(name yade yade${YADE_suffix})
  foreach(batch "" -batch)
    set(launched ${YADE_EXECUTABLE}${batch})
    configure_file(cmake/launcher.py.in ${overlay}/bin/${name}${batch} @ONLY
      FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endforeach()
endforeach()

# For a system-wide installation the plugin goes to YADE's own places, where every `yade` finds it.
install(TARGETS superquadric LIBRARY DESTINATION ${YADE_libDir})
install(DIRECTORY py/ DESTINATION ${YADE_libDir}/py/yade/superquadric FILES_MATCHING PATTERN *.py PATTERN *.yaml)
include(GNUInstallDirs)
install(DIRECTORY scripts DESTINATION ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME} USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.md PATTERN *.png
  PATTERN site EXCLUDE PATTERN reference EXCLUDE)
install(FILES README.md CONTRIBUTING.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
