#include <amontons/contact/nodal_traces.h>

#include <algorithm>

namespace Amontons
{
  template <int dim>
  std::vector<bool>
  find_nodal_traces(const ContactSurface<dim> &slave, const std::vector<bool> &positive_faces)
  {
    std::vector<bool> nodal(slave.nodes.size(), false);
    if (slave.degree == 1)
      return nodal;
    for (const auto &face : slave.faces)
      for (const unsigned int i : face.unknowns)
        nodal[i] = nodal[i] || (!face.straight && slave.nodes[i].control.size() > 1);
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      for (const unsigned int i : slave.faces[f].unknowns)
        nodal[i] = nodal[i] && positive_faces[f];
    return nodal;
  }

  template <int dim>
  FullMatrix<double>
  change_to_nodal(const ContactSurface<dim> &slave,
                  const SurfaceFace<dim>    &face,
                  const std::vector<bool>   &nodal)
  {
    const auto is_nodal = [&](const unsigned int i) { return nodal[i]; };
    if (std::none_of(face.unknowns.begin(), face.unknowns.end(), is_nodal))
      return FullMatrix<double>();
    const unsigned int                   n = face.unknowns.size();
    std::map<unsigned int, unsigned int> place;
    for (const unsigned int i : face.unknowns)
      place.emplace(i, place.size());
    FullMatrix<double> P(n, n);
    for (unsigned int k = 0; k < n; ++k)
      for (const auto &[i, weight] : slave.nodes[face.unknowns[k]].control)
        P(k, place.at(i)) += weight;
    P.gauss_jordan();
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; !nodal[face.unknowns[k]] && l < n; ++l)
        P(k, l) = k == l;
    return P;
  }

  template std::vector<bool>
  find_nodal_traces(const ContactSurface<2> &, const std::vector<bool> &);
  template std::vector<bool>
  find_nodal_traces(const ContactSurface<3> &, const std::vector<bool> &);
  template FullMatrix<double>
  change_to_nodal(const ContactSurface<2> &, const SurfaceFace<2> &, const std::vector<bool> &);
  template FullMatrix<double>
  change_to_nodal(const ContactSurface<3> &, const SurfaceFace<3> &, const std::vector<bool> &);
} // namespace Amontons
