// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/geometry/coarse_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A way to make the mesh of a body: one file pair under mesh/generators and one line in the
  /// registry.
  template <int dim>
  class MeshGenerator
  {
  public:
    virtual ~MeshGenerator() = default;

    /// The keys of this generator, beside `Mesh`, in the body's section.
    virtual void
    declare(Section &section) = 0;

    /// Read what is in a file: after declare(), before all else. Throws SceneError.
    /// @param folder in which the file is looked for after the present one
    /// @return notes for the user
    virtual std::vector<std::string>
    read_file([[maybe_unused]] const std::string &folder)
    {
      return {};
    }

    /// Names of the boundaries, known before any mesh is made.
    virtual std::vector<std::string>
    boundaries() const = 0;

    virtual CoarseMesh<dim>
    generate() const = 0;

    /// How often cells can be merged, 2^dim at a time, so that as many refinements make the mesh of
    /// generate() again. Few coarse cells are worth much: each rank holds all of them, and the
    /// multigrid method goes down to them.
    virtual unsigned int
    possible_merges() const
    {
      return 0;
    }

    /// What is to be refined as often. @param merges at most possible_merges()
    virtual CoarseMesh<dim>
    generate_merged([[maybe_unused]] const unsigned int merges) const
    {
      return generate();
    }

    /// Names of the sets of nodes.
    virtual std::vector<std::string>
    node_sets() const
    {
      return {};
    }

    /// The nodes of such a set, on the coarse mesh of generate().
    virtual NodeSet<dim>
    node_set(const std::string & /*name*/) const
    {
      return {};
    }

    /// Names of the sets of cells.
    virtual std::vector<std::string>
    cell_sets() const
    {
      return {};
    }

    /// The cells of such a set, of the coarse mesh of generate().
    virtual std::vector<unsigned int>
    cell_set(const std::string & /*name*/) const
    {
      return {};
    }

    /// Why the mesh can be used only if a contact pair joins two boundaries of this body; empty if
    /// it can be used anyhow.
    virtual std::string
    needs_pair() const
    {
      return "";
    }
    /// Does the mesh come with a temperature? Known before the file is read.
    virtual bool
    has_temperature() const
    {
      return false;
    }

    /// A temperature at the vertices of generate(); empty if the mesh comes without one.
    virtual const std::vector<double> &
    temperature() const;

    /// True if the scene should be run with curved cells (a geometry of degree two or more).
    virtual bool
    curved() const = 0;

    /// `name` is one of generator_names<dim>().
    static std::unique_ptr<MeshGenerator<dim>>
    create(const std::string &name);
  };

  template <int dim>
  std::vector<std::string>
  generator_names();
} // namespace Signorini
