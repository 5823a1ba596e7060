// Reading of STL files, ASCII or binary.
#pragma once

#include "TriangleMesh.hpp"

#include <string>

namespace superquadric {

// The triangles of the file; corners with equal coordinates are one point, nothing else is repaired. Throws std::invalid_argument naming the file
// when it cannot be read, is no STL file, is cut short, or has no triangles.
TriangleMesh readStl(const std::string& path);

} // namespace superquadric
