#include <signorini/checkpoint/origin.h>
#include <signorini/checkpoint/sealed_file.h>
#include <signorini/parameters/raw.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    std::string
    file_in(const std::string &directory)
    {
      return directory + "/restart.scene";
    }
  } // namespace



  void
  write_origin(const std::string &directory, const Origin &origin)
  {
    const Json json = {{"name", origin.name}, {"folders", origin.folders}, {"scene", origin.scene}};
    write_sealed(file_in(directory) + ".part", json.dump());
    std::filesystem::rename(file_in(directory) + ".part", file_in(directory));
    sync_folder(directory);
  }



  Origin
  read_origin(const std::string &directory)
  {
    if (!std::filesystem::exists(file_in(directory)))
      throw SceneError("--restart " + directory +
                       ": no run has begun there, since there is no file restart.scene; give the "
                       "output directory of a run, or solve its scene from the start");
    try
      {
        const Json json = Json::parse(read_sealed(file_in(directory)));
        return {json.at("name"), json.at("scene"), json.at("folders")};
      }
    catch (const std::exception &error)
      {
        throw SceneError("--restart: " + std::string(error.what()) +
                         "; solve the scene from the start");
      }
  }



  void
  check_change(const std::string &assignment)
  {
    const std::string section = assignment.substr(0, assignment.find('/')),
                      key     = assignment.substr(0, assignment.find('='));
    if (section != "Newton" && section != "Solver" && section != "Output")
      throw SceneError(
        "--restart: --set " + key +
        " would change what is solved; only keys of Newton, Solver and Output may change half-way. "
        "Solve the scene from the start with it");
    if (key == "Output/Directory")
      throw SceneError("--restart: --set Output/Directory: the run goes on where it is; copy its "
                       "directory, and restart from the copy");
  }
} // namespace Signorini
