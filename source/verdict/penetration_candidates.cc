// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_size.h"
#include "solid/cell_nodes.h"
#include "verdict/undetected_penetration.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// An axis-parallel box; both operations include its boundary.
    template <int dim>
    struct Box
    {
      Point<dim> low, high;

      bool
      meets(const Box &other) const
      {
        for (unsigned int d = 0; d < dim; ++d)
          if (low[d] > other.high[d] || other.low[d] > high[d])
            return false;
        return true;
      }

      void
      add(const Box &other)
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            low[d]  = std::min(low[d], other.low[d]);
            high[d] = std::max(high[d], other.high[d]);
          }
      }
    };

    /// A boundary face of this rank, with what a first comparison needs.
    template <int dim>
    struct Face
    {
      CellIterator<dim> cell;
      unsigned int      face, kind;
      Point<dim>        center;
      /// Radius of a sphere around the centre that contains the corners.
      double radius;
      /// Bounding box, extended by half of the depth of the cell, up to which overlaps are
      /// detected.
      Box<dim> box;
    };

    /// The bounding box of all faces of one body and kind on one rank.
    template <int dim>
    struct Group
    {
      unsigned int body, kind;
      Box<dim>     box;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        serialize_bytes(ar, *this);
      }
    };

    /// The current positions of vertices.
    template <int dim>
    class MovedVertices
    {
    public:
      MovedVertices(const Configuration<dim> &configuration)
        : u(configuration.elasticity().with_ghosts(configuration.displacement()))
      {}

      Point<dim>
      operator()(const CellIterator<dim> &cell, const unsigned int vertex) const
      {
        Point<dim> x = cell->vertex(vertex);
        for (unsigned int d = 0; d < dim; ++d)
          x[d] += u(cell->vertex_dof_index(vertex, d, cell->active_fe_index()));
        return x;
      }

    private:
      LA::Vector u;
    };

    /// @return a face with its box in the current configuration.
    template <int dim>
    Face<dim>
    seen_from_far(const MovedVertices<dim>     &moved,
                  const MonitoredSurfaces<dim> &watched,
                  const CellIterator<dim>      &cell,
                  const unsigned int            face)
    {
      const auto              reference = cell->reference_cell();
      const unsigned int      n         = reference.face_reference_cell(face).n_vertices();
      std::vector<Point<dim>> corners(n);
      Face<dim>               result{cell, face, watched.kind(cell, face), {}, 0, {}};
      for (unsigned int i = 0; i < n; ++i)
        {
          corners[i] = moved(cell, reference.face_to_cell_vertices(face, i, 1));
          result.center += corners[i] / double(n);
        }
      // The box is enlarged by half of the depth of the cell: penetrations are detected up to that
      // depth, and curved faces leave the box of their corners.
      result.box = {corners[0], corners[0]};
      for (const Point<dim> &x : corners)
        {
          result.box.add({x, x});
          result.radius = std::max(result.radius, x.distance(result.center));
        }
      const double margin = depth_behind(cell, face) / 2;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result.box.low[d] -= margin;
          result.box.high[d] += margin;
        }
      return result;
    }

    /// @return all boundary faces of this rank.
    template <int dim>
    std::vector<Face<dim>>
    all_faces(const Configuration<dim> &configuration, const MonitoredSurfaces<dim> &watched)
    {
      std::vector<Face<dim>>   result;
      const MovedVertices<dim> moved(configuration);
      for (const auto &cell : configuration.elasticity().dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              result.push_back(seen_from_far(moved, watched, cell, f));
      return result;
    }

    /// @return the groups of all ranks. Collective.
    template <int dim>
    std::vector<Group<dim>>
    groups_of(const Mesh<dim>                         &mesh,
              const std::vector<Face<dim>>            &faces,
              const std::function<bool(unsigned int)> &belongs)
    {
      // One box for each body and kind of this rank; all ranks get all boxes, which are few.
      std::map<std::pair<unsigned int, unsigned int>, Box<dim>> boxes;
      for (unsigned int i = 0; i < faces.size(); ++i)
        if (belongs(i))
          boxes.insert({{mesh.body(faces[i].cell), faces[i].kind}, faces[i].box})
            .first->second.add(faces[i].box);
      std::vector<Group<dim>> own, all;
      for (const auto &[name, box] : boxes)
        own.push_back({name.first, name.second, box});
      for (const auto &some : Utilities::MPI::all_gather(mesh.communicator(), own))
        all.insert(all.end(), some.begin(), some.end());
      return all;
    }

    /// @return whether a face may be inside of an obstacle with which no pair detects contact.
    template <int dim>
    bool
    may_be_in(const Face<dim>              &face,
              const Scene<dim>             &scene,
              const Configuration<dim>     &configuration,
              const MonitoredSurfaces<dim> &watched)
    {
      const double length = configuration.elasticity().rotation_length_scale();
      // A face may touch an obstacle if its centre is closer than its radius. Obstacles that are
      // not defined near the face are left out.
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        if (!watched.is_monitored(face.kind, obstacle.name) &&
            obstacle.shape->has_closest_point(face.center, length) &&
            configuration.closest(obstacle, configuration.pose(obstacle), face.center).gap <
              face.radius)
          return true;
      return false;
    }
  } // namespace



  // Boxes of faces are compared with boxes of groups (body, kind, rank) instead of faces, so that
  // little is communicated; a second round finds the faces near those that may penetrate.
  template <int dim>
  PenetrationCandidates<dim>::PenetrationCandidates(const Scene<dim>             &scene,
                                                    const Configuration<dim>     &configuration,
                                                    const MonitoredSurfaces<dim> &watched)
  {
    const Mesh<dim>             &mesh  = configuration.elasticity().mesh();
    const std::vector<Face<dim>> faces = all_faces(configuration, watched);
    const auto        groups = groups_of<dim>(mesh, faces, [](unsigned int) { return true; });
    std::vector<bool> may_penetrate(faces.size()), is_in_body(faces.size());
    const auto        meets = [&](const Face<dim> &face, const Group<dim> &group) {
      return group.body != mesh.body(face.cell) && face.box.meets(group.box);
    };
    for (unsigned int i = 0; i < faces.size(); ++i)
      {
        // First round: faces whose box meets the box of a group of another body, with which no pair
        // monitors contact, or that may be in an obstacle. Boxes of the same body always meet, and
        // are left out.
        is_in_body[i]    = std::any_of(groups.begin(), groups.end(), [&](const Group<dim> &group) {
          return meets(faces[i], group) && !watched.is_monitored(faces[i].kind, group.kind);
        });
        may_penetrate[i] = is_in_body[i] || may_be_in(faces[i], scene, configuration, watched);
      }
    // Second round: faces of other bodies near the boxes of faces that may penetrate. These are the
    // opposite surfaces of the exact search that follows.
    const auto asking =
      groups_of<dim>(mesh, faces, [&](const unsigned int i) { return is_in_body[i]; });
    for (unsigned int i = 0; i < faces.size(); ++i)
      if (may_penetrate[i] ||
          std::any_of(asking.begin(), asking.end(), [&](const Group<dim> &group) {
            return meets(faces[i], group);
          }))
        // The value tells the faces that may penetrate (whose points are tested) from those that
        // are only needed as opposite surfaces.
        found[{faces[i].cell->active_cell_index(), faces[i].face}] = may_penetrate[i];
  }



  template <int dim>
  bool
  PenetrationCandidates<dim>::may_penetrate(const CellIterator<dim> &cell,
                                            const unsigned int       face) const
  {
    const auto one = found.find({cell->active_cell_index(), face});
    return one != found.end() && one->second;
  }



  template <int dim>
  bool
  PenetrationCandidates<dim>::counts(const CellIterator<dim> &cell, const unsigned int face) const
  {
    return found.count({cell->active_cell_index(), face}) > 0;
  }



  template class PenetrationCandidates<2>;
  template class PenetrationCandidates<3>;
} // namespace Signorini
