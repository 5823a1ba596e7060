#include "Gl1_Superquadric.hpp"

#include <pkg/geometry/Tessellation.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <GL/gl.h>

#include <map>
#include <tuple>

namespace yade {

YADE_PLUGIN((Gl1_Superquadric));

bool Gl1_Superquadric::wire;
bool Gl1_Superquadric::stripes;
Real Gl1_Superquadric::quality;

namespace {

	// What bodies have in common that are drawn alike but for their size: half sizes over the largest one and exponents, as floats, so that grains
	// of many sizes share them in spite of rounding. The error is 2^-detail of the largest half size.
	struct Look {
		std::array<float, 5> shape;
		int detail;
		bool wire;

		bool operator<(const Look& other) const { return std::tie(shape, detail, wire) < std::tie(other.shape, other.detail, other.wire); }
	};

	std::array<float, 5> proportions(const superquadric::Shape& solid)
	{
		// A flatter plate looks the same.
		const Vector3r ratios = (solid.halfSizes() / solid.halfSizes().maxCoeff()).cwiseMax(superquadric::tolerances::flattestDrawn);
		return { float(ratios.x()), float(ratios.y()), float(ratios.z()), float(solid.n1()), float(solid.n2()) };
	}

	// How many pixels a length at the body's centre takes on the screen.
	double pixelsOf(double length)
	{
		GLdouble model[16], projection[16];
		GLint viewport[4];
		glGetDoublev(GL_MODELVIEW_MATRIX, model);
		glGetDoublev(GL_PROJECTION_MATRIX, projection);
		glGetIntegerv(GL_VIEWPORT, viewport);
		double depth = 0; // the homogeneous coordinate by which the perspective divides
		for (int i = 0; i < 4; ++i)
			depth += projection[4 * i + 3] * model[12 + i];
		return depth > 0 ? length * std::abs(projection[5]) / depth * viewport[3] / 2 : 0;
	}

	// For an error of one of the pixels that the largest half size takes; four of them will do for a net of lines.
	int detailFor(double pixels, bool wire)
	{
		using namespace superquadric::tolerances;
		if (wire) pixels /= 4;
		return int(std::min<double>(finestDetail, std::max<double>(coarsestDetail, std::round(std::log2(std::max(1.0, pixels))))));
	}

	// What OpenGL reads to draw it: normal and position of each point, and which points are the corners of triangles or the ends of lines. It is kept
	// in our own memory: lists and buffers would belong to one window's context, and YADE makes a new one whenever its view is opened.
	struct Drawing {
		std::vector<float> points;
		std::vector<GLuint> indices;
		GLsizei stripes = 0; // so many of the indices, the first ones, are of every second octant
	};

	// The triangles, those first whose octant has a positive product of coordinates; none lies in two octants.
	void addTriangles(Drawing& drawing, const superquadric::Tessellation& mesh)
	{
		std::vector<GLuint> others;
		for (const auto& [i, j, k] : mesh.triangles) {
			const Vector3r middle = mesh.points[i] + mesh.points[j] + mesh.points[k];
			std::vector<GLuint>& octant = middle.prod() > 0 ? drawing.indices : others;
			octant.insert(octant.end(), { GLuint(i), GLuint(j), GLuint(k) });
		}
		drawing.stripes = GLsizei(drawing.indices.size());
		drawing.indices.insert(drawing.indices.end(), others.begin(), others.end());
	}

	// All edges but the diagonals of the flat quadrilaterals, which two triangles make.
	void addEdges(Drawing& drawing, const superquadric::Tessellation& mesh)
	{
		std::map<std::pair<int, int>, Vector3r> normals; // of the triangle that runs along the edge that way
		for (const auto& t : mesh.triangles) {
			const Vector3r normal = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).normalized();
			for (int i = 0; i < 3; ++i)
				normals[{ t[i], t[(i + 1) % 3] }] = normal;
		}
		for (const auto& [edge, normal] : normals) {
			const auto [from, to] = edge;
			const bool flat = normal.cross(normals.at({ to, from })).norm() < superquadric::tolerances::flatEdge;
			if (from < to && !flat) drawing.indices.insert(drawing.indices.end(), { GLuint(from), GLuint(to) });
		}
	}

