// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>
#include <signorini/parameters/time_span.h>
#include <signorini/solid/local_axes.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;
  struct WetFaces;

  /// The nodes on which a support or a load acts, besides its boundaries.
  struct NodeChoice
  {
    std::vector<std::string> sets;  ///< "body.set"
    std::vector<double>      point; ///< coordinates; empty: none
    /// The body that has the point; empty: the only one that has it.
    std::string body;
    std::string sets_location, point_location; ///< in the scene file

    /// True if no nodes are chosen.
    bool
    empty() const
    {
      return sets.empty() && point.empty();
    }

    /// Declare the keys `Nodes`, `Point` and `Point body`. Throws SceneError if the point does not
    /// have `dim` coordinates.
    /// @param what beginning of the descriptions
    void
    declare(Section &section, unsigned int dim, const std::string &what);
  };

  /// The kinds of supports.
  enum class SupportType
  {
    /// Prescribed components of the displacement.
    displacement,
    /// No displacement along the normal of plane faces.
    symmetry,
    /// Prescribed displacement along one direction, given or normal to the faces.
    roller
  };

  /// A prescribed displacement on boundaries of bodies or on nodes: by component, or along one
  /// direction; always, or during a time span.
  template <int dim>
  struct Support : TimeSpan
  {
    std::string              name;
    std::vector<std::string> boundaries; ///< "body.boundary"
    NodeChoice               nodes;
    /// Location of the boundaries in the scene file, for messages.
    std::string place;
    SupportType type = SupportType::displacement;
    /// Prescribed components [length]; others are free.
    VectorExpression<dim> displacement;
    /// Displacement of a roller along its direction [length].
    Expression<dim> normal_displacement;
    /// Direction that a roller constrains, of any length; zero: normal to the faces.
    dealii::Point<dim> direction;
    /// The axes to which the components of the displacement refer.
    LocalAxes<dim> axes;

    /// The prescribed displacement at x, in components of the global axes; zero in components that
    /// are free.
    dealii::Tensor<1, dim>
    displacement_at(const dealii::Point<dim> &x, double t) const;

    /// Declare the keys of a support; invalid combinations are reported through the section.
    void
    declare(Section &section);
  };

  /// A load on boundaries (traction, pressure, total force), in bodies (body force), or at nodes
  /// and points (forces). A force at a point of an elastic body is singular: the displacement there
  /// grows without end as the mesh is refined (2D and edges in 3D as the logarithm of h, points in
  /// 3D as 1/h); away from it the solution converges.
  template <int dim>
  struct Load
  {
    std::string              name;
    std::vector<std::string> boundaries;
    /// Locations of boundaries and bodies in the scene file, for messages.
    std::string           place, bodies_location;
    VectorExpression<dim> traction; ///< [force/area]
    Expression<dim>       pressure; ///< [force/area], positive pushes into the body
    /// Where a fluid with that pressure enters [length]; none: it acts on all of the boundaries.
    std::vector<dealii::Point<dim>> fluid_entries;
    /// The faces on which it acts at present, of loads with entries; null: all.
    std::shared_ptr<WetFaces> wet;
    std::vector<std::string>  bodies;     ///< "body", or "body.set" of cells
    VectorExpression<dim>     body_force; ///< [force/volume]
    NodeChoice                nodes;
    VectorExpression<dim>     force;       ///< at each node, or at the point [force]
    VectorExpression<dim>     total_force; ///< on all boundaries or nodes of this load [force]
    /// On all boundaries of this load, about `reference` [force length].
    VectorExpression<dim, dim == 2 ? 1 : 3> total_moment;
    /// Where the total force acts [length]; empty: at the centre of the boundaries.
    std::vector<double> reference;
    /// The axes to which the components of traction, body force and force refer.
    LocalAxes<dim> axes;

    /// The traction at x, in components of the global axes [force/area].
    dealii::Tensor<1, dim>
    traction_at(const dealii::Point<dim> &x, double t) const;

    /// The body force at x likewise [force/volume].
    dealii::Tensor<1, dim>
    body_force_at(const dealii::Point<dim> &x, double t) const;

    /// The force at a node at x likewise [force].
    dealii::Tensor<1, dim>
    force_at(const dealii::Point<dim> &x, double t) const;

    /// True if the load has a total force or moment on boundaries.
    bool
    has_resultant() const
    {
      return !boundaries.empty() && (total_force.given() || total_moment.given());
    }

    /// Declare the keys of a load; invalid combinations are reported through the section.
    void
    declare(Section &section);
  };
} // namespace Signorini
