/// What a converged (or current) state consists of.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/contact/nodal_contact.h>

namespace Amontons
{
  template <int dim>
  struct SolutionState
  {
    double     t = 0;
    LA::Vector displacement; // readable at relevant DoFs; obeys hanging nodes and supports
    /// The displacement that the increment started from, nearly all the history there is: slip is the change
    /// of the tangential jump since then. Empty: none.
    LA::Vector committed;
    double     committed_t = 0; // its time
    /// And what that one started from, if loads went on as they did in it. Empty: they did not.
    LA::Vector                      earlier;
    double                          earlier_t = 0;
    LA::Vector                      before_earlier;    // and that one, likewise
    std::vector<NodalContacts<dim>> committed_contact; // at that time; empty: none
    /// By pair and slave node: it was open at the end of an increment before, on this mesh. Empty: none was.
    std::vector<std::vector<bool>> was_open;
    /// A field on the slave nodes' DoFs (zero elsewhere) that carries the states from one mesh to the next:
    /// along the normal (p/peak)^2, continued to negative values beyond the contact; along the surface the
    /// trial shear over its bound, a node slipping where this exceeds 1.
    LA::Vector                      traction;
    std::vector<double>             peaks;   // of p, by pair
    std::vector<NodalContacts<dim>> contact; // by pair and slave node; empty: not known

    /// Of a slave node, null if nothing is known.
    const NodalContact<dim> *
    contact_of(const unsigned int pair, const unsigned int node) const
    {
      return contact.empty() ? nullptr : &contact[pair][node];
    }
  };
} // namespace Amontons
