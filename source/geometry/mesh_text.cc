#include <amontons/base/text_file.h>
#include <amontons/geometry/grid_reader.h>
#include <amontons/geometry/mesh_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace Amontons
{
  using namespace dealii;

  std::string
  file_ending(const std::string &file)
  {
    std::string result = std::filesystem::path(file).extension().string();
    for (char &c : result)
      c = std::tolower(static_cast<unsigned char>(c));
    return result;
  }

  namespace
  {
    bool
    read_text(const std::string &file, std::string &text)
    {
      std::ifstream in(file, std::ios::binary);
      if (!in || std::filesystem::is_directory(file))
        return false;
      std::ostringstream content;
      content << in.rdbuf();
      text = content.str();
      return true;
    }

    std::string
    quoted(const std::string &word)
    {
      std::string result = "'";
      for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
      return result + "'";
    }

    // What gmsh says first of an error; with nothing of the kind, its first words.
    std::string
    first_error(const std::string &messages)
    {
      constexpr std::size_t most = 300;
      std::istringstream    lines(messages);
      std::string           first;
      for (std::string line; std::getline(lines, line);)
        {
          if (line.find("Error   :") != std::string::npos)
            return line.substr(0, most);
          if (first.empty())
            first = line.substr(0, most);
        }
      return first.empty() ? "no message" : first;
    }

    // The mesh that gmsh writes with the given options. gmsh runs without the environment of mpirun, since an
    // MPI program started by an MPI program would take itself for one of its ranks.
    std::string
    run_gmsh(const std::string &file, const std::string &options, const SourceLocation &where)
    {
      std::string folder = (std::filesystem::temp_directory_path() / "amontons-XXXXXX").string();
      if (mkdtemp(folder.data()) == nullptr)
        throw InputError(where, "cannot make a temporary folder " + folder);

      constexpr int     seconds = 60, timed_out = 124;
      const std::string mesh = folder + "/mesh.msh", log = folder + "/log";
      const std::string command =
          "env -i PATH=\"$PATH\" HOME=\"$HOME\" LD_LIBRARY_PATH=\"$LD_LIBRARY_PATH\" timeout -k 1 " +
          std::to_string(seconds) + " gmsh " + quoted(file) + " " + options + " -o " + quoted(mesh) +
          " -format msh22 -string 'Mesh.Binary = 0;' -v 2 > " + quoted(log) + " 2>&1 < /dev/null";
      const int   status = std::system(command.c_str());
      std::string text, messages;
      const bool  found = read_text(mesh, text);
      read_text(log, messages);
      std::filesystem::remove_all(folder);

      if (WIFEXITED(status) && WEXITSTATUS(status) == timed_out)
        throw InputError(where,
                         "gmsh did not mesh " + file + " within " + std::to_string(seconds) + " seconds",
                         "a mesh file of it (.msh), made with patience");
      if (status != 0 || !found || text.empty())
        throw InputError(where,
                         "gmsh made no mesh of " + file + ": " + first_error(messages),
                         "a .geo file that 'gmsh " + options + "' can mesh (is gmsh installed?)");
      return text;
    }

    // On one rank. Binary .msh files go through gmsh, too.
    std::string
    read_file(const BodyData &body, const unsigned int dim)
    {
      const std::string file = body.mesh_file, type = file_ending(file);
      if (type != ".msh" && type != ".geo" && type != ".inp")
        throw InputError(
            body.where, "the mesh file " + file + " is of an unknown kind", ".msh, .geo or .inp");

      constexpr std::size_t most = std::size_t(1) << 30;
      std::string text = read_text_file(file, body.where, "the mesh file", "a file that exists", most);
      if (type == ".geo")
        return run_gmsh(file, "-" + std::to_string(dim), body.where);
      if (type == ".msh" && (text.compare(0, 18, "$MeshFormat\n4.1 1 ") == 0 ||
                             text.compare(0, 18, "$MeshFormat\n2.2 1 ") == 0))
        return run_gmsh(file, "-save", body.where);
      return text;
    }
  } // namespace

  std::string
  read_mesh_text(const BodyData &body, const unsigned int dim, MPI_Comm communicator)
  {
    std::pair<bool, std::string> result(true, ""); // text of the mesh, or of the error
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          result.second = read_file(body, dim);
        }
      catch (const InputError &e)
        {
          result = {false, e.what()};
        }
    result = Utilities::MPI::broadcast(communicator, result, 0);
    if (!result.first)
      throw InputError({}, result.second);
    return result.second;
  }
} // namespace Amontons
