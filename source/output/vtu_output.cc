#include <amontons/base/gather.h>
#include <amontons/output/files.h>
#include <amontons/output/output_folder.h>
#include <amontons/output/summary.h>
#include <amontons/output/vtu_output.h>

#include <deal.II/base/utilities.h>

#include <deal.II/numerics/data_out.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // von Mises stress of the nodal stresses.
    template <int dim>
    LA::Vector
    nodal_von_mises(const StressRecovery<dim> &recovery)
    {
      const IndexSet &owned = recovery.dof_handler().locally_owned_dofs();
      LA::Vector      result(owned, recovery.stress()[0].get_mpi_communicator());
      for (const auto i : owned)
        {
          Voigt<dim> stress;
          for (unsigned int c = 0; c < stress.size(); ++c)
            stress[c] = recovery.stress()[c](i);
          result(i) = von_mises<dim>(stress);
        }
      result.compress(VectorOperation::insert);
      LA::Vector readable(recovery.stress()[0]);
      readable = result;
      return readable;
    }

    // Owned cells of bodies; carriers of rigid motions are left out.
    template <int dim>
    void
    select_cells(DataOut<dim> &data_out, const Geometry<dim> &geometry)
    {
      using Iterator        = typename Triangulation<dim>::cell_iterator;
      const auto first_from = [&geometry](Iterator cell, const Iterator &end) {
        while (cell != end &&
               !(cell->is_active() && cell->is_locally_owned() && !geometry.is_carrier(cell->material_id())))
          ++cell;
        return cell;
      };
      const std::function<Iterator(const Triangulation<dim> &)> first =
          [first_from](const Triangulation<dim> &triangulation) {
            return first_from(triangulation.begin(), triangulation.end());
          };
      const std::function<Iterator(const Triangulation<dim> &, const Iterator &)> next =
          [first_from](const Triangulation<dim> &triangulation, const Iterator &cell) {
            Iterator following = cell;
            return first_from(++following, triangulation.end());
          };
      data_out.set_cell_selection(first, next);
    }

    // Number of the body and rank, by active cell.
    template <int dim>
    std::array<Vector<float>, 2>
    cell_labels(const Triangulation<dim> &triangulation)
    {
      std::array<Vector<float>, 2> labels;
      for (Vector<float> &label : labels)
        label.reinit(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            labels[0](cell->active_cell_index()) = cell->material_id();
            labels[1](cell->active_cell_index()) = cell->subdomain_id();
          }
      return labels;
    }

    template <int dim>
    void
    add_nodal_fields(DataOut<dim>          &data_out,
                     const BodyFields<dim> &fields,
                     const LA::Vector      &von_mises_stress)
    {
      const Discretization<dim> &discretization = fields.discretization;
      data_out.add_data_vector(discretization.dof_handler,
                               fields.displacement,
                               std::vector<std::string>(dim, "displacement"),
                               std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                   dim, DataComponentInterpretation::component_is_part_of_vector));
      const std::vector<std::string> names = stress_names(discretization.scene.kind);
      for (unsigned int c = 0; c < names.size(); ++c)
        data_out.add_data_vector(
            fields.recovery.dof_handler(), fields.recovery.stress()[c], "stress_" + names[c]);
      data_out.add_data_vector(fields.recovery.dof_handler(), von_mises_stress, "von_mises");
    }
    // Gives out what DataOut keeps to itself: a file holds the parts of several ranks.
    template <int dim>
    class BodyOutput : public DataOut<dim>
    {
    public:
      // The parts of each `group` ranks are one file; on its lowest rank its text, else empty. Collective.
      std::string
      write_together(const DataOutBase::VtkFlags &flags, const int group, const MPI_Comm communicator) const
      {
        using namespace Utilities::MPI;
        std::ostringstream head, part, tail;
        DataOutBase::write_vtu_header(head, flags);
        DataOutBase::write_vtu_footer(tail);
        MPI_Comm together;
        MPI_Comm_split(communicator, group, this_mpi_process(communicator), &together);
        const bool         is_root = this_mpi_process(together) == 0;
        const unsigned int n_mine = this->get_patches().size(), n_all = sum(n_mine, together);
        if (n_mine > 0 || (n_all == 0 && is_root)) // ParaView wants no empty part beside others
          DataOutBase::write_vtu_main(
              this->get_patches(), this->get_dataset_names(), this->get_nonscalar_data_ranges(), flags, part);
        const auto parts = gather_on_first(together, part.str());
        MPI_Comm_free(&together);
        std::string text = head.str();
        for (const std::string &one : parts)
          text += one;
        return is_root ? text + tail.str() : "";
      }
    };
  } // namespace

  VtuOutput::VtuOutput(const std::string &folder, const MPI_Comm communicator)
      : folder(folder), communicator(communicator)
  {
  }

  void
  VtuOutput::restart()
  {
    bodies.clear();
    contacts.clear();
  }

  void
  VtuOutput::remove_earlier() const
  {
    remove_later_files(folder, "bodies", "p?vtu", bodies.size());
    remove_later_files(folder, "contact", "vtu", contacts.size());
  }

  template <int dim>
  void
  VtuOutput::write_bodies(const BodyFields<dim> &fields, const double t)
  {
    const Discretization<dim> &discretization = fields.discretization;
    const LA::Vector           von_mises      = nodal_von_mises(fields.recovery);
    const auto                 labels         = cell_labels(discretization.geometry.triangulation);

    BodyOutput<dim> data_out;
    data_out.attach_triangulation(discretization.geometry.triangulation);
    select_cells(data_out, discretization.geometry);
    add_nodal_fields(data_out, fields, von_mises);
    data_out.add_data_vector(fields.indicators, "error_indicator", DataOut<dim>::type_cell_data);
    data_out.add_data_vector(labels[0], "body", DataOut<dim>::type_cell_data);
    data_out.add_data_vector(labels[1], "subdomain", DataOut<dim>::type_cell_data);
    data_out.build_patches(
        discretization.mapping(), discretization.fe.degree, DataOut<dim>::curved_inner_cells);

    DataOutBase::VtkFlags flags;
    flags.compression_level        = DataOutBase::VtkFlags::best_speed;
    constexpr unsigned int most    = 4; // files
    const unsigned int     n_files = std::min(most, Utilities::MPI::n_mpi_processes(communicator)),
                       rank = Utilities::MPI::this_mpi_process(communicator), group = rank % n_files;
    const std::string name    = "bodies_" + Utilities::int_to_string(bodies.size(), 4);
    const auto        file_of = [&](const unsigned int k) { return name + "." + std::to_string(k) + ".vtu"; };
    bodies.emplace_back(t, name + ".pvtu");
    if (const std::string text = data_out.write_together(flags, group, communicator); !text.empty())
      write_file(folder + "/" + file_of(group), text);
    if (rank != 0)
      return;
    std::vector<std::string> files;
    for (unsigned int k = 0; k < n_files; ++k)
      files.push_back(file_of(k));
    std::ostringstream record;
    data_out.write_pvtu_record(record, files);
    write_file(folder + "/" + name + ".pvtu", record.str());
    write_records("bodies", bodies);
  }

  template <int dim>
  void
  VtuOutput::write_contact(const std::vector<ContactInterface<dim>> &interfaces,
                           const std::vector<SurfaceFields<dim>>    &fields,
                           const double                              t)
  {
    const std::string name = "contact_" + Utilities::int_to_string(contacts.size(), 4) + ".vtu";
    contacts.emplace_back(t, name);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      write_file(folder + "/" + name, contact_vtu(interfaces, fields));
    write_records("contact", contacts);
  }

  void
  VtuOutput::write_records(const std::string &name, const Records &records) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::ostringstream text;
    DataOutBase::write_pvd_record(text, records);
    write_file(folder + "/" + name + ".pvd", text.str());
  }

  template void
  VtuOutput::write_bodies(const BodyFields<2> &, const double);
  template void
  VtuOutput::write_bodies(const BodyFields<3> &, const double);
  template void
  VtuOutput::write_contact(const std::vector<ContactInterface<2>> &,
                           const std::vector<SurfaceFields<2>> &,
                           const double);
  template void
  VtuOutput::write_contact(const std::vector<ContactInterface<3>> &,
                           const std::vector<SurfaceFields<3>> &,
                           const double);
} // namespace Amontons
