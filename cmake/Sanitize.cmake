# Compile and link everything with the sanitizers in SANITIZE. YADE itself is not compiled with them: what looks at the type of an object
# through its table (vptr) would take the tables of YADE's own classes, which lie in its libraries, for foreign ones.
if(SANITIZE)
  add_compile_options(-fsanitize=${SANITIZE} -fno-sanitize=vptr -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${SANITIZE})
endif()