	// Directions that light falls on: the triangles' normals, weighted by their areas. Those of the surface itself, which already turn where a flat
	// face ends, would shade the whole of it.
	std::vector<Vector3r> shadingNormals(const superquadric::Tessellation& mesh)
	{
		std::vector<Vector3r> result(mesh.points.size(), Vector3r::Zero());
		for (const auto& t : mesh.triangles) {
			const Vector3r area = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
			for (const int corner : t)
				result[corner] += area;
		}
		return result; // OpenGL makes unit vectors of them
	}

	Drawing drawingOf(const Look& look)
	{
		const auto [a, b, c, n1, n2] = look.shape;
		const superquadric::Tessellation mesh = superquadric::tessellate(superquadric::Shape(Vector3r(a, b, c), n1, n2), std::ldexp(1.0, -look.detail));
		const std::vector<Vector3r> normals = shadingNormals(mesh);
		Drawing result;
		for (std::size_t i = 0; i < mesh.points.size(); ++i)
			for (const Vector3r& v : { normals[i], mesh.points[i] })
				result.points.insert(result.points.end(), { float(v.x()), float(v.y()), float(v.z()) });
		look.wire ? addEdges(result, mesh) : addTriangles(result, mesh);
		return result;
	}

	// Made once for each look. Bodies that break have no end of shapes: when the drawings take too much memory the collection begins anew.
	const Drawing& keptDrawingOf(const Look& look)
	{
		constexpr std::size_t most = 1 << 28; // bytes
		static std::map<Look, Drawing> drawings;
		static std::size_t bytes = 0;
		const auto found = drawings.find(look);
		if (found != drawings.end()) return found->second;
		if (bytes >= most) {
			drawings.clear();
			bytes = 0;
		}
		const Drawing& made = drawings.emplace(look, drawingOf(look)).first->second;
		bytes += made.points.size() * sizeof(made.points[0]) + made.indices.size() * sizeof(made.indices[0]);
		return made;
	}

	// The light that a body sends out by itself, in the two shades of Gl1_Sphere's stripes.
	void setEmission(float shade)
	{
		const GLfloat emission[] = { shade, shade, shade, 1 };
		glMaterialfv(GL_FRONT, GL_EMISSION, emission);
	}

	void draw(const Drawing& drawing, bool wire, bool stripes)
	{
		const GLsizei all = GLsizei(drawing.indices.size()), first = stripes && !wire ? drawing.stripes : 0;
		glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
		glInterleavedArrays(GL_N3F_V3F, 0, drawing.points.data());
		if (first > 0) {
			setEmission(0.3f);
			glDrawElements(GL_TRIANGLES, first, GL_UNSIGNED_INT, drawing.indices.data());
			setEmission(0.15f);
		}
		glDrawElements(wire ? GL_LINES : GL_TRIANGLES, all - first, GL_UNSIGNED_INT, drawing.indices.data() + first);
		glPopClientAttrib();
	}

} // namespace

void Gl1_Superquadric::go(const shared_ptr<Shape>& shape, const shared_ptr<State>&, bool wireAll, const GLViewInfo&)
{
	const superquadric::Shape& solid = static_cast<const Superquadric&>(*shape).solid();
	const Real size = solid.halfSizes().maxCoeff();
	const bool lines = wire || wireAll;
	const Look look { proportions(solid), detailFor(pixelsOf(size) * std::max(superquadric::tolerances::coarsestQuality, quality), lines), lines };
	glEnable(GL_NORMALIZE);
	glColor3dv(shape->color.data());
	glScaled(size, size, size);
	draw(keptDrawingOf(look), lines, stripes);
}

} // namespace yade
