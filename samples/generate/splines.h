#pragma once
/// Spline models: surfaces that sweep circles, and the files they are written to.

#include <burin/forms/charted/nurbs.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace burin::samples {

/// An ellipse in space: center, and its half axes as vectors.
struct Ring {
  Vec3 center, a, b;
};

/// A cubic B-spline over rings as its control rows (u), exact ellipses across (v): rational
/// quadratics of four quarters. It begins and ends at the first and the last ring. A ring without
/// extent makes a pole.
NurbsData sweep(const std::vector<Ring>& rings);

/// Turns the control points (radius, height) of a profile about z.
NurbsData turn(const std::vector<Vec2>& profile);

/// A named object of an IRIT file; several make a list of the name of the file.
struct SplineObject {
  std::string name;
  std::string rgb;  // "200,100,0" or empty
  std::vector<NurbsData> surfaces;
};
void write_irit(const std::vector<SplineObject>& objects, const std::filesystem::path& path);

/// The horn of Elber's paper: a circle that sweeps a helix while both grow, with a round tip and a
/// rim that turns inwards, all borders smooth: a closed body. On its wall u runs along it, v
/// around.
std::vector<SplineObject> horn();
/// Body, lid, spout and handle, each a closed body of one patch.
std::vector<SplineObject> spline_teapot();

// Figures of Elber's paper, by models of our own.

/// Two discs of one size side by side: a patch whose sides are quarters of the circle, and rings
/// about a point off the middle (figure 4).
std::vector<SplineObject> two_discs();
/// Lofted fuselage of two parts, wings with tips, tail, engines (figure 5).
std::vector<SplineObject> aeroplane();
/// One closed patch, alike under a sixth of a turn (figure 12).
std::vector<SplineObject> star();
/// A round table, a glass, a plate and a bottle (figure 8).
std::vector<SplineObject> tableware();
/// A file each: the six pieces, standing on z = 0, and the board of 64 squares and a frame (figures
/// 6 and 15).
std::vector<std::pair<std::string, std::vector<SplineObject>>> chess_pieces();
/// The illustration of all 32 on the board; the files of `chess_pieces` are looked for in `chess`
/// beside it.
void write_chess(const std::filesystem::path& path);

}  // namespace burin::samples
