#include <signorini/contact/surface.h>

#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /// Sum entries of the same index.
    void
    unite(SparseRow &row)
    {
      std::sort(row.begin(), row.end());
      std::size_t last = 0;
      for (std::size_t i = 1; i < row.size(); ++i)
        if (row[i].first == row[last].first)
          row[last].second += row[i].second;
        else
          row[++last] = row[i];
      if (!row.empty())
        row.resize(last + 1);
    }

    /// Replace hanging nodes by the nodes that they hang on.
    void
    resolve(const AffineConstraints<double> &hanging, SparseRow &row)
    {
      const std::size_t n = row.size();
      for (std::size_t i = 0; i < n; ++i)
        if (const auto *entries = hanging.get_constraint_entries(row[i].first))
          {
            const double factor = row[i].second;
            row[i].second       = 0;
            for (const auto &[index, weight] : *entries)
              row.emplace_back(index, factor * weight);
          }
      row.erase(std::remove_if(row.begin(),
                               row.end(),
                               [](const auto &entry) { return entry.second == 0; }),
                row.end());
      unite(row);
    }

    /// Shape functions of a cell at a point of its boundary, in terms of degrees of freedom.
    template <int dim>
    class Trace
    {
    public:
      Trace(const Elasticity<dim> &elasticity)
        : fe(elasticity.finite_element())
        , hanging(elasticity.hanging_nodes())
        , indices(fe.n_dofs_per_cell())
      {}

      void
      reinit(const Cell<dim> &cell)
      {
        cell->get_dof_indices(indices);
      }

      /// n . u at a point of the reference cell.
      SparseRow
      normal_displacement(const Point<dim> &unit_point, const Tensor<1, dim> &n) const
      {
        SparseRow row;
        for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
          if (const double value = fe.base_element(0).shape_value(i, unit_point);
              std::abs(value) > 1e-14)
            for (unsigned int d = 0; d < dim; ++d)
              if (n[d] != 0)
                row.emplace_back(indices[fe.component_to_system_index(d, i)], value * n[d]);
        resolve(hanging, row);
        return row;
      }

      /// The scalar shape functions, each named by its node's first degree of freedom.
      SparseRow
      shape(const Point<dim> &unit_point) const
      {
        SparseRow row;
        for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
          if (const double value = fe.base_element(0).shape_value(i, unit_point);
              std::abs(value) > 1e-14)
            row.emplace_back(indices[fe.component_to_system_index(0, i)], value);
        resolve(hanging, row);
        return row;
      }

    private:
      const FESystem<dim>                 &fe;
      const AffineConstraints<double>     &hanging;
      std::vector<types::global_dof_index> indices;
    };

    /// E/h of a cell behind a face, h being the depth of the cell.
    template <int dim>
    double
    stiffness(const Elasticity<dim> &elasticity, const Cell<dim> &cell, const unsigned int face)
    {
      return elasticity.material(cell->material_id()).youngs_modulus * cell->face(face)->measure() /
             cell->measure();
    }

    template <int dim>
    using Faces = std::vector<std::pair<Cell<dim>, unsigned int>>;

    template <int dim>
    Faces<dim>
    owned_faces(const Elasticity<dim> &elasticity, const std::string &boundary)
    {
      Faces<dim> faces;
      const auto id = elasticity.mesh().boundary_id(boundary);
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
              faces.emplace_back(cell, f);
      return faces;
    }

    /// The slave's points before they have partners.
    template <int dim>
    struct SlavePoints
    {
      std::vector<Point<dim>>                          positions;
      std::vector<Tensor<1, dim>>                      normals;
      std::vector<double>                              weights, stiffnesses;
      std::vector<std::pair<unsigned int, Point<dim>>> places; ///< face, reference point
    };

    template <int dim>
    SlavePoints<dim>
    slave_points(const Elasticity<dim> &elasticity,
                 const Faces<dim>      &faces,
                 const unsigned int     n_points)
    {
      const QGauss<dim - 1> quadrature(n_points);
      FEFaceValues<dim>     values(elasticity.mesh().mapping(),
                               elasticity.finite_element(),
                               quadrature,
                               update_quadrature_points | update_normal_vectors |
                                 update_JxW_values);
      // The same points on the reference cell, for each face in each orientation.
      const Quadrature<dim> projected =
        QProjector<dim>::project_to_all_faces(ReferenceCells::get_hypercube<dim>(), quadrature);
      SlavePoints<dim> slave;
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          const auto &[cell, face] = faces[i];
          values.reinit(cell, face);
          const unsigned int offset =
            QProjector<dim>::DataSetDescriptor::face(ReferenceCells::get_hypercube<dim>(),
                                                     face,
                                                     cell->face_orientation(face),
                                                     cell->face_flip(face),
                                                     cell->face_rotation(face),
                                                     quadrature.size());
          const double k = stiffness(elasticity, cell, face);
          for (const unsigned int q : values.quadrature_point_indices())
            {
              slave.positions.push_back(values.quadrature_point(q));
              slave.normals.push_back(values.normal_vector(q));
              slave.weights.push_back(values.JxW(q));
              slave.stiffnesses.push_back(k);
              slave.places.emplace_back(i, projected.point(offset + q));
            }
        }
      return slave;
    }

    template <int dim>
    MasterFaces<dim>
    master_faces(const Elasticity<dim> &elasticity, const Faces<dim> &faces)
    {
      MasterFaces<dim> master;
      for (const auto &[cell, face] : faces)
        master.patches.emplace_back(elasticity.mesh().mapping(),
                                    elasticity.mesh().geometry_degree(),
                                    cell,
                                    face);
      master.complete =
        [&elasticity, faces, trace = Trace<dim>(elasticity)](const unsigned int    i,
                                                             const Point<dim - 1> &xi,
                                                             Partner<dim> &partner) mutable {
          const auto &[cell, face] = faces[i];
          trace.reinit(cell);
          partner.row       = trace.normal_displacement(unit_point<dim>(face, xi), partner.normal);
          partner.stiffness = stiffness(elasticity, cell, face);
        };
      return master;
    }

    template <int dim>
    double
    initial_gap(const ContactPair<dim> &pair, const Point<dim> &x, const double from_geometry)
    {
      if (pair.initial_gap == "from geometry")
        return from_geometry;
      return pair.initial_gap == "closed" ? 0. : Expression<dim>(pair.initial_gap).value(x);
    }

    /// Partners on a rigid obstacle: no mesh, no search.
    template <int dim>
    std::vector<std::optional<Partner<dim>>>
    obstacle_partners(const SlavePoints<dim> &slave,
                      const Obstacle<dim>    &obstacle,
                      const double            reach)
    {
      std::vector<std::optional<Partner<dim>>> partners(slave.positions.size());
      for (unsigned int i = 0; i < partners.size(); ++i)
        {
          const Point<dim>        &x     = slave.positions[i];
          const ObstaclePlace<dim> place = obstacle.shape->closest(x);
          if (std::abs(place.gap) > reach || place.normal * slave.normals[i] > -0.1)
            continue;
          partners[i].emplace();
          partners[i]->position  = x - place.gap * place.normal;
          partners[i]->normal    = place.normal;
          partners[i]->distance  = std::abs(place.gap);
          partners[i]->stiffness = std::numeric_limits<double>::infinity();
        }
      return partners;
    }

    template <int dim>
    double
    largest_diameter(const Elasticity<dim> &elasticity, const Faces<dim> &faces)
    {
      double largest = 0;
      for (const auto &[cell, face] : faces)
        largest = std::max(largest, cell->face(face)->diameter());
      return Utilities::MPI::max(largest, elasticity.mesh().communicator());
    }

    /// Faces take part as a whole or not at all: a shape function on a part of a face would be a
    /// weight that changes its sign.
    template <int dim>
    void
    drop_far_faces(const SlavePoints<dim>                   &slave,
                   const double                              limit,
                   std::vector<std::optional<Partner<dim>>> &partners)
    {
      std::map<unsigned int, double> nearest;
      for (unsigned int i = 0; i < partners.size(); ++i)
        if (partners[i])
          {
            const auto [at, is_new] = nearest.emplace(slave.places[i].first, partners[i]->distance);
            at->second              = std::min(at->second, partners[i]->distance);
          }
      for (unsigned int i = 0; i < partners.size(); ++i)
        if (partners[i] && nearest[slave.places[i].first] > limit)
          partners[i].reset();
    }

    template <int dim>
    ContactPoint<dim>
    contact_point(const ContactPair<dim> &pair,
                  const SlavePoints<dim> &slave,
                  const unsigned int      i,
                  const Partner<dim>     &partner,
                  const Trace<dim>       &trace)
    {
      ContactPoint<dim> point;
      point.position = slave.positions[i];
      point.normal   = partner.normal;
      point.weight   = slave.weights[i];
      point.gap =
        initial_gap(pair, point.position, (point.position - partner.position) * partner.normal);
      point.stiffness = 1 / (1 / slave.stiffnesses[i] + 1 / partner.stiffness);
      point.row       = trace.normal_displacement(slave.places[i].second, partner.normal);
      for (const auto &[index, value] : partner.row)
        point.row.emplace_back(index, -value);
      unite(point.row);
      point.shape = trace.shape(slave.places[i].second);
      return point;
    }
  } // namespace



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const unsigned int      n_points)
  {
    ContactSurface<dim>    surface;
    const Faces<dim>       faces = owned_faces(elasticity, pair.slave);
    const SlavePoints<dim> slave = slave_points(elasticity, faces, n_points);
    const double           limit =
      pair.search_distance > 0 ? pair.search_distance : elasticity.mesh().size() / 10;
    // Distances change by no more than its diameter on a face: this reach finds all points of each
    // face that has one within the limit.
    const double reach    = limit + largest_diameter(elasticity, faces);
    auto         partners = obstacle ?
                              obstacle_partners(slave, *obstacle, reach) :
                              find_partners(slave.positions,
                                    slave.normals,
                                    master_faces(elasticity, owned_faces(elasticity, pair.master)),
                                    reach,
                                    elasticity.mesh().communicator(),
                                    &surface.statistics);
    drop_far_faces(slave, limit, partners);

    Trace<dim> trace(elasticity);
    surface.faces = faces.size();
    for (unsigned int i = 0; i < partners.size(); ++i)
      {
        trace.reinit(faces[slave.places[i].first].first);
        if (partners[i])
          surface.points.push_back(contact_point(pair, slave, i, *partners[i], trace));
        else
          surface.unpaired.emplace_back(trace.shape(slave.places[i].second), slave.weights[i]);
      }
    return surface;
  }



  template ContactSurface<2>
  make_contact_surface(const Elasticity<2> &,
                       const ContactPair<2> &,
                       const Obstacle<2> *,
                       unsigned int);
  template ContactSurface<3>
  make_contact_surface(const Elasticity<3> &,
                       const ContactPair<3> &,
                       const Obstacle<3> *,
                       unsigned int);
} // namespace Signorini
