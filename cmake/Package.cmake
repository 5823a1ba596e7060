# The Debian package (`make deb`), for exactly the installed YADE: the plugin shares class layouts with its binary, so any other
# build of YADE, an update included, needs a package of its own.
find_program(DPKG_QUERY dpkg-query)
execute_process(COMMAND ${DPKG_QUERY} -S ${YADE_libDir}/libyade.so OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE notOwned)
if(NOT DPKG_QUERY OR notOwned)
  return() # a YADE that belongs to no package: there is nothing to depend on
endif()
string(REGEX REPLACE ":.*" "" owner "${owner}")
foreach(host yade ${owner})
  execute_process(COMMAND ${DPKG_QUERY} -W -f \${Version} ${host} OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND hosts "${host} (= ${version})")
endforeach()

# others(<result> <list>...): the packages in lists of tools/packages, but what every user has anyway.
function(others result)
  foreach(list ${ARGN})
    file(STRINGS ${PROJECT_SOURCE_DIR}/tools/packages/${list} names REGEX "^[a-z]")
    list(APPEND all ${names})
  endforeach()
  list(REMOVE_DUPLICATES all)
  list(REMOVE_ITEM all ${requiredPython})
  list(JOIN all ", " all)
  set(${result} "${all}" PARENT_SCOPE)
endfunction()

set(packageFiles ${PROJECT_SOURCE_DIR}/cmake/package)
set(packageDir ${YADE_libDir}/py/yade/superquadric)
foreach(script postinst prerm)
  configure_file(${packageFiles}/${script}.in ${PROJECT_BINARY_DIR}/package/${script} @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()

set(CPACK_PACKAGE_CONTACT "The yade-superquadric authors <noreply@example.org>")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
string(TIMESTAMP packageDate "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${packageFiles}/changelog.Debian.in ${PROJECT_BINARY_DIR}/package/changelog.Debian @ONLY)
install(FILES ${packageFiles}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
# install_compressed(<file> <name>): into the folder for documentation, in the way that Debian asks for.
function(install_compressed file name)
  install(CODE "execute_process(COMMAND gzip -9nc ${file}
    OUTPUT_FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}/${name}.gz\" COMMAND_ERROR_IS_FATAL ANY)")
endfunction()
install_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog)
install_compressed(${PROJECT_BINARY_DIR}/package/changelog.Debian changelog.Debian)

set(CPACK_GENERATOR DEB)
set(CPACK_SET_DESTDIR ON) # YADE's places are absolute
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "superquadric particles for the discrete element code YADE")
file(READ ${packageFiles}/description CPACK_DEBIAN_PACKAGE_DESCRIPTION)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${YADE_libDir})
set(requiredPython python3-matplotlib python3-numpy python3-yaml)
list(JOIN hosts ", " hosts)
list(JOIN requiredPython ", " pythonDepends)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "${hosts}, python3:any, ${pythonDepends}")
others(CPACK_DEBIAN_PACKAGE_RECOMMENDS view) # pictures of particles
others(CPACK_DEBIAN_PACKAGE_SUGGESTS study fem)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/postinst ${PROJECT_BINARY_DIR}/package/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
