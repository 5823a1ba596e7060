// Which facets of the scene share a vertex: found once, looked up by every contact near a facet's border.
#pragma once

#include <core/Scene.hpp>
#include <pkg/common/Facet.hpp>
#include <pkg/detection/FacetMesh.hpp>

#include <atomic>
#include <mutex>
#include <unordered_map>

namespace yade {

// The facet in space.
superquadric::MeshFacet meshFacet(const Facet& facet, const State& state, Body::id_t id);

class FacetNeighbours {
public:
	// Looks for them when the scene has other bodies than last time, or `again`. Where bodies have been removed, and with MPI, facets may come and go in
	// places that are kept for them: then the facets are looked through once a step. May be called by all threads at once.
	void find(const Scene& scene, bool again = false);

	// Those that still share a vertex with the facet, where they are now. A mesh may move; what moves away from another is no neighbour.
	std::vector<superquadric::MeshFacet> of(const superquadric::MeshFacet& facet, const Scene& scene) const;

private:
	bool isUpToDate(const Scene& scene) const;
	bool areTheSame(const std::vector<superquadric::MeshFacet>& facets) const;
	void search(const std::vector<superquadric::MeshFacet>& facets);

	std::unordered_map<Body::id_t, std::vector<Body::id_t>> neighbours;
	std::mutex searching;
	std::atomic<const Scene*> searchedScene { nullptr };
	std::atomic<size_t> searchedBodies { 0 };
	std::atomic<long> searchedAt { -1 }; // step
};

} // namespace yade
