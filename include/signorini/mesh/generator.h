// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/geometry/coarse_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Base class of mesh generators of bodies. A new generator is one pair of files in
  /// mesh/generators and one line in the registry.
  template <int dim>
  class MeshGenerator
  {
  public:
    virtual ~MeshGenerator() = default;

    /// Declare the keys of this generator, in addition to `Mesh`, and read their values.
    /// @param section of the body
    virtual void
    declare(Section &section) = 0;

    /// Read files, after declare() and before all other functions. Throws SceneError.
    /// @param folder in which files are looked for after the current one
    /// @param needs_hypercubes what the scene asks for that triangles and tetrahedra do not have,
    /// as the words of a message; empty: nothing
    /// @return messages for the user
    virtual std::vector<std::string>
    read_file([[maybe_unused]] const std::string &folder,
              [[maybe_unused]] const std::string &needs_hypercubes)
    {
      return {};
    }

    /// @return names of the boundaries, known before generate().
    virtual std::vector<std::string>
    boundaries() const = 0;

    /// @return the coarse mesh, without refinement.
    virtual CoarseMesh<dim>
    generate() const = 0;

    /// @return how often cells can be merged, 2^dim at a time, such that as many refinements
    /// reproduce the mesh of generate(). Few coarse cells are an advantage: each rank stores all of
    /// them, and they are the coarsest level of multigrid.
    virtual unsigned int
    possible_merges() const
    {
      return 0;
    }

    /// @return the coarse mesh after merging cells.
    /// @param merges at most possible_merges()
    virtual CoarseMesh<dim>
    generate_merged([[maybe_unused]] const unsigned int merges) const
    {
      return generate();
    }

    /// @return whether the cells are triangles or tetrahedra; known before generate().
    virtual bool
    has_simplices() const
    {
      return false;
    }

    /// @return the polynomial degree that the displacement has unless the scene sets it: that of
    /// the elements of a file; 0: the mesh suggests none.
    virtual unsigned int
    degree_of_elements() const
    {
      return 0;
    }

    /// @return names of the sets of nodes.
    virtual std::vector<std::string>
    node_sets() const
    {
      return {};
    }

    /// @return the nodes of a set, on the coarse mesh of generate(); empty if there is none of that
    /// name.
    virtual NodeSet<dim>
    node_set(const std::string & /*name*/) const
    {
      return {};
    }

    /// @return names of the sets of cells.
    virtual std::vector<std::string>
    cell_sets() const
    {
      return {};
    }

    /// @return the cells of a set, as indices into the coarse mesh of generate(); empty if there is
    /// none of that name.
    virtual std::vector<unsigned int>
    cell_set(const std::string & /*name*/) const
    {
      return {};
    }

    /// @return why the mesh can be used only if a contact pair joins two boundaries of this body;
    /// empty if there is no such condition.
    virtual std::string
    needs_pair() const
    {
      return "";
    }

    /// @return where the cells come from if they are a part of a file; otherwise empty.
    virtual std::string
    origin() const
    {
      return "";
    }

    /// @return the origins of the cells in the file with which those of this mesh share faces.
    virtual std::vector<std::string>
    neighbours() const
    {
      return {};
    }

    /// @return whether the mesh contains a temperature field; known before the file is read.
    virtual bool
    has_temperature() const
    {
      return false;
    }

    /// @return the temperature at each vertex of generate(); empty if there is none.
    virtual const std::vector<double> &
    temperature() const;

    /// @return whether cells should be curved (geometry of degree two or more).
    virtual bool
    curved() const = 0;

    /// @return a new generator. Throws SceneError if there is none of that name.
    /// @param name one of generator_names<dim>()
    static std::unique_ptr<MeshGenerator<dim>>
    create(const std::string &name);
  };

  /// @return the word for simplices, or for the other cells, in messages.
  /// @param dim 2 or 3
  /// @param of_simplices whether simplices are meant
  inline std::string
  word_of_cells(const unsigned int dim, const bool of_simplices)
  {
    if (of_simplices)
      return dim == 2 ? "triangles" : "tetrahedra";
    return dim == 2 ? "quadrilaterals" : "hexahedra";
  }

  /// @return the names of all generators in this dimension.
  template <int dim>
  std::vector<std::string>
  generator_names();
} // namespace Signorini
