#include <amontons/base/version.h>
#include <amontons/output/checkpoint_files.h>
#include <amontons/output/files.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace boost
{
  namespace serialization
  {
    using namespace Amontons;

    // Structured bindings name all members: one that is added does not compile until it is here.
    template <typename Archive>
    void
    serialize(Archive &archive, NewtonReport::Iteration &iteration, const unsigned int)
    {
      auto &[n_open, n_slip, n_stick, n_changes, krylov, residual] = iteration;
      archive &n_open &n_slip &n_stick &n_changes &krylov &residual;
    }

    // Of a solve that converged: without the failure.
    template <typename Archive>
    void
    serialize(Archive &archive, NewtonReport &report, const unsigned int)
    {
      auto &[converged,
             failure,
             iterations,
             one_linear_solve_seconds,
             start_residual,
             safeguarded,
             frozen,
             pivoted,
             moved,
             unstable,
             n_outer,
             note] = report;
      (void)failure;
      archive &converged &iterations &one_linear_solve_seconds &start_residual &safeguarded &frozen &pivoted
          &moved &unstable &n_outer &note;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, StoredSolve &solve, const unsigned int)
    {
      auto &[number, t, mesh, numbering, report, displacement, contact, nodes] = solve;
      archive &number &t &mesh &numbering &report &displacement &contact &nodes;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, StoredRun &run, const unsigned int)
    {
      auto &[id, scene, overrides, entries] = run;
      archive &id &scene &overrides &entries;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, StoredPart &part, const unsigned int)
    {
      archive &part.run &part.before &part.solves;
    }
  } // namespace serialization
} // namespace boost

namespace Amontons
{
  namespace
  {
    const std::string format = "amontons checkpoint 4 ";

    // The line before an object.
    std::string
    head_of(const std::string &body)
    {
      boost::crc_32_type crc;
      crc.process_bytes(body.data(), body.size());
      return format + version + " " + std::to_string(body.size()) + " " + std::to_string(crc.checksum());
    }
  } // namespace

  std::string
  describe_contents(const std::string &file)
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) // whoever reads it says so
      return "file " + file;
    boost::crc_32_type crc;
    std::ifstream      in(file, std::ios::binary);
    std::vector<char>  buffer(1u << 20);
    std::size_t        n_bytes = 0;
    while (in.read(buffer.data(), buffer.size()), in.gcount() > 0)
      {
        crc.process_bytes(buffer.data(), in.gcount());
        n_bytes += in.gcount();
      }
    return "file " + file + ": " + std::to_string(n_bytes) + " bytes, checksum " +
           std::to_string(crc.checksum());
  }

  template <typename T>
  void
  write_object(const std::string &name, const T &object)
  {
    std::ostringstream body;
    boost::archive::binary_oarchive(body, boost::archive::no_header) << object;
    const std::string text = body.str();
    write_file(name, head_of(text) + "\n" + text, true);
  }

  template <typename T>
  T
  read_object(const std::string &name)
  {
    std::ifstream in(name, std::ios::binary);
    std::string   head;
    std::getline(in, head);
    std::ostringstream rest;
    rest << in.rdbuf();
    const std::string text = rest.str();
    if (head.rfind(format, 0) != 0)
      throw InputError({name, 0, ""}, "not a file of a checkpoint", "the output folder of a run");
    if (head.rfind(format + version + " ", 0) != 0)
      throw InputError({name, 0, ""},
                       "written by another version, '" + head.substr(format.size()).substr(0, 20) + "'",
                       std::string("what version ") + version + " has written");
    if (head != head_of(text))
      throw InputError({name, 0, ""}, "damaged: its checksum differs", "the file as it was written");
    T                  object;
    std::istringstream body(text);
    boost::archive::binary_iarchive(body, boost::archive::no_header) >> object;
    return object;
  }

  template void
  write_object(const std::string &, const StoredRun &);
  template StoredRun
  read_object(const std::string &);
  template void
  write_object(const std::string &, const StoredMesh &);
  template StoredMesh
  read_object(const std::string &);
  template void
  write_object(const std::string &, const StoredPart &);
  template StoredPart
  read_object(const std::string &);
} // namespace Amontons
