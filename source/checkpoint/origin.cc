// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/origin.h"

#include "checkpoint/sealed_file.h"
#include "mesh/generators/file.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// @return the path of the file in a directory.
    std::string
    file_in(const std::string &directory)
    {
      return directory + "/restart.scene";
    }

    /// @return the checksum of a file. Throws SceneError if it cannot be read.
    std::uint32_t
    checksum_of_file(const std::string &path)
    {
      std::ifstream      file(path, std::ios::binary);
      std::ostringstream content;
      content << file.rdbuf();
      if (!file)
        throw SceneError("file '" + path + "' cannot be read");
      return checksum(content.str());
    }

    /// Add the checksums of all files that keys `File` of a section and its subsections name.
    void
    add_files(const RawSection &section, std::map<std::string, std::uint32_t> &files)
    {
      if (const auto *file = section.find_value("File"); file && !file->text.empty())
        files[file->text] = checksum_of_file(file->text);
      for (const RawSection &one : section.sections)
        add_files(one, files);
    }

    /// Throw SceneError: the run cannot be restarted.
    [[noreturn]] void
    refuse(const std::string &why)
    {
      throw SceneError("--restart: " + why + "; solve the scene from the start");
    }
  } // namespace



  Origin
  origin_of(const std::string &name, const std::string &scene)
  {
    Origin             result{name, scene, {}, 0, 0.};
    std::istringstream text(scene);
    add_files(read_raw(text, name), result.files);
    return result;
  }



  void
  write_origin(const std::string &directory, const Origin &origin)
  {
    const Json json = {{"name", origin.name},
                       {"files", origin.files},
                       {"scene", origin.scene},
                       {"continues", origin.continues},
                       {"begin", origin.begin}};
    write_sealed(file_in(directory) + ".part", json.dump());
    std::filesystem::rename(file_in(directory) + ".part", file_in(directory));
    sync_folder(directory);
  }



  // The files that the scene names must be those with which the run was started.
  Origin
  read_origin(const std::string &directory)
  {
    if (!std::filesystem::exists(file_in(directory)))
      throw SceneError("--restart " + directory +
                       ": the directory has no file restart.scene; give the output directory of a "
                       "run, or solve its scene from the start");
    Origin result;
    try
      {
        const Json json = Json::parse(read_sealed(file_in(directory)));
        result          = {json.at("name"),
                           json.at("scene"),
                           json.at("files"),
                           json.value("continues", std::uint32_t(0)),
                           json.value("begin", 0.)};
      }
    catch (const std::exception &error)
      {
        refuse(error.what());
      }
    for (const auto &[path, sum] : result.files)
      if (!file_exists(path) || checksum_of_file(path) != sum)
        throw SceneError("--restart: file '" + path + "' " +
                         (file_exists(path) ? "has changed since the run began" : "is gone") +
                         "; restore it, or solve the scene from the start");
    return result;
  }



  std::uint32_t
  checksum_of_origin(const std::string &directory)
  {
    return checksum_of_file(file_in(directory));
  }



  namespace
  {
    /// True if a text ends with another one.
    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
    }
  } // namespace



  bool
  is_of_further_steps(const std::string &assignment)
  {
    const std::string section = assignment.substr(0, assignment.find('/')),
                      key     = trim(assignment.substr(0, assignment.find('=')));
    return section == "Loads" || section == "Supports" || section == "Load steps" ||
           (section == "Contact pairs" &&
            (ends_with(key, "/Start time") || ends_with(key, "/End time")));
  }



  void
  check_change(const std::string &assignment, const bool is_finished)
  {
    const std::string section = assignment.substr(0, assignment.find('/')),
                      key     = trim(assignment.substr(0, assignment.find('=')));
    if (section != "Newton" && section != "Solver" && section != "Output" &&
        key != "Load steps/Cut-backs" && !(is_finished && is_of_further_steps(assignment)))
      refuse("--set " + key +
             " would change the problem; a restart may change only keys of Newton, Solver and "
             "Output, and Load steps/Cut-backs; after a finished run also Loads, Supports, Load "
             "steps, and times of Contact pairs");
    if (key == "Output/Directory")
      throw SceneError(
        "--restart: --set Output/Directory is not possible, because a restarted run "
        "continues in its own directory; copy the directory, and restart from the copy");
  }
} // namespace Signorini
