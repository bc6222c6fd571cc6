#pragma once

#include <signorini/mesh/formats/abaqus.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /// What a deck says beyond its mesh, as far as the program can compute it.
  struct DeckModel
  {
    using Points = std::vector<std::pair<double, double>>; ///< time and value

    struct Material
    {
      std::string           name;
      std::optional<double> youngs_modulus, poissons_ratio, density, expansion;
    };

    struct SolidSection
    {
      std::string               material;
      std::vector<unsigned int> elements;
      double                    thickness = 0; ///< of plane elements; 0: not given
    };

    struct Step
    {
      double begin, end;
    };

    /// A value that is set by steps. Step 0 is the model before all steps.
    struct Change
    {
      unsigned int step;
      double       value;
      std::string  amplitude;
    };
    using Curve = std::vector<Change>;

    /// What is prescribed at a node or set of nodes, component by component; empty: nothing.
    struct AtNodes
    {
      std::string               target; ///< as the mesh file calls it
      std::vector<unsigned int> nodes;
      std::array<Curve, 3>      components;
    };

    /// A pressure on a surface, or a body force per mass on elements.
    struct FaceLoad
    {
      std::string surface;
      Curve       pressure;
    };

    struct BodyLoad
    {
      std::vector<unsigned int> elements;
      std::array<double, 3>     direction;
      bool                      is_gravity; ///< times the density
      Curve                     size;
    };

    struct Temperatures
    {
      std::map<unsigned int, double> of_nodes;
      std::string                    amplitude;
    };

    struct Interaction
    {
      enum class Kind
      {
        hard,
        linear,
        tied
      };

      Kind   kind      = Kind::hard;
      double stiffness = 0; ///< of a linear one
    };

    struct Pair
    {
      std::string slave, master, interaction;
    };

    AbaqusDeck                      deck;
    std::string                     title;
    std::map<std::string, Material> materials; ///< by names in upper case
    std::vector<SolidSection>       sections;
    std::map<std::string, Points>   amplitudes; ///< by names in upper case, in time of the step
    std::vector<Step>               steps;      ///< that are computed
    std::vector<AtNodes>            supports, forces;
    std::vector<FaceLoad>           pressures;
    std::vector<BodyLoad>           body_loads;
    std::map<unsigned int, double>  initial_temperatures; ///< of nodes
    std::map<unsigned int, Temperatures> temperatures;    ///< by step
    std::map<std::string, Interaction>   interactions;    ///< by names in upper case
    std::vector<Pair>                    pairs;

    /// Something was left out that may have held a body.
    bool lacks_restraint = false;

    /// What was left out, each with its places in the file.
    std::vector<std::pair<std::string, std::vector<std::string>>> left_out;

    void
    leave_out(const std::string &what, const std::string &place);

    /// The value over the time of all steps: straight lines between these points.
    Points
    history(const Curve &curve) const;
  };

  /// Read a deck with its model. Throws SceneError with file and line.
  DeckModel
  read_deck_model(const std::string &file_name);
} // namespace Signorini
