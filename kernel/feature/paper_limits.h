#pragma once
// Every tolerance of the module feature, each with its unit. Paper mm and radians only: a model of
// any size and place meets the same limits.

#include <burin/camera/facing.h>

#include <cstddef>

namespace burin {

/// Paper mm: a triangle that is itself edge-on, but whose corner normals claim a bulge (sagitta) of
/// more than this, is a flat wall with blended normals, not a fine facet of something round.
inline constexpr double kFlatBulge = 0.02;

/// Paper mm: what a facet shows of a side that is not its own, by the normals at its corners, in
/// its mean width: from here on its contour is out of place, and runs along its edges. Facets at
/// tips are flat and do not stand for anything round.
inline constexpr double kOutOfPlace = 0.1;
inline constexpr double kOutOfPlaceAtTip = 0.02;

/// Paper mm: where the round surface over a facet at a tip lies so far off it a contour over that
/// surface is none of the facet, which hides as it is.
inline constexpr double kUnlikeFacet = 0.1;

/// Paper mm: a patch of a smooth region that is turned to the viewer but shows less than this in
/// its mean width (area seen over length) is turned away: nobody can see it, and its borders would
/// double lines.
inline constexpr double kThinWidth = 0.02;

/// Paper mm: a zero of g nearer than this to the end of a mesh edge is put on that end, so that no
/// crumbs of lines are born.
inline constexpr double kSnapLength = 1e-3;

/// Paper mm: a contour whose zeros lie this near to a smooth edge of the input runs along it.
inline constexpr double kAlongEdge = 0.01;

/// Paper mm: between its points a contour may be this far from the smooth line through them: a
/// fifth of what the writers' curves may be off.
inline constexpr double kRoundness = 0.004;

/// Paper mm: so far such a line may leave flat facets, too, which are as far off what they stand
/// for.
inline constexpr double kUnseenBulge = 0.025;

/// Paper mm: a contour turns between its visible and its self-hidden state only where it goes on
/// for this long in the new one; shorter runs are noise of the triangulation.
inline constexpr double kCuspLength = 0.1;

/// A closed contour inside one smooth region is noise, not shape, where the surface inside it never
/// turns by more than an angle through edge-on: kNoiseAngle for any loop, kSpeckAngle for a loop of
/// less than kSpeckLength. Radians, radians, paper mm.
inline constexpr double kNoiseAngle = 0.02;
inline constexpr double kSpeckAngle = 0.35;
inline constexpr double kSpeckLength = 0.3;

/// Paper mm, not foreshortened, of a right-angled crease (one of half the bend needs twice the
/// length): a crease with the same smooth region on both its sides separates nothing; where it is
/// shorter than this it is the noise of a scan, a hair on the picture.
inline constexpr double kHairLength = 6;
/// A smooth region of so few triangles, of so little area (mm^2 of paper, not foreshortened), is an
/// island of noise: short creases around it count as hair where they bend by less than kIslandBend
/// (radians) all along. Real parts of that size (the walls of a small letter) bend by more.
inline constexpr std::size_t kIslandFaces = 6;
inline constexpr double kIslandArea = 4;
inline constexpr double kIslandBend = 1.2;

/// Paper mm: an intersection of two parts that runs this near along a crease or boundary of one of
/// them is a contact of their borders, which are drawn anyway. Runs shorter than kSpeckLength are
/// kept (they cross the crease), and what is left between such runs is dropped where it is shorter.
inline constexpr double kContactLength = 0.01;

/// Radians: surfaces that cross at less than this along most of a curve touch, and their facets cut
/// each other by chance. Facing each other (a shaft in its hole, facets of up to 14 degrees), or
/// facing the same way (two shafts of one radius that overlap).
inline constexpr double kContactAngle = 0.25;
inline constexpr double kOverlapAngle = 0.05;

}  // namespace burin
