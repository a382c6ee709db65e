#pragma once
/// OCCT's points and vectors as Burin's.

#include <burin/base/vec.h>

#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

namespace burin {

inline Vec3 to_vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_vec(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
inline Vec3 to_vec(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }
inline Vec2 to_vec(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }

}  // namespace burin
