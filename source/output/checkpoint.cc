#include <amontons/output/checkpoint.h>
#include <amontons/output/files.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <filesystem>
#include <random>
#include <regex>

namespace Amontons
{
  namespace
  {
    using Crc = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0, 0, false, false>;

    // Of the mesh, the same on any number of ranks: where its coarse cells are and which cells are active.
    template <int dim>
    unsigned long long
    signature(const Discretization<dim> &discretization)
    {
      const auto        &triangulation = discretization.geometry.triangulation;
      unsigned long long sum           = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            Crc        crc;
            const auto id = cell->id().template to_binary<dim>();
            crc.process_bytes(id.data(), sizeof(id));
            sum += crc.checksum();
          }
      sum = Utilities::MPI::sum(sum, discretization.geometry.communicator);
      Crc crc;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          crc.process_bytes(&cell->vertex(v), sizeof(Point<dim>));
      return sum + crc.checksum() + discretization.fe.degree;
    }

    // The owned part of each rank, one after the other, on rank 0.
    std::vector<double>
    gather_owned(const LA::Vector &vector, const IndexSet &owned, const MPI_Comm communicator)
    {
      std::vector<double> mine;
      for (const auto i : owned)
        mine.push_back(vector(i));
      const auto       sizes = Utilities::MPI::gather(communicator, static_cast<int>(mine.size()));
      std::vector<int> begins(1, 0);
      for (const int size : sizes)
        begins.push_back(begins.back() + size);
      std::vector<double> all(begins.back());
      MPI_Gatherv(mine.data(),
                  mine.size(),
                  MPI_DOUBLE,
                  all.data(),
                  sizes.data(),
                  begins.data(),
                  MPI_DOUBLE,
                  0,
                  communicator);
      return all;
    }

