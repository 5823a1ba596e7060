// Every tolerance of the project's C++ code, each with what it means physically. All but the range of sizes are dimensionless, so that verdicts do not
// depend on whether the grains are micrometres or metres.
#pragma once

namespace superquadric::tolerances {

// Supported exponents. Below 2 the curvature is infinite on the coordinate planes; above 20 the radius of an edge
// is under 5 % of the half size, where a smooth contact law has no meaning left.
constexpr double smallestExponent = 2.0;
constexpr double largestExponent = 20.0;

// Half sizes [m] whose products of up to ten, as in an inertia over a curvature, neither overflow nor vanish.
constexpr double smallestHalfSize = 1e-30;
constexpr double largestHalfSize = 1e30;

// Centres nearer than this part of the smallest half size are taken for one point: no place in a scene is known so well, and squares of what is
// much smaller would vanish.
constexpr double concentric = 1e-16;

// How strongly the contact is drawn to the middle of both bodies, in the measure in which it is broad (PairProblem.hpp): faces of
// half width a that touch with overlap d answer a tilt by moving the contact by tilt a^2/(2 d) (plate under a block) to tilt a^2/(4 d)
// (equal blocks), and an elastic foundation of the same size by tilt a^2/(3 d).
constexpr double centring = 2;

// A Newton step shorter than this part of the smallest half size is the last: the model's own second derivatives tell what is at
// its end, and what the third would add is its square.
constexpr double lastStep = 1e-6;

// A normal that turns by less [rad] keeps its length to rounding after one correction.
constexpr double smallTurn = 1e-4;

// The conditions of the contact centre are met to rounding: the gradients across the normal, relative to those along it. Where two
// flat faces all but touch, any point of them does.
constexpr double normalRounding = 1e-14;
// With a pull to the middle of more than this, that rounding moves the point by less than the last step.
constexpr double blurredPull = 1e-8;

// A gap counts as used up when the bodies have moved by all but this part of it; and this part of their size is kept in reserve, for the
// rounding of the sums of their motions. These are rounded upwards, by the second number at a time, and begin anew when one has
// reached so many bounding radii: it then rounds by a billionth of the reserve.
constexpr double gapReserve = 1e-6;
constexpr double sumRounding = 4.5e-16;
constexpr double longestTravel = 1e3;

// Rounding of a support function, relative.
constexpr double supportRounding = 1e-14;

// Scalings within this of 1 are reported as touching: neither an inner point nor a separating direction can be told
// from rounding.
constexpr double touching = 1e-11;

// Longest Newton step, in smallest half sizes: beyond it the quadratic model of a rounded edge is worthless.
constexpr double longestStep = 0.3;

// Iteration limits. Newton needs 1-3 warm and 5-8 cold; the rest goes to the fallback, whose limit is what shrinking
// an ellipsoid of a grain's size to the touching tolerance takes at its proven rate, with a margin.
constexpr int newtonIterations = 60;
constexpr int fallbackIterations = 2500;

// Regularisation of the tangential Newton system, relative to the squared gauge gradients: the first only keeps the division
// defined where two flat faces make the system singular; a refused step starts at the second and grows until the third.
constexpr double smallestRegularisation = 1e-14;
constexpr double firstRegularisation = 1e-4;
constexpr double largestRegularisation = 1e8;

// Rounding of a gauge near 1: an increase below it does not count against a Newton step.
constexpr double gaugeRounding = 1e-14;

// The fallback stops when the bounds of the common scaling are this close.
constexpr double fallbackGap = 1e-12;
// The same of the contact centre's objective, whose curvature is of order 1: its place is known to the square root.
constexpr double centreGap = 1e-14;

// Edges of two boxes closer to parallel than this give a separating axis made of rounding; the face axes then decide.
constexpr double parallelEdges = 1e-12;

// The surface search along the normal is done after a step of this part of the smallest half size: the next one, by quadratic
// convergence, would be its square.
constexpr double surfaceStep = 1e-7;
constexpr int surfaceIterations = 60;

// The minimum of the gauge on a triangle's edge is found to this part of the edge.
constexpr double edgeStep = 1e-15;
constexpr int edgeIterations = 200;

// The deepest point in a hollow cylinder is known once no other can lie farther out by more than the larger of two: this part of the
// body's bounding radius, this share of the overlap. Sectors of the angle are divided until then, or until there are so many; a round
// body on the axis, all of whose points are equally far out, needs them all. A division keeps this part of the sector clear of its
// ends. The point itself is climbed to until the surface there is across the radius to the last angle [rad].
constexpr double wallGap = 1e-10;
constexpr double wallShare = 0.01;
constexpr int wallSectors = 256;
constexpr double wallMargin = 0.2;
constexpr int wallAscents = 100;
constexpr double wallAscent = 1e-9;

// The contact centre on a flat wall is found after a step with a squared Newton decrement (its length in units of the contact's own
// extent) below this: by quadratic convergence it leaves some 1e-8 of that extent. Other steps must gain this part of what their
// slope promises, and are halved until they do or nothing of them is left.
constexpr double lastWallDecrement = 1e-9;
constexpr double wallDescent = 1e-4;
constexpr double shortestWallStep = 1e-9;

// Facets whose contact centres lie closer than this part of the body's smallest half size share one. A way into a neighbour leads down
// clearly when it is this part as steep as the pull towards the middle; below, the facets compare the centres themselves.
constexpr double seam = 1e-6;
constexpr double clearlyDown = 1e-3;

// Breakage. Cuts that are tried before a particle is halved along each axis instead; with the smallest piece that is allowed a tenth as large as the
// parent (in size), one in a few is accepted.
constexpr int cutTrials = 1000;

// The centre of a fragment stays inside its parent by this part of its own smallest half size, so that walls it is born at are left well on their
// side; but no contact draws it in below the second number, in half sizes of the parent. Moving in one fragment moves the others by its share of the
// mass only.
constexpr double fragmentMargin = 0.5;
constexpr double smallestReach = 0.25;
constexpr int placingRounds = 30;

// Axes that are tried for the fragments of a spinning ball, each time spread by this much more: at last all are as far out as they may.
constexpr int layoutTrials = 64;
constexpr double spreadStep = 0.02;

// Principal moments that differ by less than this part are those of a body that turns like a sphere.
constexpr double isotropic = 1e-9;

// Rounding of an energy of rotation, relative.
constexpr double energyRounding = 1e-13;

// Near a surface the sums whose roots are taken lie within this of 1: there a binomial series of nine terms is exact to rounding.
constexpr double nearOne = 0.02;
// A point with coordinates, in half sizes, between this factor and its inverse needs no scaling against overflow: most questions are asked there.
constexpr double nearSurface = 4;
// Nearer to the axis than this, in half sizes, x and y are taken relative to the larger of them, against underflow.
constexpr double nearAxis = 0.01;

// The search for the smallest gauge on a triangle's edge begins at least this part of the edge away from its ends, which have been looked at.
constexpr double edgeMargin = 0.1;

// Vertices of facets this close, in parts of the shortest edge, are one: meshes come from files with seven digits.
constexpr double sameVertex = 1e-5;

// An overlap of the square of this over the one at yield: any contact is deeper than its radius long before.
constexpr double farBeyondYield = 1e9;

// Pieces of the arc by whose chords a quarter of a section is divided: fine enough for the sharpest edge, of some 0.1 rad seen from the centre.
constexpr int arcPieces = 512;

// The 3D view. A plate that is flatter than this looks the same; neighbouring triangles with normals closer than this [rad] have no line between
// them; the coarsest quality that is drawn; and the binary logarithms of the pixels for which the coarsest and the finest triangles are made.
constexpr double flattestDrawn = 1e-6;
constexpr double flatEdge = 1e-9;
constexpr double coarsestQuality = 1e-3;
constexpr int coarsestDetail = 2;
constexpr int finestDetail = 12;

// Tessellations: more points are a mistake in the error asked for (a sphere takes about 5 times its radius over the error); and how sharply
// the coarsest grid is searched for, as a ratio of errors.
constexpr double tessellationPoints = 1e6;
constexpr double tessellationSharpness = 1.02;

} // namespace superquadric::tolerances
