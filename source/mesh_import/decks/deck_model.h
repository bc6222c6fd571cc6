// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/abaqus.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
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
      std::string           law;               ///< of large deformation; empty: it is linear
      std::vector<double>   coefficients = {}; ///< of the law, as Material has them
    };

    struct SolidSection
    {
      std::string               material;
      std::vector<unsigned int> elements;
      std::vector<std::string>  sets;          ///< with these elements, as the mesh file calls them
      double                    thickness = 0; ///< of plane elements; 0: not given
    };

    struct Step
    {
      double begin, end;
      bool   is_constant = false; ///< AMPLITUDE=STEP: what has no amplitude acts from the beginning
    };

    struct Amplitude
    {
      Points points;
      bool   is_total = false; ///< counts the time of all steps, not that of the present one
    };

    /// What a step says of a value. Step 0 is the model before all steps.
    struct Change
    {
      enum class Kind
      {
        value,
        velocity, ///< the value grows by it in all steps from here on
        removed   ///< by OP=NEW, from the beginning of the step
      };

      unsigned int step;
      double       value;
      std::string  amplitude;
      Kind         kind = Kind::value;

      bool
      operator<(const Change &other) const
      {
        return std::tie(step, value, amplitude, kind) <
               std::tie(other.step, other.value, other.amplitude, other.kind);
      }
    };
    using Curve = std::vector<Change>;

    /// Straight lines between points, over the time of all steps.
    struct History
    {
      Points                                 points;
      std::vector<std::pair<double, double>> spans; ///< when it is prescribed, (begin, end]

      bool
      operator==(const History &other) const
      {
        return points == other.points && spans == other.spans;
      }
    };

    /// What a line of supports or forces is for. What holds at a node is in the maps by nodes,
    /// whatever set has named it.
    struct AtNodes
    {
      std::string               name;  ///< as the mesh file calls the node or set
      std::vector<unsigned int> nodes; ///< each once
      std::array<bool, 3>       components{{false, false, false}};
    };

    /// By node and component.
    using NodeCurves = std::map<std::pair<unsigned int, unsigned int>, Curve>;

    /// The corners of a face, sorted.
    using Face = MeshFile::Nodes;

    /// Forces per volume, or accelerations, on elements. Those of one card and of later ones that
    /// have the same target and direction are one load.
    struct BodyLoad
    {
      std::string               name; ///< as the deck calls the elements
      std::vector<unsigned int> elements;
      std::array<double, 3>     direction; ///< unit
      Curve                     size;
    };

    struct BodyForces
    {
      std::string               name;
      std::vector<unsigned int> elements;
      unsigned int              component;
    };

    /// Of nodes, with the amplitude; of a step.
    struct Temperatures
    {
      std::map<unsigned int, std::pair<double, std::string>> of_nodes;
      bool is_new = false; ///< OP=NEW: others go back to where they began
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

    /// A gap at the start that is not that of the mesh.
    struct Clearance
    {
      std::string slave, master;
      double      value;
    };

    /// Something that the scene will not have.
    struct Omission
    {
      std::string              kind; ///< see SkippedItem
      std::string              what;
      std::vector<std::string> places; ///< in the file
    };

    AbaqusDeck                       deck;
    std::string                      title;
    std::map<std::string, Material>  materials; ///< by names in upper case
    std::vector<SolidSection>        sections;
    std::map<std::string, Amplitude> amplitudes; ///< by names in upper case
    std::vector<Step>                steps;      ///< that are computed
    std::vector<AtNodes>     supported, loaded;  ///< nodes and sets, in the order of the deck
    NodeCurves               supports, forces;
    std::vector<std::string> pressed; ///< surfaces, in the order of the deck
    std::map<Face, Curve>    pressures;
    std::vector<BodyLoad>    gravity;
    std::vector<BodyForces>  forced;      ///< elements and sets, in the order of the deck
    NodeCurves               body_forces; ///< by element and component
    Temperatures             initial_temperatures;
    std::map<unsigned int, Temperatures> temperatures; ///< by step
    std::map<std::string, Interaction>   interactions; ///< by names in upper case
    std::vector<Pair>                    pairs;
    std::vector<Clearance>               clearances;
    std::string                          nlgeom; ///< where it is first asked for; empty: nowhere

    /// Something was left out that may have held a body.
    bool lacks_supports = false;

    std::vector<Omission> skipped_items;

    /// @param what may begin with *KEYWORD, which says the kind
    /// @param kind empty: that of the keyword
    void
    skip_item(const std::string &what, const std::string &place, const std::string &kind = "");

    /// The value over the time of all steps, as CalculiX follows it: without amplitude, a step goes
    /// from the last value to the new one along a line; what an amplitude has come to stays in
    /// later steps, if it does not count the time of all. What is given in step 0 is there at the
    /// start, with `is_initial`, or reached in step 1.
    History
    history(const Curve &curve, bool is_initial = false) const;

    /// The faces of a surface, sorted; none of a set of nodes.
    std::set<Face>
    faces_of(const std::string &surface) const;
  };

  /// Read a deck with its model. Throws SceneError with file and line.
  DeckModel
  read_deck_model(const std::string &file_name);
} // namespace Signorini