    template <int dim>
    StoredMesh
    cells_with_dofs(const Discretization<dim> &discretization)
    {
      StoredMesh                           mesh;
      std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            mesh.cells.push_back(cell->id().template to_binary<dim>());
            cell->get_dof_indices(dofs);
            mesh.dofs.insert(mesh.dofs.end(), dofs.begin(), dofs.end());
          }
      return mesh;
    }

    // On rank 0.
    template <int dim>
    StoredMesh
    gather_mesh(const Discretization<dim> &discretization)
    {
      StoredMesh all;
      for (const auto &part :
           Utilities::MPI::gather(discretization.geometry.communicator, cells_with_dofs(discretization)))
        {
          all.cells.insert(all.cells.end(), part.cells.begin(), part.cells.end());
          all.dofs.insert(all.dofs.end(), part.dofs.begin(), part.dofs.end());
        }
      return all;
    }

    template <int dim>
    constexpr unsigned int n_numbers = 4 + 3 * dim; // of a NodalContact

    template <int dim>
    void
    append(const NodalContact<dim> &node, std::vector<double> &numbers)
    {
      const auto &[has_multiplier, state, pressure, gap, shear, slip, trial] = node;
      numbers.insert(numbers.end(),
                     {double(has_multiplier), double(static_cast<char>(state)), pressure, gap});
      for (const auto *const vector : {&shear, &slip, &trial})
        for (unsigned int c = 0; c < dim; ++c)
          numbers.push_back((*vector)[c]);
    }

    template <int dim>
    NodalContact<dim>
    extract(const double *numbers)
    {
      NodalContact<dim> node;
      auto &[has_multiplier, state, pressure, gap, shear, slip, trial] = node;
      has_multiplier                                                   = *numbers++ != 0;
      state    = static_cast<ContactStatus>(static_cast<char>(*numbers++));
      pressure = *numbers++;
      gap      = *numbers++;
      for (auto *const vector : {&shear, &slip, &trial})
        for (unsigned int c = 0; c < dim; ++c)
          (*vector)[c] = *numbers++;
      return node;
    }

    // number: of the DoFs now.
    template <int dim>
    std::vector<NodalContacts<dim>>
    contact_of(const StoredSolve                          &known,
               const std::vector<types::global_dof_index> &number,
               const std::vector<ContactInterface<dim>>   &interfaces)
    {
      std::vector<NodalContacts<dim>> contact(interfaces.size());
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        {
          std::map<types::global_dof_index, const double *> by_dof;
          for (unsigned int k = 0; k < known.nodes[i].size(); ++k)
            by_dof[number[known.nodes[i][k]]] = &known.contact[i][k * n_numbers<dim>];
          for (const auto &node : interfaces[i].slave->nodes)
            contact[i].push_back(extract<dim>(by_dof.at(node.dofs[0])));
        }
      return contact;
    }

    template <int dim>
    void
    store_contact(const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<NodalContacts<dim>>    &contact,
                  StoredSolve                              &kept)
    {
      kept.contact.resize(interfaces.size());
      kept.nodes.resize(interfaces.size());
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        for (unsigned int k = 0; k < interfaces[i].slave->nodes.size(); ++k)
          {
            kept.nodes[i].push_back(interfaces[i].slave->nodes[k].dofs[0]);
            append(contact[i][k], kept.contact[i]);
          }
    }
    // By their last solves.
    std::vector<unsigned int>
    parts_in(const std::string &folder)
    {
      const std::regex          name("states_([0-9]{1,9})");
      std::vector<unsigned int> parts;
      std::smatch               number;
      for (const auto &entry : std::filesystem::directory_iterator(folder))
        if (const std::string found = entry.path().filename().string(); std::regex_match(found, number, name))
          parts.push_back(std::stoul(number[1]));
      std::sort(parts.begin(), parts.end());
      return parts;
    }
  } // namespace

  std::string
  Checkpoint::file(const std::string &name, const unsigned long long number) const
  {
    return folder + "/checkpoint/" + name + "_" + std::to_string(number);
  }

  bool
  Checkpoint::exists(const std::string &folder)
  {
    std::error_code error;
    return std::filesystem::is_regular_file(folder + "/checkpoint/run", error);
  }

  Checkpoint::Run
  Checkpoint::read_run(const std::string &folder)
  {
    if (!exists(folder))
      throw InputError({"command line", 0, "--resume " + folder},
                       "there is no checkpoint: this is no folder of a run, the run has ended, or it was "
                       "killed before it wrote one ('Output/Checkpoint every')",
                       "the output folder of a run that did not end");
    return read_object<StoredRun>(folder + "/checkpoint/run");
  }

  void
  Checkpoint::start(const std::string &where, const Run &what, const Intervals &how_often)
  {
    if (how_often.never())
      return;
    folder    = where;
    run       = what;
    intervals = how_often;
    std::random_device random;
    for (unsigned int k = 0; k < 4; ++k)
      run.id += std::to_string(random()) + "-";
  }

  void
  Checkpoint::resume(const std::string &where, const Run &what, const Intervals &how_often)
  {
    folder        = where;
    run           = what;
    intervals     = how_often;
    is_resumed    = true;
    const Run old = read_run(where);
    run.id        = old.id;
    for (const auto *const one : {&old, &what})
      for (const std::string &entry : one->entries)
        if (const auto &other = one == &old ? what.entries : old.entries;
            std::find(other.begin(), other.end(), entry) == other.end())
          throw InputError({what.scene, 0, ""},
                           "not what the run in " + where + " was started with: '" + entry + "' is " +
                               (one == &old ? "missing now" : "new"),
                           "the same entries (those of 'Output' may differ); or a new run");
    if (old.entries != what.entries)
      throw InputError({what.scene, 0, ""},
                       "not what the run in " + where +
                           " was started with: its sections or entries stand in another order",
                       "the same entries in the same order; or a new run");
    parts = parts_in(folder + "/checkpoint");
    load_next_part();
  }

  void
  Checkpoint::load_next_part()
  {
    if (n_read == parts.size())
      return;
    try
      {
        const std::string name = file("states", parts[n_read]);
        const auto        part = read_object<StoredPart>(name);
        if (part.run != run.id || part.solves.empty() || part.solves.back().number != parts[n_read])
          throw InputError(
              {name, 0, ""}, "of another run, or renamed", "what the run in this folder has written");
        if (part.before != (n_read > 0 ? parts[n_read - 1] : 0))
          throw InputError({name, 0, ""},
                           "the part before it, states_" + std::to_string(part.before) + ", is missing",
                           "what the run in this folder has written");
        known.insert(known.end(), part.solves.begin(), part.solves.end());
        ++n_read;
      }
    catch (const InputError &error)
      {
        forget_known(error.what());
      }
  }

  const StoredSolve *
  Checkpoint::next_known() const
  {
    return known.empty() ? nullptr : &known.front();
  }

  // The states of the part that is being used, and of all that were not read yet.
  void
  Checkpoint::forget_known(const std::string &why)
  {
    const unsigned int first = known.empty() ? n_read : n_read - 1;
    notes.push_back("warning: states of the checkpoint are solved again from solve " +
                    std::to_string(known.empty() ? n_solves + 1 : known.front().number) + " on: " + why +
                    " (they are kept as states_N.unused until the run ends)");
    unused.insert(unused.end(), parts.begin() + first, parts.end());
    if (is_open)
      set_unused_aside();
    known.clear();
    parts.resize(first);
    n_read = first;
  }

  void
  Checkpoint::set_unused_aside()
  {
    std::error_code error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const unsigned int part : unused)
        std::filesystem::rename(file("states", part), file("states", part) + ".unused", error);
    unused.clear();
  }

  void
  Checkpoint::open()
  {
    is_open = true;
    set_unused_aside();
  }

  // By the DoFs that cells had then. Collective; throws InputError before it changes anything.
  template <int dim>
  void
  Checkpoint::find_new_numbers(const Discretization<dim> &discretization, const StoredSolve &known)
  {
    if (known_numbering == known.numbering)
      return;
    const StoredMesh old = read_object<StoredMesh>(file("mesh", known.numbering));
    std::map<std::array<unsigned int, 4>, unsigned int> place;
    for (unsigned int c = 0; c < old.cells.size(); ++c)
      place[old.cells[c]] = c;
    const StoredMesh mine = cells_with_dofs(discretization);
    numbers.assign(discretization.dof_handler.n_dofs(), 0);
    const unsigned int n = discretization.fe.n_dofs_per_cell();
    for (unsigned int c = 0; c < mine.cells.size(); ++c)
      for (unsigned int i = 0; i < n; ++i)
        numbers[old.dofs[place.at(mine.cells[c]) * n + i]] = mine.dofs[c * n + i];
    Utilities::MPI::max(numbers, communicator, numbers);
    known_numbering = known.numbering;
  }

  template <int dim>
  std::optional<NewtonReport>
  Checkpoint::recall(const Discretization<dim>                &discretization,
                     const std::vector<ContactInterface<dim>> &interfaces,
                     SolutionState<dim>                       &state)
  {
    ++n_solves;
    const StoredSolve *const next = next_known();
    if (next == nullptr || next->number > n_solves)
      return {};
    if (std::abs(next->t - state.t) > 1e-12 * std::abs(state.t) || next->mesh != signature(discretization) ||
        next->contact.size() != interfaces.size())
      {
        forget_known(
            "this run takes another way from there, as runs on other ranks may, which round otherwise");
        return {};
      }
    try
      {
        find_new_numbers(discretization, *next);
      }
    catch (const InputError &error)
      {
        forget_known(error.what());
        return {};
      }
    const auto &number = numbers;
    LA::Vector  u      = discretization.make_owned_vector();
    for (types::global_dof_index i = 0; i < number.size(); ++i)
      if (discretization.locally_owned.is_element(number[i]))
        u(number[i]) = next->displacement[i];
    u.compress(VectorOperation::insert);
    state.displacement = discretization.make_relevant_vector();
    state.displacement = u;

    state.contact = contact_of(*next, number, interfaces);
    auto report   = next->report;
    known.pop_front();
    if (known.empty())
      load_next_part();
    if (known.empty())
      last_flush = std::chrono::steady_clock::now();
    return report;
  }

  template <int dim>
  void
  Checkpoint::keep(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const SolutionState<dim>                 &state,
                   const NewtonReport                       &report)
  {
    if (folder.empty() || intervals.never() || is_replaying()) // what had failed converges now: it will again
      return;
    const bool               is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    const unsigned long long mesh    = signature(discretization),
                             numbering =
                                 mesh + 0x9E3779B97F4A7C15 * Utilities::MPI::n_mpi_processes(communicator);
    if (numbering != kept_numbering)
      {
        StoredMesh all = gather_mesh(discretization);
        pending_bytes += sizeof(types::global_dof_index) * all.dofs.size();
        if (is_root)
          pending_meshes[numbering] = std::move(all);
      }
    kept_numbering = numbering;

    StoredSolve kept;
    kept.number       = n_solves;
    kept.t            = state.t;
    kept.mesh         = mesh;
    kept.numbering    = numbering;
    kept.report       = report;
    kept.displacement = gather_owned(state.displacement, discretization.locally_owned, communicator);
    if (!is_root)
      return;
    store_contact(interfaces, state.contact, kept);
    pending_bytes += sizeof(double) * kept.displacement.size();
    pending.solves.push_back(std::move(kept));
    if (is_due())
      flush();
  }

  bool
  Checkpoint::is_due() const
  {
    const double waited =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - last_flush).count();
    constexpr std::size_t most_bytes = 1u << 26; // each rank of a run that goes on reads a part as a whole
    return (intervals.solves > 0 && pending.solves.size() >= intervals.solves) ||
           (intervals.seconds > 0 && waited >= intervals.seconds) || pending_bytes > most_bytes;
  }

  // Meshes first: states need them.
  void
  Checkpoint::flush()
  {
    if (!is_open || pending.solves.empty() || Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::error_code error; // write_file says what is wrong
    std::filesystem::create_directories(folder + "/checkpoint", error);
    for (const auto &[number, mesh] : pending_meshes)
      write_object(file("mesh", number), mesh);
    if (!exists(folder))
      write_object(folder + "/checkpoint/run", run);
    pending.run    = run.id;
    pending.before = std::max(last_written, n_known());
    write_object(file("states", pending.solves.back().number), pending);
    last_written = pending.solves.back().number;
    pending.solves.clear();
    pending_meshes.clear();
    pending_bytes = 0;
    last_flush    = std::chrono::steady_clock::now();
  }

  void
  Checkpoint::remove()
  {
    std::error_code error;
    if (!folder.empty() && Utilities::MPI::this_mpi_process(communicator) == 0)
      std::filesystem::remove_all(folder + "/checkpoint", error);
  }

  template std::optional<NewtonReport>
  Checkpoint::recall(const Discretization<2> &, const std::vector<ContactInterface<2>> &, SolutionState<2> &);
  template std::optional<NewtonReport>
  Checkpoint::recall(const Discretization<3> &, const std::vector<ContactInterface<3>> &, SolutionState<3> &);
  template void
  Checkpoint::keep(const Discretization<2> &,
                   const std::vector<ContactInterface<2>> &,
                   const SolutionState<2> &,
                   const NewtonReport &);
  template void
  Checkpoint::keep(const Discretization<3> &,
                   const std::vector<ContactInterface<3>> &,
                   const SolutionState<3> &,
                   const NewtonReport &);
} // namespace Amontons
