// SPDX-License-Identifier: Apache-2.0
#include "contact/search/find_pairs.h"

#include "contact/search/face_patch.h"
#include "contact/search/face_patches.h"
#include "contact/search/search.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A boundary face, by the data that the search for pairs uses. It is sent to all ranks.
    template <int dim>
    struct Face
    {
      Point<dim> center;
      /// Outward unit normal at the center.
      Tensor<1, dim> normal;
      /// Diameter of the face [length].
      double size;
      /// Numbers of the boundary, in Mesh::boundaries(), and of the body.
      unsigned int boundary, body;

      /// A box around the face, larger by a margin on all sides.
      BoundingBox<dim>
      box(const double margin) const
      {
        BoundingBox<dim> result(std::make_pair(center, center));
        result.extend(size / 2 + margin);
        return result;
      }

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        serialize_bytes(ar, *this);
      }
    };

    /// The boundary faces of all bodies.
    template <int dim>
    struct Surfaces
    {
      std::vector<Face<dim>>                   own, all; ///< faces of this rank, of all ranks
      std::vector<std::vector<FacePatch<dim>>> patches;  ///< of this rank, by body
    };

    /// Collect the boundary faces of the mesh. Faces of all ranks are gathered on each of them,
    /// since pairs are searched once only. Collective.
    template <int dim>
    Surfaces<dim>
    surfaces_of(const Mesh<dim> &mesh)
    {
      // A face that has several names belongs to the boundary that is listed first.
      std::map<types::boundary_id, unsigned int> number_of;
      for (unsigned int i = 0; i < mesh.boundaries().size(); ++i)
        for (const types::boundary_id id : mesh.boundary_ids(mesh.boundaries()[i]))
          number_of.insert({id, i});
      Surfaces<dim>    result{{}, {}, std::vector<std::vector<FacePatch<dim>>>(mesh.n_bodies())};
      FacePatches<dim> patch_of(mesh);
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              {
                const FacePatch<dim> patch  = patch_of(cell, f);
                const Point<dim - 1> middle = patch.middle();
                result.own.push_back({patch.position(middle),
                                      patch.normal(middle),
                                      patch.diameter(),
                                      number_of.at(cell->face(f)->boundary_id()),
                                      mesh.body(cell)});
                result.patches[mesh.body(cell)].push_back(patch);
              }
      for (const auto &some : Utilities::MPI::all_gather(mesh.communicator(), result.own))
        result.all.insert(result.all.end(), some.begin(), some.end());
      return result;
    }

    /// True if two faces belong to different bodies, face each other, and are within a distance of
    /// each other along the normal of the first one, with a lateral offset of at most their mean
    /// size.
    template <int dim>
    bool
    may_meet(const Face<dim> &a, const Face<dim> &b, const double distance)
    {
      const Tensor<1, dim> across  = b.center - a.center;
      const double         height  = across * a.normal;
      const double         lateral = (across - height * a.normal).norm();
      return a.body != b.body && faces_each_other<dim>(a.normal, b.normal) &&
             std::abs(height) <= distance + (a.size + b.size) / 4 &&
             lateral <= (a.size + b.size) / 2;
    }

    /// True if neither face lies behind the plane of the other, up to a small tolerance.
    template <int dim>
    bool
    is_in_front(const Face<dim> &a, const Face<dim> &b)
    {
      const double         touching = 1e-6 * std::min(a.size, b.size);
      const Tensor<1, dim> across   = b.center - a.center;
      return across * a.normal >= -touching && -across * b.normal >= -touching;
    }

    /// True if the center of b lies between the center of a and the height above it along the
    /// normal of a, and close enough to that line to hide what is beyond.
    template <int dim>
    bool
    covers(const Face<dim> &b, const Face<dim> &a, const double height)
    {
      const double         touching = 1e-6 * std::min(a.size, b.size);
      const Tensor<1, dim> across   = b.center - a.center;
      const double         here     = across * a.normal;
      return here > -touching && here < height - touching &&
             (across - here * a.normal).norm() <= b.size / 2;
    }

    /// Numbers of two boundaries, the smaller one first.
    using BoundaryPair = std::pair<unsigned int, unsigned int>;

    /// The faces in front of a face that are visible from it: of those that may meet it, the ones
    /// that are not hidden both from its own center and from the point below the other face's
    /// center.
    template <int dim>
    std::vector<const Face<dim> *>
    visible_from(const Face<dim> &face, const std::vector<const Face<dim> *> &front)
    {
      std::vector<const Face<dim> *> result;
      for (const Face<dim> *other : front)
        {
          const double height      = (other->center - face.center) * face.normal;
          bool         before_face = false, before_other = false;
          for (const Face<dim> *between : front)
            {
              before_face      = before_face || covers(*between, face, height);
              Face<dim> beside = face;
              beside.center    = other->center - height * face.normal;
              before_other     = before_other || covers(*between, beside, height);
            }
          if (!before_face || !before_other)
            result.push_back(other);
        }
      return result;
    }

    /// For each face of this rank, by number, the boundaries of one other body of which parts lie
    /// behind the face.
    using BoundariesBehind = std::map<unsigned int, std::set<unsigned int>>;

    /// Add the pairs of boundaries of which one lies behind the other although they may be in
    /// contact: the bodies overlap there, or the closest point of the other body faces the face.
    /// Otherwise what lies behind is on the far side of a body. Collective.
    /// @param own faces of this rank
    /// @param body faces of the other body on this rank
    template <int dim>
    void
    add_overlapping(const std::vector<Face<dim>>      &own,
                    const BoundariesBehind            &behind,
                    const std::vector<FacePatch<dim>> &body,
                    const double                       distance,
                    const MPI_Comm                     comm,
                    std::set<BoundaryPair>            &result)
    {
      std::vector<Point<dim>> points;
      for (const auto &entry : behind)
        points.push_back(own[entry.first].center);
      const MasterFaces<dim> faces{body, [](auto, const auto &, auto &) {}};
      const auto             closest = find_master_projections(
        points, std::vector<Tensor<1, dim>>(points.size()), faces, distance, comm);
      auto point_on_obstacle = closest.begin();
      for (const auto &[number, boundaries] : behind)
        if (const auto &master_point = *point_on_obstacle++)
          {
            const Face<dim> &face = own[number];
            const bool       is_inside =
              (face.center - master_point->position) * master_point->normal < 0;
            if (is_inside || faces_each_other<dim>(face.normal, master_point->normal))
              for (const unsigned int boundary : boundaries)
                result.insert(std::minmax(face.boundary, boundary));
          }
    }

    /// The pairs of boundaries of different bodies that may come into contact, the same on all
    /// ranks. Each rank examines its own faces against those of all ranks by an R-tree of their
    /// boxes. Collective.
    template <int dim>
    std::set<BoundaryPair>
    meeting_boundaries(const Surfaces<dim> &surfaces, const double distance, const MPI_Comm comm)
    {
      // The tree answers in logarithmic time which faces are near one; without it all pairs of
      // faces would be compared.
      std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
      for (unsigned int i = 0; i < surfaces.all.size(); ++i)
        boxes.emplace_back(surfaces.all[i].box(0), i);
      const auto                    tree = pack_rtree(boxes);
      std::set<BoundaryPair>        own;
      std::vector<BoundariesBehind> behind(surfaces.patches.size());
      double                        farthest = distance;
      for (unsigned int k = 0; k < surfaces.own.size(); ++k)
        {
          const Face<dim> &face = surfaces.own[k];
          farthest              = std::max(farthest, distance + face.size);
          std::vector<const Face<dim> *> front;
          for (const auto &[box, i] :
               tree | boost::geometry::index::adaptors::queried(
                        boost::geometry::index::intersects(face.box(distance))))
            if (const Face<dim> &other = surfaces.all[i]; may_meet(face, other, distance))
              {
                if (is_in_front(face, other))
                  front.push_back(&other);
                else
                  behind[other.body][k].insert(other.boundary);
              }
          for (const Face<dim> *other : visible_from(face, front))
            own.insert(std::minmax(face.boundary, other->boundary));
        }
      farthest = Utilities::MPI::max(farthest, comm);
      for (unsigned int body = 0; body < behind.size(); ++body)
        add_overlapping(surfaces.own, behind[body], surfaces.patches[body], farthest, comm, own);
      std::set<BoundaryPair> all;
      for (const auto &some :
           Utilities::MPI::all_gather(comm, std::vector<BoundaryPair>(own.begin(), own.end())))
        all.insert(some.begin(), some.end());
      return all;
    }

    /// The boundaries with a face that is within a distance of an obstacle and faces it.
    template <int dim>
    std::set<unsigned int>
    boundaries_at(const std::vector<Face<dim>> &faces,
                  const ObstacleShape<dim>     &shape,
                  const double                  distance)
    {
      std::set<unsigned int> result;
      for (const Face<dim> &face : faces)
        {
          const ObstaclePoint<dim> point_on_obstacle = shape.closest(face.center);
          // The centre stands for the face; half of its diameter is added to the distance.
          if (std::abs(point_on_obstacle.gap) <= distance + face.size / 2 &&
              faces_each_other(face.normal, point_on_obstacle.normal))
            result.insert(face.boundary);
        }
      return result;
    }

    /// The mesh size of a boundary.
    struct Fineness
    {
      double       size = 0; ///< mean over its faces
      unsigned int body = 0;
    };

    /// The mean size of the faces of each boundary, and its body.
    template <int dim>
    std::vector<Fineness>
    fineness(const std::vector<Face<dim>> &faces, const unsigned int n_boundaries)
    {
      std::vector<Fineness>     result(n_boundaries);
      std::vector<unsigned int> n(n_boundaries, 0);
      for (const Face<dim> &face : faces)
        {
          result[face.boundary].size += face.size;
          result[face.boundary].body = face.body;
          ++n[face.boundary];
        }
      for (unsigned int i = 0; i < n_boundaries; ++i)
        result[i].size /= std::max(1u, n[i]);
      return result;
    }

    /// Throws SceneError if slave boundaries of different names share faces, which would be in
    /// contact twice.
    template <int dim>
    void
    check_names(const std::vector<ContactPair<dim>> &pairs, const Mesh<dim> &mesh)
    {
      std::map<types::boundary_id, std::string> name_of;
      for (const ContactPair<dim> &pair : pairs)
        for (const types::boundary_id id : mesh.boundary_ids(pair.slave))
          if (const auto &name = name_of.insert({id, pair.slave}).first->second; name != pair.slave)
            throw SceneError("Contact pairs/Names = auto: '" + name + "' and '" + pair.slave +
                             "' name the same faces; define the pairs explicitly, or restrict the "
                             "boundaries by the key 'Boundaries' of the body");
    }

    /// True if the first of two boundaries should be the slave: the finer one, or the softer one if
    /// the mesh sizes differ by at most a factor of 1.2.
    bool
    first_is_slave(const Fineness &a, const Fineness &b, const std::vector<double> &moduli)
    {
      constexpr double about_as_fine = 1.2;
      if (a.size * about_as_fine < b.size || b.size * about_as_fine < a.size)
        return a.size < b.size;
      return moduli[a.body] <= moduli[b.body];
    }
  } // namespace



  template <int dim>
  std::vector<ContactPair<dim>>
  find_pairs(const Mesh<dim>                  &mesh,
             const std::vector<Obstacle<dim>> &obstacles,
             const std::vector<double>        &moduli,
             const ContactPair<dim>           &pattern,
             const double                      distance)
  {
    // Pairs between bodies, then those with obstacles, whose slave is always the body.
    const Surfaces<dim>           surfaces = surfaces_of(mesh);
    const auto                   &names    = mesh.boundaries();
    const std::vector<Fineness>   fine     = fineness(surfaces.all, names.size());
    std::vector<ContactPair<dim>> result;
    const auto                    add = [&](const std::string &slave, const std::string &master) {
      ContactPair<dim> pair = pattern;
      pair.name             = slave + " on " + master;
      pair.slave            = slave;
      pair.master           = master;
      pair.found            = true;
      result.push_back(pair);
    };
    // The set is sorted and the same on all ranks, and so is the list of pairs.
    for (const auto &[a, b] : meeting_boundaries(surfaces, distance, mesh.communicator()))
      if (first_is_slave(fine[a], fine[b], moduli))
        add(names[a], names[b]);
      else
        add(names[b], names[a]);
    for (const Obstacle<dim> &obstacle : obstacles)
      for (const unsigned int boundary : boundaries_at(surfaces.all, *obstacle.shape, distance))
        add(names[boundary], obstacle.name);
    check_names(result, mesh);
    return result;
  }



  template std::vector<ContactPair<2>>
  find_pairs(const Mesh<2> &,
             const std::vector<Obstacle<2>> &,
             const std::vector<double> &,
             const ContactPair<2> &,
             double);
  template std::vector<ContactPair<3>>
  find_pairs(const Mesh<3> &,
             const std::vector<Obstacle<3>> &,
             const std::vector<double> &,
             const ContactPair<3> &,
             double);
} // namespace Signorini
