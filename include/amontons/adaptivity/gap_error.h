/// The error of the pressure by a declared gap that changes within the faces.
#pragma once

#include <amontons/contact/surface_fields.h>

namespace Amontons
{
  /// By slave face: E*^2/4 int |grad(g - I g)|^2 with the declared gap g (`Initial gap`) and its
  /// interpolation I g of degree 4 on the face. Half spaces answer a gap A cos kx with the pressure -E* k A/2
  /// cos kx, so the mean squares of what a gap makes are those of its slope: what a face does not see of a
  /// wavy gap is missing in the pressure. modulus: E* of both bodies. 0 on pairs that are tied or have no
  /// declared gap, and on faces that are not `near` the contact, unless bodies overlap somewhere on them; and
  /// where the gap jumps between nodes that have both of its values, an edge that the pressure tells of.
  /// (Beside other jumps, gaps count no farther than twice what closes.)
  template <int dim>
  std::vector<double>
  gap_errors(const ContactInterface<dim> &interface,
             const SurfaceFields<dim>    &fields,
             const double                 modulus,
             const ProblemType            kind,
             const std::vector<bool>     &near);

  /// Of the faces of a rank; 0 where the gap may jump, which finer meshes do not see better.
  template <int dim>
  double
  sum_of_smooth_gap(const ContactInterface<dim> &interface,
                    const std::vector<double>   &by_face,
                    const unsigned int           rank);
} // namespace Amontons
