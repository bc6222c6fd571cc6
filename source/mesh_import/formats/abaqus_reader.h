// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/abaqus.h"
#include "mesh_import/formats/abaqus_elements.h"
#include "mesh_import/formats/rigid_motion.h"

#include <memory>
#include <set>

namespace Signorini
{
  /// Reads the keywords that define a mesh, each by a function of its own; the registry in
  /// abaqus.cc maps keywords to functions.
  class AbaqusReader
  {
  public:
    /// @param file_name path of the file, which is opened at once; throws SceneError
    explicit AbaqusReader(const std::string &file_name);

    /// Read the whole file. May be called once.
    /// @return the mesh, which is moved out of the reader
    AbaqusDeck
    read();

  private:
    using Words   = std::vector<std::string>;
    using Members = std::vector<unsigned int>;

    /// Members of a set that are defined below it in the file, or nowhere.
    struct LateMembers
    {
      bool                     are_nodes;
      std::string              set;
      std::vector<std::string> words;
    };

    /// An element with nodes that are defined below it in the file, or nowhere.
    struct LateElement
    {
      unsigned int             index;
      AbaqusType               type;
      std::vector<std::size_t> nodes; ///< their numbers
    };

    /// A surface, whose elements and sets may be defined below it.
    struct LateSurface
    {
      std::string name, type;
      bool        is_union;
      std::string instance;

      /// Data lines with their positions in the file, for messages.
      std::vector<std::pair<Words, std::string>> lines;
    };

    /// An ADJUST of a contact pair: slave nodes that are moved onto a master surface. `of` is the
    /// name of a set of nodes, or a distance [length].
    struct Adjustment
    {
      std::string slave, master, of;
    };

    /// A range of names and numbers: the file or assembly, a part, or an instance.
    struct Scope
    {
      /// Nodes and elements; an instance shares those of the file.
      std::shared_ptr<MeshFile>    mesh;
      AbaqusSets                   nodes, elements;
      std::vector<MeshFile::Group> surfaces;

      std::vector<LateElement> late_elements;
      std::vector<LateMembers> late_members;
      std::vector<LateSurface> late_surfaces;

      /// The numbers of nodes by their indices.
      std::unordered_map<unsigned int, std::size_t> number_of;
    };

    // Nodes and elements
    void
    read_nodes();
    void
    add_node(std::size_t number, const dealii::Point<3> &place, AbaqusSet *set);
    dealii::Point<3>
    cartesian(dealii::Point<3> x, const std::string &system) const;
    void
    read_elements();
    void
    add_element(const AbaqusType               &type,
                const std::string              &type_name,
                const std::vector<std::size_t> &numbers,
                AbaqusSet                      *set);
    /// Add an element with the type of another one and other nodes.
    void
    copy_element(unsigned int like, std::size_t number, const MeshFile::Nodes &nodes);
    void
    read_system();

    // Sets and surfaces
    void
    read_node_set();
    void
    read_element_set();
    Members
    nodes_of(const std::string &element_set) const;
    void
    read_surface();
    void
    read_members(AbaqusSets &sets, const std::string &name, Members members);
    /// Complete the sets and surfaces that refer to what is defined below them, at the end of the
    /// scope.
    void
    complete_scope();
    void
    complete_elements();
    void
    complete_sets();
    MeshFile::Group
    completed(const LateSurface &late);
    void
    add_surface(const std::string &name, const std::string &place, MeshFile::Group &to) const;
    void
    add_faces(const std::string &of,
              const std::string &label,
              const std::string &place,
              MeshFile::Group   &surface);

    void
    read_element_loads();

    void
    read_adjustments();
    void
    adjust(const Adjustment &one);

    void
    read_section_of_bolt();
    void
    begin_step();
    void
    read_model_change();
    void
    remove_elements();
    void
    cut(const std::string &section);

    // Parts and instances
    void
    begin_part();
    void
    end_scope();
    void
    begin_instance();
    RigidMotion
    read_motion();
    void
    end_instance();

    // Nodes and elements made of others
    void
    generate_nodes();
    void
    fill_nodes();
    void
    copy_nodes();
    void
    generate_elements();
    void
    copy_elements();
    std::size_t
    node_number(unsigned int index) const;

    void
    refuse();
    AbaqusSet *
    set_of(const std::string &parameter, AbaqusSets &sets);
    const dealii::Point<3> &
    place_of(const std::string &word) const;
    void
    make_groups();
    void
    note_of_other_elements();

    static const std::map<std::string, void (AbaqusReader::*)(), IgnoringBlanks> registry;

    KeywordFile in;
    AbaqusDeck  deck;
    Scope       whole, instance;
    /// Parts by their names in upper case.
    std::map<std::string, Scope> parts;
    Scope                       *scope = &whole;
    std::string                  instance_name;
    /// One group for each instance, with its elements.
    std::vector<MeshFile::Group> instances;
    /// The coordinate system of *SYSTEM; null: the global one.
    std::unique_ptr<RigidMotion> system;
    std::vector<Adjustment>      adjustments;
    std::vector<std::string>     sections_of_bolts; ///< names of the surfaces
    unsigned int                 n_steps = 0;
    /// Numbers and sets of elements that are removed in the first step.
    Words removed;
    /// Whether elements are added, or removed later.
    bool                  changes_later = false;
    std::set<std::string> notes;
    unsigned int          n_element_loads = 0;
  };
} // namespace Signorini
