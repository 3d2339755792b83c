// All that is read before a scene is solved or a study runs, for tests/readers.py: reads lines "scene FILE",
// "study FILE" and "folder DIR" (to which the files are relative from there on), and answers each with
// "answer", "refusal N" and N bytes of what was said, or "error N" and those. What libraries print goes to
// stderr.
#include <amontons/geometry/geometry.h>
#include <amontons/run_parameters.h>
#include <amontons/scene/scene_reader.h>
#include <amontons/verification/comparison.h>
#include <amontons/verification/reference_solution.h>
#include <amontons/verification/run_study.h>
#include <amontons/verification/study_file.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <sstream>

using namespace Amontons;

template <int dim>
void
make_bodies(const Scene &scene)
{
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry, false);
  if (scene.reference)
    make_reference<dim>(scene);
}

void
read_scene_file(const std::string &file, const std::vector<std::string> &overrides)
{
  Parameters  parameters;
  const Scene scene =
      read_scene(file, overrides, parameters.groups(), {make_displacement_field, displacement_field_corners});
  scene.kind == ProblemType::three_dimensional ? make_bodies<3>(scene) : make_bodies<2>(scene);
}

void
read_study_file(const std::string &file)
{
  const StudyEntries entries(file);
  if (entries.kind == StudyKind::convergence)
    {
      const Study study = read_study(file);
      read_scene_file(study.scene, study.overrides);
    }
  else
    {
      const RunStudy study = read_run_study(entries);
      read_scene_file(study.scene, study.overrides);
    }
}

int
main(int argc, char **argv)
{
  const int answers = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const auto answer = [&](const std::string &text) {
    for (std::size_t written = 0; written < text.size();)
      {
        const ssize_t n = write(answers, text.data() + written, text.size() - written);
        if (n <= 0)
          std::exit(3);
        written += n;
      }
  };
  const auto answer_with = [&](const std::string &kind, const std::string &words) {
    answer(kind + " " + std::to_string(words.size()) + "\n" + words);
  };

  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  for (std::string line; std::getline(std::cin, line);)
    try
      {
        const auto        space = line.find(' ');
        const std::string file  = line.substr(space + 1);
        const std::string kind  = line.substr(0, space);
        if (kind == "folder")
          std::filesystem::current_path(file);
        else
          kind == "study" ? read_study_file(file) : read_scene_file(file, {});
        answer("answer\n");
      }
    catch (const InputError &error)
      {
        answer_with("refusal", error.what());
      }
    catch (const std::bad_alloc &)
      {
        answer_with("error", "out of memory");
      }
    catch (const std::exception &error)
      {
        answer_with("error", error.what());
      }
}
