#include <amontons/output/output_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <regex>
#include <vector>

namespace Amontons
{
  namespace
  {
    namespace fs = std::filesystem;

    const char *const set_aside = "earlier_run", *const unfinished = "unfinished_run",
                      *const being_set_aside = "earlier_run.tmp";

    struct OutputFolder
    {
      fs::path              folder; // empty: none
      bool                  goes_on = false;
      std::string           aside;       // where what was there is now; empty: nothing was
      std::vector<fs::path> new_folders; // from the outermost one to this one; none if it was there
      int                   lock = -1;   // rank 0
    };

    OutputFolder &
    present()
    {
      static OutputFolder one;
      return one;
    }

    // goes_on: without those that a run that goes on needs, or continues.
    std::vector<fs::path>
    files_of_a_run(const fs::path &folder, const bool goes_on = false)
    {
      static const std::regex names("((summary|progress)\\.json|history\\.csv|report\\.html|amontons\\.log|"
                                    "checkpoint|(bodies|contact)(_[0-9]{4,}(\\.[0-9]+)?)?\\."
                                    "(vtu|pvtu|pvd|csv))(\\.tmp)?");
      std::vector<fs::path>   files;
      std::error_code         error;
      for (const auto &entry : fs::directory_iterator(folder, error))
        if (const std::string name = entry.path().filename().string();
            std::regex_match(name, names) && !(goes_on && (name == "checkpoint" || name == "amontons.log")))
          files.push_back(entry.path());
      return files;
    }

    void
    move_into(const std::vector<fs::path> &files, const fs::path &folder)
    {
      std::error_code error;
      for (const auto &file : files)
        {
          fs::remove_all(folder / file.filename(), error);
          fs::rename(file, folder / file.filename(), error);
        }
    }

    void
    remove_files(const std::vector<fs::path> &files)
    {
      std::error_code error;
      for (const auto &file : files)
        fs::remove_all(file, error);
    }

    // Into a folder of another name first: what stands under its own is complete. Returns its own, or nothing
    // where there was no file. A run that goes on may write fewer files, or others, than it has.
    std::string
    set_earlier_run_aside(const fs::path &folder, const bool goes_on)
    {
      fs::path        aside = folder / set_aside;
      const fs::path  tmp   = folder / being_set_aside;
      std::error_code error;
      for (const auto &path : {aside, tmp, folder / unfinished})
        if (fs::is_symlink(path, error))
          fs::remove(path, error);
      if (fs::exists(tmp, error)) // that was interrupted
        {
          move_into(files_of_a_run(tmp), folder);
          fs::remove_all(tmp, error);
        }
      const auto files = files_of_a_run(folder, goes_on);
      if (files.empty())
        return "";
      if (fs::exists(aside / "summary.json", error) &&
          (goes_on || !fs::exists(folder / "summary.json", error)))
        aside = folder / unfinished;
      fs::create_directory(tmp, error);
      move_into(files, tmp);
      fs::remove_all(aside, error);
      fs::rename(tmp, aside, error);
      return aside.string();
    }

    // Empty if it is ours now; else who has it. The kernel frees it when its process ends, however.
    std::string
    lock_folder(const fs::path &folder, int &lock)
    {
      const std::string name = (folder / ".lock").string();
      for (;;)
        {
          lock = open(name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
          if (lock < 0)
            return "a file '.lock' that cannot be opened";
          if (flock(lock, LOCK_EX | LOCK_NB) != 0)
            {
              if (errno != EWOULDBLOCK) // no locks in this file system
                return "";
              std::string   who;
              std::ifstream in(name);
              std::getline(in, who);
              close(lock);
              lock = -1;
              return "another run, " + (who.empty() ? "which has just started" : who);
            }
          // Whoever had it before may have removed the file in between.
          struct stat ours = {}, there = {};
          if (fstat(lock, &ours) == 0 && stat(name.c_str(), &there) == 0 && ours.st_ino == there.st_ino)
            break;
          close(lock);
        }
      char host[256] = "";
      gethostname(host, sizeof(host) - 1);
      const std::string text = "process " + std::to_string(getpid()) + " on " + host + "\n";
      if (ftruncate(lock, 0) != 0 || write(lock, text.data(), text.size()) < 0)
        return ""; // a full disk: it is ours all the same
      return "";
    }

    void
    unlock()
    {
      OutputFolder &one = present();
      if (one.lock >= 0)
        {
          unlink((one.folder / ".lock").c_str());
          close(one.lock);
        }
      one = OutputFolder();
    }

    // What is wrong with a folder, for a message; empty if nothing is.
    struct Complaint
    {
      std::string text;
      bool        is_of_another = false; // the folder belongs to another run

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &text &is_of_another;
      }
    };

