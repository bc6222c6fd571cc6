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
  /// The model that an input file of Abaqus or CalculiX describes beyond its mesh, as far as the
  /// program can compute it. Units are those of the file.
  struct DeckModel
  {
    /// Polygon of pairs of time and value.
    using Points = std::vector<std::pair<double, double>>;

    /// An elastic material.
    struct Material
    {
      std::string           name;
      std::optional<double> youngs_modulus, poissons_ratio, density, expansion;
      /// Constitutive law at finite strain, as the scene names it; empty: linear elasticity.
      std::string law;
      /// Coefficients of the law, in the order of Material.
      std::vector<double> coefficients = {};
    };

    /// The elements that have a material.
    struct SolidSection
    {
      std::string               material;
      std::vector<unsigned int> elements;
      /// Sets that have these elements, by their names in the mesh file.
      std::vector<std::string> sets;
      /// Thickness [length] of plane elements; 0: not given.
      double thickness = 0;
    };

    /// A load step that is computed.
    struct Step
    {
      double begin, end;
      /// AMPLITUDE=STEP: values without amplitude act in full from the beginning.
      bool is_constant = false;
    };

    /// A factor over time.
    struct Amplitude
    {
      Points points;
      /// Times are those of the whole analysis, not of the present step.
      bool is_total = false;
    };

    /// The change of a value in a step. Step 0 is the model before all steps.
    struct Change
    {
      enum class Kind
      {
        value,
        /// The value grows with this rate in all steps from here on.
        velocity,
        /// OP=NEW removes the value at the beginning of the step.
        removed
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

    /// The history of a value over the time of all steps, linear between points.
    struct History
    {
      Points points;
      /// Intervals (begin, end] of time in which the value is prescribed.
      std::vector<std::pair<double, double>> spans;

      bool
      operator==(const History &other) const
      {
        return points == other.points && spans == other.spans;
      }
    };

    /// The axes of a *TRANSFORM: cylindrical, with two points of the axis; or rotated, with a
    /// vector along x' and one in the plane of x' and y'.
    struct Axes
    {
      bool                  is_cylindrical;
      std::array<double, 3> first, second;
    };

    /// A node or set with supports or forces. Their values are in the maps by node, whatever set
    /// has named the node.
    struct AtNodes
    {
      /// Name of the node or set in the mesh file.
      std::string name;
      /// Indices of the nodes, each once.
      std::vector<unsigned int> nodes;
      std::array<bool, 3>       components{{false, false, false}};
      /// Index of the axes to which the components refer; none: the global ones.
      std::optional<unsigned int> axes = {};
    };

    /// Curves by index of node (or element) and component (0, 1, 2); 3, 4, 5 are rotations and
    /// moments at reference nodes of couplings.
    using NodeCurves = std::map<std::pair<unsigned int, unsigned int>, Curve>;

    /// The corners of a face, sorted.
    using Face = MeshFile::Nodes;

    /// Gravity on elements, or the centrifugal load of a rotation. Lines of one card and of later
    /// ones with the same target and direction are one load.
    struct BodyLoad
    {
      /// Name of the elements in the deck.
      std::string               name;
      std::vector<unsigned int> elements;
      /// Unit vector, along the axis of a rotation.
      std::array<double, 3> direction;
      Curve                 size; ///< acceleration, or square of the angular velocity
      /// A point of the axis; none: gravity.
      std::optional<std::array<double, 3>> center = {};
    };

    /// Elements with forces per volume along an axis; the values are in `body_forces`.
    struct BodyForces
    {
      std::string               name;
      std::vector<unsigned int> elements;
      unsigned int              component;
    };

    /// The temperatures of nodes in a step, each with the name of its amplitude.
    struct Temperatures
    {
      std::map<unsigned int, std::pair<double, std::string>> of_nodes;
      /// OP=NEW: all other nodes return to their initial temperatures.
      bool is_new = false;
    };

    /// The contact law of a *SURFACE INTERACTION: its relation of pressure and overclosure, whether
    /// surfaces separate or are tied, and its friction.
    struct Interaction
    {
      enum class Kind
      {
        separates,
        never_separates,
        tied
      };

      Kind kind = Kind::separates;
      /// Keys of the scene, and their values, for the relation of pressure and overclosure; none:
      /// hard.
      std::vector<std::pair<std::string, std::string>> overclosure;
      /// Shear stress per slip of surfaces that stick; 0: none given.
      double stick_slope = 0;
      /// Coefficient of friction, a number or a formula in the pressure; empty: none.
      std::string friction;
      /// Largest shear stress of friction; 0: none given.
      double shear_limit = 0;
      /// The time from which another interaction takes its place, and the name of that.
      std::optional<std::pair<double, std::string>> successor = {};
    };

    /// Cyclic symmetry: the number of sectors, and two points of the axis.
    struct Sectors
    {
      double                number;
      std::array<double, 3> first, second;
    };

    /// A contact pair, by the names of its surfaces and of its interaction.
    struct Pair
    {
      std::string slave, master, interaction;
      /// Largest distance of surfaces that are tied; 0: none given.
      double farthest;
      /// Name of a *TIE with CYCLIC SYMMETRY.
      std::optional<std::string> cyclic_tie = {};
      std::optional<Sectors>     sectors    = {};
      /// Times at which *MODEL CHANGE removes and adds the pair, in turn.
      std::vector<double> changes = {};

      /// True if the pair was removed and not added again.
      bool
      is_removed() const
      {
        return changes.size() % 2 == 1;
      }
    };

    /// Nodes that follow a reference node rigidly, or share its force and moment.
    struct Coupling
    {
      /// Name of the set or surface of the nodes, and the keyword, for messages.
      std::string name, keyword;
      bool        is_surface = false, is_distributing = false;
      /// The *ORIENTATION to which components refer; none: the global axes.
      std::optional<Axes> axes = {};
      /// Indices of the nodes; none for surfaces.
      std::vector<unsigned int> nodes;
      /// Name of an analytical surface that is the rigid body; empty: none.
      std::string analytical_surface = {};
      /// Index of the reference node.
      unsigned int reference = 0;
      /// Index of the node whose components are the rotation; none: those are components 4 to 6 of
      /// the reference node.
      std::optional<unsigned int> rotation;
      std::array<bool, 3>         components{{true, true, true}};
    };

    /// A rigid surface that is given by a profile: the keys of an obstacle.
    using AnalyticalSurface = std::vector<std::pair<std::string, std::string>>;

    /// A factor times a component (0, 1, 2) of the displacement of a node.
    struct EquationTerm
    {
      unsigned int node, component;
      double       factor;
    };
    /// Terms whose sum is zero.
    using Equation = std::vector<EquationTerm>;

    /// A section through a bolt with a pretension. Component 1 of the reference node has the
    /// tension as force and the shortening as motion.
    struct PretensionSection
    {
      std::string  surface;
      unsigned int reference;
      /// The direction that the deck gives; zero: none.
      std::array<double, 3> direction;
      /// The time from which the shortening is kept.
      std::optional<double> lock_time = {};
    };

    /// An initial gap [length] that is prescribed instead of that of the mesh.
    struct Clearance
    {
      std::string slave, master;
      double      value;
    };

    /// Something in the deck that the scene does not contain.
    struct Omission
    {
      std::string kind; ///< see SkippedItem
      std::string what;
      /// Positions in the file.
      std::vector<std::string> places;
    };

    AbaqusDeck  deck;
    std::string title;
    /// Materials by names in upper case.
    std::map<std::string, Material> materials;
    std::vector<SolidSection>       sections;
    /// Axes of *ORIENTATION, by names in upper case.
    std::map<std::string, Axes> orientations;
    /// Axes of *TRANSFORM, and the index of those of each node.
    std::vector<Axes>                    axes;
    std::map<unsigned int, unsigned int> axes_of_nodes;
    /// Amplitudes by names in upper case.
    std::map<std::string, Amplitude> amplitudes;
    /// The steps that are computed, in sequence.
    std::vector<Step> steps;
    /// Nodes and sets with supports and with forces, in the order of the deck.
    std::vector<AtNodes> supported, loaded;
    NodeCurves           supports, forces;
    /// Surfaces with pressures, in the order of the deck.
    std::vector<std::string> pressed;
    std::map<Face, Curve>    pressures;
    std::vector<BodyLoad>    gravity;
    /// Elements and sets with forces per volume, in the order of the deck.
    std::vector<BodyForces> forced;
    /// Forces per volume by element and component.
    NodeCurves   body_forces;
    Temperatures initial_temperatures;
    /// Temperatures by step.
    std::map<unsigned int, Temperatures> temperatures;
    /// Interactions by names in upper case.
    std::map<std::string, Interaction> interactions;
    std::vector<Pair>                  pairs;
    std::vector<Clearance>             clearances;
    std::vector<Coupling>              couplings;
    /// By names in upper case.
    std::map<std::string, AnalyticalSurface> analytical_surfaces;
    std::vector<PretensionSection>           pretensions;
    std::vector<Equation>                    equations;
    /// Whether some of the equations are linearisations of nonlinear ones, in global components.
    bool has_linearised_equations = false;
    /// Position in the file where geometric nonlinearity is first requested; empty: nowhere.
    std::string nlgeom;

    /// Whether something was skipped that may have constrained a body.
    bool lacks_supports = false;

    std::vector<Omission> skipped_items;

    /// Record something that the scene will not contain.
    /// @param what a text, which may begin with *KEYWORD
    /// @param place position in the file; empty: none
    /// @param kind see SkippedItem; empty: the kind of the keyword
    void
    skip_item(const std::string &what, const std::string &place, const std::string &kind = "");

    /// @return the value over the time of all steps, by the rules of CalculiX: without amplitude, a
    /// step ramps it from the last value to the new one; the final value of an amplitude is kept in
    /// later steps, unless the amplitude refers to total time.
    /// @param curve the changes of the value
    /// @param is_initial whether a value of step 0 is present at the start; otherwise it is reached
    /// in step 1
    History
    history(const Curve &curve, bool is_initial = false) const;

    /// @return whether a node is the reference node of a coupling or pretension, or has the
    /// rotation of a coupling.
    /// @param node its index
    bool
    is_reference(unsigned int node) const;

    /// @return the nodes of a coupling.
    /// @param coupling one of the model
    std::vector<unsigned int>
    nodes_of(const Coupling &coupling) const;

    /// @return the faces of a surface, each as sorted corners; none for a set of nodes.
    /// @param surface its name in any case
    std::set<Face>
    faces_of(const std::string &surface) const;
  };

  /// Read a deck with its model. Throws SceneError with file and line.
  /// @param file_name path of the file
  /// @return mesh and model
  DeckModel
  read_deck_model(const std::string &file_name);
} // namespace Signorini
