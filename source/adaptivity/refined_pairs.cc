#include <amontons/adaptivity/refined_pairs.h>
#include <amontons/adaptivity/unseen_contact.h>

namespace Amontons
{
  template <int dim>
  void
  RefinedPairs<dim>::look(const std::vector<ContactInterface<dim>> &interfaces,
                          const std::vector<SurfaceFields<dim>>    &fields,
                          const unsigned int                        mesh)
  {
    constexpr double smaller = 0.75;
    first.resize(interfaces.size());
    factors.assign(interfaces.size(), 1.);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const double face = smallest_closed_face(interfaces[i], fields[i]);
        if (interfaces[i].pair->tied || face == 0)
          continue;
        if (contact_is_resolved(interfaces[i], fields[i]) && (!first[i] || first[i]->mesh == mesh))
          first[i] = {mesh, first[i] ? std::min(face, first[i]->face) : face};
        if (mesh > 0 && !(first[i] && face < smaller * first[i]->face))
          factors[i] = doubt;
      }
  }

  template class RefinedPairs<2>;
  template class RefinedPairs<3>;
} // namespace Amontons
