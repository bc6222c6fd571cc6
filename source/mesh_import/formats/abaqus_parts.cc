// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_reader.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/numbers.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// Add a number to all indices.
    void
    shift(Nodes &indices, const unsigned int by)
    {
      for (unsigned int &index : indices)
        index += by;
    }



    /// @return the same numbers and sets with indices that are larger by a number, for the copy of
    /// a part in an instance.
    AbaqusSets
    shifted(const AbaqusSets &sets, const unsigned int by)
    {
      AbaqusSets result;
      for (const auto &[number, index] : sets.numbers())
        result.insert(number, index + by);
      for (const auto &[name, set] : sets.all())
        {
          AbaqusSet &copy = result.get(set.name);
          copy.members    = set.members;
          shift(copy.members, by);
        }
      return result;
    }
  } // namespace



  // Keywords up to *END PART define a mesh of its own, whose numbers are independent of others.
  void
  AbaqusReader::begin_part()
  {
    const std::string name = upper_case(in.value("NAME"));
    if (name.empty())
      in.fail("*PART needs NAME=name");
    if (scope != &whole)
      in.fail("*PART stands within a part or an instance");
    if (parts.count(name) > 0)
      in.fail("the part '" + in.value("NAME") + "' is there twice");
    scope       = &parts[name];
    scope->mesh = std::make_shared<MeshFile>();
  }



  void
  AbaqusReader::end_scope()
  {
    complete_scope();
    scope = &whole;
    system.reset();
  }



  /// Data lines of *INSTANCE and *NCOPY: first a translation, then a rotation about an axis through
  /// two points, in degrees.
  RigidMotion
  AbaqusReader::read_motion()
  {
    RigidMotion  motion;
    unsigned int line = 0;
    for (Words words; in.next_line(words); ++line)
      {
        std::vector<double> values;
        for (const std::string &word : words)
          values.push_back(real_from(in, word));
        values.resize(std::max<std::size_t>(values.size(), line == 0 ? 3 : 7), 0.);
        const Point<3> a(values[0], values[1], values[2]);
        if (line == 0)
          motion = RigidMotion::translation(a);
        else if (line == 1)
          {
            const Point<3> b(values[3], values[4], values[5]);
            if (a == b)
              in.fail("the two points of the axis of rotation are the same");
            motion = motion.then(RigidMotion::about_axis(a, b, values[6] * numbers::PI / 180));
          }
        else
          in.fail("an instance has a translation and a rotation, no more");
      }
    return motion;
  }



  // An instance copies the mesh of its part with a rigid motion into the mesh of the file. Its sets
  // may be extended until *END INSTANCE.
  void
  AbaqusReader::begin_instance()
  {
    instance_name   = in.value("NAME");
    const auto part = parts.find(upper_case(in.value("PART")));
    if (instance_name.empty())
      in.fail("*INSTANCE needs NAME=name");
    if (part == parts.end())
      in.fail("*INSTANCE: there is no part '" + in.value("PART") + "' above");
    deck.instances_of[part->first].push_back(instance_name);
    const Scope       &of         = part->second;
    const RigidMotion  motion     = read_motion();
    MeshFile          &file       = *whole.mesh;
    const unsigned int first_node = file.nodes.size(), first_element = file.elements.size();
    // Numbers and sets of the part, with indices into the mesh of the file.
    instance = {whole.mesh,
                shifted(of.nodes, first_node),
                shifted(of.elements, first_element),
                {},
                {},
                {},
                {}};
    for (const Point<3> &node : of.mesh->nodes)
      file.nodes.push_back(motion(node));
    // The elements of the instance are a group of its name.
    MeshFile::Group all{instance_name, {}, {}, {}};
    for (MeshFile::Element element : of.mesh->elements)
      {
        shift(element.nodes, first_node);
        all.elements.push_back(file.elements.size());
        file.elements.push_back(element);
      }
    for (MeshFile::Group surface : of.surfaces)
      {
        shift(surface.nodes, first_node);
        for (Nodes &face : surface.faces)
          shift(face, first_node);
        instance.surfaces.push_back(surface);
      }
    instances.push_back(all);
    scope = &instance;
  }



  // Numbers and sets of the instance become known in the assembly as INSTANCE.NUMBER and
  // INSTANCE.NAME.
  void
  AbaqusReader::end_instance()
  {
    if (scope != &instance)
      in.fail("*END INSTANCE without *INSTANCE");
    complete_scope();
    if (!whole.nodes.add_instance(instance_name, instance.nodes) ||
        !whole.elements.add_instance(instance_name, instance.elements))
      in.fail("the instance '" + instance_name + "' is there twice");
    for (MeshFile::Group surface : instance.surfaces)
      {
        surface.name = instance_name + "." + surface.name;
        whole.surfaces.push_back(surface);
      }
    end_scope();
  }
} // namespace Signorini
