# Compile and link everything with the sanitizers in SANITIZE, with little optimisation and with Eigen's assertions (no NDEBUG).
# YADE itself is not compiled with them: what looks at the type of an object through its table (vptr) would take the tables of YADE's own
# classes, which lie in its libraries, for foreign ones.
set(mathematicsOptimisation -O3)
set(pluginOptimisation $<$<CONFIG:Release>:-O2>)
set(testTimeLimit 300) # [s] for one C++ test
if(SANITIZE)
  set(testTimeLimit 7200)
  set(CMAKE_CXX_FLAGS_RELEASE "-O1")
  set(mathematicsOptimisation "")
  set(pluginOptimisation "")
  add_compile_options(-fsanitize=${SANITIZE} -fno-sanitize=vptr -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${SANITIZE})
endif()
