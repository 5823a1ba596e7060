// Hot functions are compiled once for any x86-64 and once for processors with AVX2 and fused multiply-add; which one runs is decided
// when the program is loaded. What they call is compiled into them, so that it profits, too.
#pragma once

// Not with the sanitizers: all that is compiled in would get their checks as well, and the choice is made before they are ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SUPERQUADRIC_FOR_EACH_PROCESSOR __attribute__((flatten, target_clones("default", "arch=x86-64-v3")))
#else
#define SUPERQUADRIC_FOR_EACH_PROCESSOR
#endif
