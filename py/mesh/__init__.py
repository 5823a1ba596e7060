"""Surfaces of triangles: tessellations, STL files, regions, packing fractions."""
