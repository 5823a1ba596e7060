#include "FacetNeighbours.hpp"

#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace yade {

namespace {

	using superquadric::MeshFacet;
	using superquadric::tolerances::sameVertex;

	Real shortestEdge(const MeshFacet& facet)
	{
		const auto& v = facet.vertices;
		return std::min({ (v[1] - v[0]).norm(), (v[2] - v[1]).norm(), (v[0] - v[2]).norm() });
	}

	bool shareVertex(const MeshFacet& one, const MeshFacet& other)
	{
		const Real near = sameVertex * std::min(shortestEdge(one), shortestEdge(other));
		for (const Vector3r& v : one.vertices)
			for (const Vector3r& w : other.vertices)
				if ((v - w).norm() <= near) return true;
		return false;
	}

	std::vector<MeshFacet> facetsOf(const Scene& scene)
	{
		std::vector<MeshFacet> facets;
		for (const auto& body : *scene.bodies) {
			const auto* facet = body ? dynamic_cast<const Facet*>(body->shape.get()) : nullptr;
			if (facet) facets.push_back(meshFacet(*facet, *body->state, body->id));
		}
		return facets;
	}

	// Vertices in cells so small that a cell and those around it hold one vertex of the mesh.
	class VertexCells {
	public:
		explicit VertexCells(Real size)
		        : size_(size)
		{
		}
		void add(const Vector3r& vertex, size_t facet) { cells_[cellOf(vertex)].push_back(facet); }
		template <class Visit> void around(const Vector3r& vertex, const Visit& visit) const
		{
			const Cell cell = cellOf(vertex);
			for (int i = 0; i < 27; ++i) {
				const auto found = cells_.find({ cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1 });
				if (found == cells_.end()) continue;
				for (const size_t facet : found->second)
					visit(facet);
			}
		}

	private:
		using Cell = std::array<long long, 3>;
		Cell cellOf(const Vector3r& x) const
		{
			return { (long long)std::floor(x[0] / size_), (long long)std::floor(x[1] / size_), (long long)std::floor(x[2] / size_) };
		}
		Real size_;
		std::map<Cell, std::vector<size_t>> cells_;
	};

} // namespace

MeshFacet meshFacet(const Facet& facet, const State& state, Body::id_t id)
{
	const Matrix3r rotation = state.ori.toRotationMatrix();
	MeshFacet result { id, {} };
	for (int i = 0; i < 3; ++i)
		result.vertices[i] = state.pos + rotation * facet.vertices[i];
	return result;
}

void FacetNeighbours::find(const Scene& scene, bool again)
{
	if (!again && isUpToDate(scene)) return;
	const std::lock_guard<std::mutex> lock(searching);
	if (!again && isUpToDate(scene)) return;
	const std::vector<MeshFacet> facets = facetsOf(scene);
	if (again || searchedScene != &scene || searchedBodies != scene.bodies->size() || !areTheSame(facets)) search(facets);
	searchedScene.store(&scene, std::memory_order_release);
	searchedBodies.store(scene.bodies->size(), std::memory_order_release);
	searchedAt.store(scene.iter, std::memory_order_release);
}

bool FacetNeighbours::isUpToDate(const Scene& scene) const
{
	return searchedScene.load(std::memory_order_acquire) == &scene && searchedBodies.load(std::memory_order_acquire) == scene.bodies->size()
	        && (!scene.bodies->useRedirection || searchedAt.load(std::memory_order_acquire) == scene.iter);
}

bool FacetNeighbours::areTheSame(const std::vector<MeshFacet>& facets) const
{
	return facets.size() == neighbours.size()
	        && std::all_of(facets.begin(), facets.end(), [&](const MeshFacet& facet) { return neighbours.count(facet.id) > 0; });
}

void FacetNeighbours::search(const std::vector<MeshFacet>& facets)
{
	neighbours.clear();
	Real shortest = std::numeric_limits<Real>::infinity();
	for (const MeshFacet& facet : facets)
		shortest = std::min(shortest, shortestEdge(facet));
	VertexCells cells(10 * sameVertex * shortest);
	for (size_t i = 0; i < facets.size(); ++i)
		for (const Vector3r& vertex : facets[i].vertices)
			cells.add(vertex, i);
	for (size_t i = 0; i < facets.size(); ++i) {
		auto& found = neighbours[facets[i].id];
		for (const Vector3r& vertex : facets[i].vertices)
			cells.around(vertex, [&](size_t k) {
				if (k != i && shareVertex(facets[i], facets[k])) found.push_back(facets[k].id);
			});
		std::sort(found.begin(), found.end());
		found.erase(std::unique(found.begin(), found.end()), found.end());
	}
}

std::vector<MeshFacet> FacetNeighbours::of(const MeshFacet& facet, const Scene& scene) const
{
	std::vector<MeshFacet> result;
	const auto found = neighbours.find(facet.id);
	if (found == neighbours.end()) return result;
	for (const Body::id_t id : found->second) {
		const auto& body = (*scene.bodies)[id];
		const auto* shape = body ? dynamic_cast<const Facet*>(body->shape.get()) : nullptr;
		if (!shape) continue;
		const MeshFacet neighbour = meshFacet(*shape, *body->state, id);
		if (shareVertex(facet, neighbour)) result.push_back(neighbour);
	}
	return result;
}

} // namespace yade
