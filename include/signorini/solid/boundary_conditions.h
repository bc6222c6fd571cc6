// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Nodes that a support or a load acts on, beside boundaries.
  struct NodeChoice
  {
    std::vector<std::string> sets;  ///< "body.set"
    std::vector<double>      point; ///< coordinates; empty: none
    std::string              body;  ///< that has the point; empty: the only one there
    std::string              sets_location, point_location; ///< in the scene file

    bool
    empty() const
    {
      return sets.empty() && point.empty();
    }

    /// Keys `Nodes`, `Point`, `Point body`; throws SceneError if the point has not `dim`
    /// coordinates.
    void
    declare(Section &section, unsigned int dim, const std::string &what);
  };

  /// What a support prescribes.
  enum class SupportType
  {
    displacement, ///< components
    symmetry,     ///< no displacement along the normal of plane faces
    roller        ///< the displacement along one direction: that given, or the normal
  };

  /// A prescribed displacement on boundaries of bodies, or on nodes: per component, or along one
  /// direction; at all times, or in a span of time.
  template <int dim>
  struct Support
  {
    std::string              name;
    std::vector<std::string> boundaries; ///< "body.boundary"
    NodeChoice               nodes;
    std::string              place; ///< of the boundaries in the scene file
    SupportType              type = SupportType::displacement;
    VectorExpression<dim>    displacement;
    Expression<dim>          normal_displacement; ///< of a roller
    dealii::Point<dim>       direction; ///< in which a roller holds; zero: along the normal
    double                   from  = 0; ///< holds at later times; 0: also at the start
    double                   until = 0; ///< and up to this one; 0: to the end

    /// True if the support acts at time t. A time that equals an end of its span up to rounding
    /// counts as that end.
    bool
    acts(double t) const;

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
    std::string              place, bodies_location; ///< of the names in the scene file
    VectorExpression<dim>    traction;               ///< [force/area]
    Expression<dim>          pressure;   ///< [force/area], positive pushes into the body
    std::vector<std::string> bodies;     ///< "body", or "body.set" of cells
    VectorExpression<dim>    body_force; ///< [force/volume]
    NodeChoice               nodes;
    VectorExpression<dim>    force;       ///< at each node, or at the point [force]
    VectorExpression<dim>    total_force; ///< on all boundaries or nodes of this load [force]

    void
    declare(Section &section);
  };
} // namespace Signorini