    // Rank 0.
    Complaint
    prepare(const fs::path &folder, const bool goes_on, int &lock, std::string &aside)
    {
      std::error_code error;
      fs::create_directories(folder, error);
      const fs::path trial = folder / ".amontons_write_test";
      const bool     good  = std::ofstream(trial).put('\n').flush().good();
      fs::remove(trial, error);
      if (!good)
        return {"this folder cannot be made or written to"};
      if (const std::string other = lock_folder(folder, lock); !other.empty())
        return {"this folder is in use by " + other, true};
      aside = set_earlier_run_aside(folder, goes_on);
      return {};
    }
  } // namespace

  void
  make_output_folder(const std::string &folder, const MPI_Comm communicator, const bool goes_on)
  {
    OutputFolder &one = present();
    if (one.folder == folder)
      return;
    one         = OutputFolder();
    one.folder  = folder;
    one.goes_on = goes_on;
    // Rank 0 says how many folders are new; then every rank can remove them.
    std::vector<fs::path> path;
    for (auto part = one.folder.lexically_normal(); !part.empty() && part != part.root_path();
         part      = part.parent_path())
      if (part.has_filename())
        path.insert(path.begin(), part);
    unsigned int n_new = 0;
    Complaint    wrong;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        for (const auto &part : path)
          n_new += fs::exists(part, error) ? 0 : 1;
        wrong = prepare(one.folder, goes_on, one.lock, one.aside);
      }
    n_new     = dealii::Utilities::MPI::broadcast(communicator, n_new);
    wrong     = dealii::Utilities::MPI::broadcast(communicator, wrong);
    one.aside = dealii::Utilities::MPI::broadcast(communicator, one.aside);
    one.new_folders.assign(path.end() - n_new, path.end());
    if (wrong.text.empty())
      return;
    if (one.new_folders.empty() || wrong.is_of_another)
      one = OutputFolder(); // not ours
    throw InputError({"", 0, "--output " + folder},
                     wrong.text,
                     "a folder that you may write to, with space, and one run in it");
  }

  void
  keep_output_folder(const bool has_ended)
  {
    OutputFolder   &one = present();
    std::error_code error;
    if (one.lock >= 0 && has_ended) // rank 0
      for (const char *const name : {set_aside, unfinished})
        fs::remove_all(one.folder / name, error);
    unlock();
  }

  void
  remove_later_files(const std::string &folder,
                     const std::string &name,
                     const std::string &extension,
                     const unsigned int first)
  {
    const std::regex      pattern(name + "_([0-9]{4,9})(\\.[0-9]+)?\\." + extension);
    std::vector<fs::path> files;
    std::error_code       error;
    for (const auto &entry : fs::directory_iterator(folder, error))
      {
        const std::string file = entry.path().filename().string();
        std::smatch       parts;
        if (std::regex_match(file, parts, pattern) && std::stoul(parts[1]) >= first)
          files.push_back(entry.path());
      }
    remove_files(files);
  }

  void
  remove_new_output_folder()
  {
    OutputFolder   &one = present();
    std::error_code error;
    if (one.folder.empty())
      return;
    if (fs::exists(one.folder / "history.csv", error) ||
        (!one.goes_on && fs::exists(one.folder / "checkpoint", error)))
      return unlock();
    // Of a run that never ended the later one.
    std::vector<fs::path> asides = {one.folder / unfinished, one.folder / set_aside};
    if (one.goes_on)
      asides = {one.aside};
    if (!one.new_folders.empty())
      fs::remove_all(one.new_folders.back(), error);
    else
      for (const fs::path &aside : asides)
        if (fs::exists(aside, error))
          {
            remove_files(files_of_a_run(one.folder, one.goes_on));
            move_into(files_of_a_run(aside), one.folder);
            fs::remove(aside, error);
            break;
          }
    for (auto folder = one.new_folders.rbegin(); folder != one.new_folders.rend(); ++folder)
      fs::remove(*folder, error); // only an empty one
    unlock();
  }
} // namespace Amontons
