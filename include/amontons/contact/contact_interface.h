// Two surfaces that may touch, with their coupling: one per contact pair of the scene, rebuilt with the mesh.
#pragma once

#include <amontons/contact/mortar_integrator.h>
#include <amontons/contact/nodal_contact.h>

#include <memory>
#include <optional>

namespace Amontons
{
  template <int dim>
  struct ContactInterface
  {
    const PairData                      *pair = nullptr;
    std::unique_ptr<ContactSurface<dim>> slave;
    std::unique_ptr<ContactSurface<dim>> master_surface; // empty for analytic obstacles
    MasterSide<dim>                      master;
    Coupling<dim> coupling; // small sliding: integrated once per mesh, in the reference configuration
    double        t = 0;    // at which declared gaps are taken
    // The smallest gap before anything has moved (small strain: as it is declared for t, finite strain: of
    // the meshes with what is declared), and the normals along which it is that to a tenth. Infinite:
    // nothing is opposite. Meshes of one history tell each other.
    struct FirstGap
    {
      double                      size = std::numeric_limits<double>::infinity();
      std::vector<Tensor<1, dim>> normals;
      Point<dim>                  place;             // of the slave, undeformed, where it is nearest
      double                      t         = 0;     // that a declared gap is of
      bool                        is_at_end = false; // of the slave, see slave_end_presses()
    };
    std::optional<FirstGap> first_gap;
    std::vector<bool>
        carries; // by slave node: whether it may have a row: no support and no other pair has it
    std::vector<bool> carried;                  // slave nodes with a row
    unsigned int      n_without_multiplier = 0; // slave nodes that supports own whole
    // Gaps up to this are part of the coupling. 0: not known yet, chosen from the sizes of the surfaces.
    double search_distance = 0;
    bool   collocated      = false; // node to segment, see node_to_segment.h
    // By slave node, empty: none (shared_nodes.h). Another pair has it, whose master covers the same place,
    // by this part; this pair comes first there, as the bodies overlapped.
    std::vector<double> behind;
    std::vector<bool>   preferred;
    // Slave faces that are coupled; empty: all.
    std::vector<bool> wanted_faces;
  };

  // Whether the declared gap depends on time.
  template <int dim>
  bool
  gap_grows(const ContactInterface<dim> &interface)
  {
    return interface.pair->initial_gap && interface.pair->initial_gap->depends_on_time();
  }

  // Which side of each pair is the slave, decided once on the first mesh: true = first. Automatic: rigid
  // bodies and obstacles are masters; else the finer, softer side: the smaller product of mean face size and
  // Young modulus; the first if they are equal. Pairs of the same two bodies that meet at a corner of both
  // (a key in its keyway) decide together, in the mean of the logarithms: a corner of each body, slave in one
  // pair and master in the other, would be held twice by nearly the same equations, where friction has no
  // solution or many.
  template <int dim>
  std::vector<bool>
  choose_slaves(const Discretization<dim> &discretization);

  // Where the scene says otherwise of pairs with friction; empty: nowhere.
  template <int dim>
  std::string
  contradicting_slaves(const Discretization<dim> &discretization, const std::vector<bool> &first_is_slave);

  // Surfaces of all pairs. Collective.
  template <int dim>
  std::vector<ContactInterface<dim>>
  make_interfaces(const Discretization<dim> &discretization, const std::vector<bool> &first_is_slave);

  // Takes both sides to where u (readable at all their DoFs) puts them; false if they are there.
  template <int dim>
  bool
  move_interface(const Discretization<dim> &discretization,
                 const LA::Vector          &u,
                 ContactInterface<dim>     &interface);

  // Fills the couplings, with the gaps declared for interface.t; `supports` tells which slave nodes cannot
  // carry a multiplier. moved: see find_overlaps.
  template <int dim>
  void
  integrate_couplings(const Discretization<dim>          &discretization,
                      const Constraints                  &supports,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const bool                          moved = false);

  // Couples the surfaces where u takes them, with the gaps declared for time t, unless they are there
  // already; tied ones stay where they were.
  template <int dim>
  void
  couple_moved(const Discretization<dim>          &discretization,
               const Constraints                  &supports,
               const LA::Vector                   &u,
               const double                        t,
               std::vector<ContactInterface<dim>> &interfaces);

  // Surfaces that have not moved: gaps that depend on time are taken at t. Nodes keep their rows.
  template <int dim>
  void
  redeclare_gaps(const Discretization<dim>          &discretization,
                 const double                        t,
                 std::vector<ContactInterface<dim>> &interfaces);

  // The answer on one slave surface: by slave node.
  template <int dim>
  struct SurfaceFields
  {
    std::vector<double> pressure; // L2 projection of the multiplier on to continuous functions, nodal values;
                                  // 0 outside the overlap
    std::vector<double>         multiplier; // p_i of the node's coupling row, 0 without
    std::vector<double>         gap;    // weighted gap of the row, >= 0; NaN without a row (nothing opposite)
    std::vector<double>         area;   // int psi_i, 0 without a row
    std::vector<Tensor<1, dim>> normal; // unit; of the slave, or of both (common_normal.h)
    std::vector<Tensor<1, dim>> traction; // on the slave, tangential part (tied pairs and friction)
    std::vector<Tensor<1, dim>> slip;     // tangential displacement of the slave relative to the master
    std::vector<ContactStatus>  state;
    std::vector<Tensor<1, dim>> displacement;
    std::vector<Tensor<1, dim>>
        force; // on the slave body: nodal forces; their sum is normal_force + tangential_force
    std::vector<bool>
        is_covered; // the other side is opposite; elsewhere pressure and traction are continuations
    std::vector<double> bound; // friction: of the tangential traction, projected as the pressure is

    // Of the contact forces on the slave body: sum area p normal etc.; peak and size from the projected
    // pressure.
    Tensor<1, dim> normal_force, tangential_force;
    double         peak_pressure = 0;
    double         contact_size =
        0; // half-width sqrt(4 int p x^2 / int p) (2D), radius sqrt(2.5 int p r^2 / int p) (3D, axisymmetric)
    double         stick_size = 0; // friction: likewise with what the shear leaves of its bound
    Point<dim>     centre;         // about which the size is taken
    Point<dim>     stick_centre;   // friction: about which stick_size is taken
    Tensor<2, dim> covariance;     // int p (x - centre)(x - centre) / int p
    std::vector<Tensor<1, dim>>
           symmetry_planes; // normals of those through the contact (not the axis of revolution)
    double symmetry_factor =
        1; // 2 for each symmetry plane through the contact: only that part of it is meshed
  };
} // namespace Amontons
