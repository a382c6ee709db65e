#pragma once
/// CGAL's constrained Delaunay triangulation as this module has it: exact predicates, and where
/// segments cross a point to double precision.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace burin {

using PlanarKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class VertexInfo, class FaceInfo>
using ConstrainedDelaunay = CGAL::Constrained_Delaunay_triangulation_2<
    PlanarKernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, PlanarKernel>,
        CGAL::Constrained_triangulation_face_base_2<
            PlanarKernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, PlanarKernel>>>,
    CGAL::Exact_predicates_tag>;

}  // namespace burin
