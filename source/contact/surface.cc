#include <signorini/contact/method.h>
#include <signorini/contact/normal_stress.h>
#include <signorini/contact/surface.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    template <int dim>
    double
    depth(const Cell<dim> &cell, const unsigned int face)
    {
      return cell->measure() / cell->face(face)->measure();
    }

    /// E/h of a cell behind a face, h being the depth of the cell.
    template <int dim>
    double
    stiffness(const Elasticity<dim> &elasticity, const Cell<dim> &cell, const unsigned int face)
    {
      return elasticity.material(cell->material_id()).youngs_modulus / depth<dim>(cell, face);
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

    template <int dim>
    std::vector<FacePatch<dim>>
    patches(const Elasticity<dim> &elasticity, const Faces<dim> &faces)
    {
      std::vector<FacePatch<dim>> result;
      for (const auto &[cell, face] : faces)
        result.emplace_back(elasticity.mesh().mapping(),
                            elasticity.mesh().geometry_degree(),
                            cell,
                            face);
      return result;
    }

    /// Bounds of the normal stress on faces, see NormalStress::bound(), each found when it is first
    /// asked for. Faces of one cell share its energy.
    template <int dim>
    class StressBounds
    {
    public:
      StressBounds(const Faces<dim> &faces)
        : faces(faces)
        , bounds(faces.size(), -1.)
      {}

      /// @param stress on the cell of face i
      double
      operator()(const NormalStress<dim> &stress, const unsigned int i)
      {
        if (bounds[i] < 0)
          bounds[i] = stress.bound(faces[i].second) * faces_of_cell(i);
        return bounds[i];
      }

    private:
      // They are neighbours in the list.
      unsigned int
      faces_of_cell(const unsigned int i) const
      {
        unsigned int first = i, last = i + 1;
        while (first > 0 && faces[first - 1].first == faces[i].first)
          --first;
        while (last < faces.size() && faces[last].first == faces[i].first)
          ++last;
        return last - first;
      }

      const Faces<dim>    faces;
      std::vector<double> bounds;
    };

    template <int dim>
    MasterFaces<dim>
    master_faces(const Elasticity<dim> &elasticity, const Faces<dim> &faces, const bool with_stress)
    {
      MasterFaces<dim> master;
      master.patches = patches(elasticity, faces);
      std::vector<double> stiffnesses;
      for (const auto &[cell, face] : faces)
        stiffnesses.push_back(stiffness<dim>(elasticity, cell, face));
      master.complete = [faces,
                         stiffnesses,
                         with_stress,
                         trace  = Trace<dim>(elasticity),
                         stress = std::make_shared<NormalStress<dim>>(elasticity),
                         bound  = StressBounds<dim>(faces)](const unsigned int    i,
                                                           const Point<dim - 1> &xi,
                                                           Partner<dim>         &partner) mutable {
        const auto &[cell, face]    = faces[i];
        const Point<dim>      place = unit_point<dim>(face, xi);
        const Tensor<1, dim> &n     = partner.normal;
        trace.reinit(cell, face);
        partner.row       = trace.normal_displacement(place, n);
        partner.stiffness = stiffnesses[i];
        if (!with_stress)
          return;
        stress->reinit(cell);
        partner.stress = stress->row(place, -n, n);
        partner.bound  = bound(*stress, i);
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

    /// Partners on a rigid obstacle: no mesh, no search, no segments.
    template <int dim>
    std::vector<PairedPoint<dim>>
    obstacle_points(const std::vector<FacePatch<dim>> &slave,
                    const Obstacle<dim>               &obstacle,
                    const Integration                 &integration,
                    const double                       limit)
    {
      const Quadrature<dim - 1>     rule = face_rule<dim>(integration);
      std::vector<PairedPoint<dim>> points;
      for (unsigned int i = 0; i < slave.size(); ++i)
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<dim - 1>    &xi    = rule.point(q);
            const Point<dim>         x     = slave[i].position(xi);
            const ObstaclePlace<dim> place = obstacle.shape->closest(x);
            if (std::abs(place.gap) > reach(slave[i], limit) ||
                !faces_each_other(slave[i].normal(xi), place.normal))
              continue;
            PairedPoint<dim> point{i, xi, rule.weight(q) * slave[i].jacobian(xi), {}};
            point.partner.position  = x - place.gap * place.normal;
            point.partner.normal    = place.normal;
            point.partner.distance  = std::abs(place.gap);
            point.partner.stiffness = std::numeric_limits<double>::infinity();
            point.partner.bound     = std::numeric_limits<double>::infinity();
            points.push_back(std::move(point));
          }
      keep_near_faces(limit, points);
      return points;
    }

    /// Segments that touch a face in a line only have no area, and their points no say.
    template <int dim>
    void
    drop_empty_points(const std::vector<FacePatch<dim>> &slave,
                      std::vector<PairedPoint<dim>>     &points)
    {
      const auto is_empty = [&](const PairedPoint<dim> &point) {
        return point.weight < 1e-13 * slave[point.face].jacobian(point.xi);
      };
      points.erase(std::remove_if(points.begin(), points.end(), is_empty), points.end());
    }

    template <int dim>
    ContactPoint<dim>
    contact_point(const ContactPair<dim> &pair,
                  const FacePatch<dim>   &patch,
                  const PairedPoint<dim> &paired,
                  const Point<dim>       &unit_point,
                  const double            stiffness,
                  const Trace<dim>       &trace)
    {
      const Partner<dim> &partner = paired.partner;
      ContactPoint<dim>   point;
      point.position = patch.position(paired.xi);
      point.normal   = partner.normal;
      point.weight   = paired.weight;
      point.gap =
        initial_gap(pair, point.position, (point.position - partner.position) * partner.normal);
      point.stiffness = 1 / (1 / stiffness + 1 / partner.stiffness);
      point.row       = trace.normal_displacement(unit_point, partner.normal);
      for (const auto &[index, value] : partner.row)
        point.row.emplace_back(index, -value);
      unite(point.row);
      point.face = paired.face;
      return point;
    }

    /// The mean of both bodies' stresses whose bound is the smallest: they count by the inverse of
    /// their bounds, so that a stiff body does not matter beside a soft one, whichever is the slave
    /// (Annavarapu, Hautefeuille, Dolbow, Comput. Methods Appl. Mech. Engrg. 225-228 (2012) 44-54).
    template <int dim>
    void
    set_stress(const SparseRow    &own,
               const double        own_bound,
               const Partner<dim> &partner,
               const bool          own_alone,
               ContactPoint<dim>  &point)
    {
      const double share =
        own_alone || std::isinf(partner.bound) ? 1. : partner.bound / (own_bound + partner.bound);
      for (const auto &[index, value] : own)
        point.stress.emplace_back(index, share * value);
      if (share < 1)
        for (const auto &[index, value] : partner.stress)
          point.stress.emplace_back(index, (1 - share) * value);
      unite(point.stress);
      point.bound = share * own_bound;
    }

    /// True if the displacement of a cell's node in direction n is prescribed, or nearly so.
    template <int dim>
    bool
    is_prescribed(const Elasticity<dim>                      &elasticity,
                  const std::vector<types::global_dof_index> &indices,
                  const unsigned int                          node,
                  const Tensor<1, dim>                       &n)
    {
      double can_move2 = 0;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto dof = indices[elasticity.finite_element().component_to_system_index(d, node)];
          if (!elasticity.constraints().is_constrained(dof) ||
              elasticity.hanging_nodes().is_constrained(dof))
            can_move2 += n[d] * n[d];
        }
      return can_move2 < 0.01;
    }

    template <int dim>
    std::vector<FaceNode>
    face_nodes(const Elasticity<dim> &elasticity,
               const Cell<dim>       &cell,
               const unsigned int     face,
               const FacePatch<dim>  &patch)
    {
      const auto                          &fe = elasticity.finite_element();
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      std::vector<FaceNode> nodes;
      for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
        {
          const unsigned int first = fe.component_to_system_index(0, i);
          if (!fe.has_support_on_face(first, face))
            continue;
          FaceNode         node{indices[first], {{0, 0}}, false};
          Point<dim - 1>   xi;
          const Point<dim> place = fe.base_element(0).unit_support_point(i);
          for (unsigned int d = 0; d < dim - 1; ++d)
            node.xi[d] = xi[d] = place[(face / 2 + 1 + d) % dim]; // see unit_point()
          node.prescribed = is_prescribed(elasticity, indices, i, patch.normal(xi));
          nodes.push_back(node);
        }
      return nodes;
    }

    /// The slave side of a pair on this rank.
    template <int dim>
    struct Slave
    {
      Faces<dim>                  faces;
      std::vector<FacePatch<dim>> patches;
    };

    /// The contact points of paired points, which are sorted by faces; all but the functions of the
    /// pressure.
    template <int dim>
    std::vector<ContactPoint<dim>>
    contact_points(const Elasticity<dim>               &elasticity,
                   const ContactPair<dim>              &pair,
                   const ContactMethod                 &method,
                   const Slave<dim>                    &slave,
                   const std::vector<PairedPoint<dim>> &paired_points)
    {
      std::vector<ContactPoint<dim>> result;
      result.reserve(paired_points.size());
      double            face_depth = 0, face_stiffness = 0;
      Trace<dim>        trace(elasticity);
      NormalStress<dim> stress(elasticity);
      StressBounds<dim> bound(slave.faces);
      const bool        with_stress = method.predictor() == Predictor::normal_stress;
      for (const PairedPoint<dim> &paired : paired_points)
        {
          const auto &[cell, face] = slave.faces[paired.face];
          const auto      &patch   = slave.patches[paired.face];
          const Point<dim> place   = unit_point<dim>(face, paired.xi);
          const bool       is_new  = result.empty() || result.back().face != paired.face;
          if (is_new)
            {
              trace.reinit(cell, face);
              face_stiffness = stiffness<dim>(elasticity, cell, face);
              face_depth     = depth<dim>(cell, face);
            }
          result.push_back(contact_point(pair, patch, paired, place, face_stiffness, trace));
          result.back().depth = face_depth;
          if (!with_stress)
            continue;
          if (is_new)
            stress.reinit(cell);
          set_stress(stress.row(place, paired.partner.normal, patch.normal(paired.xi)),
                     bound(stress, paired.face),
                     paired.partner,
                     method.unbiased(),
                     result.back());
        }
      return result;
    }

    /// Sets the functions of the pressure at the points. Returns the number of faces that can carry
    /// none, since the displacement of all their nodes is prescribed.
    template <int dim>
    unsigned int
    set_shapes(const Elasticity<dim>               &elasticity,
               const ContactMethod                 &method,
               const Basis                          kind,
               const Slave<dim>                    &slave,
               const std::vector<PairedPoint<dim>> &paired_points,
               std::vector<ContactPoint<dim>>      &points)
    {
      // Otherwise a law says what the pressure is, even where nothing can move.
      const bool must_balance = method.predictor() == Predictor::multiplier ||
                                method.predictor() == Predictor::last_pressure;
      Trace<dim>             trace(elasticity);
      std::vector<SparseRow> shapes;
      std::vector<double>    weights;
      unsigned int           n_prescribed = 0;
      for (unsigned int first = 0, last = 0; first < points.size(); first = last)
        {
          const auto &[cell, face] = slave.faces[points[first].face];
          trace.reinit(cell, face);
          shapes.clear();
          weights.clear();
          for (; last < points.size() && points[last].face == points[first].face; ++last)
            {
              shapes.push_back(
                trace.unresolved_shape(unit_point<dim>(face, paired_points[last].xi)));
              weights.push_back(points[last].weight);
            }
          auto       nodes = face_nodes(elasticity, cell, face, slave.patches[points[first].face]);
          const bool all_prescribed = std::all_of(nodes.begin(), nodes.end(), [](const auto &node) {
            return node.prescribed;
          });
          if (all_prescribed && !must_balance)
            for (FaceNode &node : nodes)
              node.prescribed = false;
          const PressureBasis basis(nodes, shapes, weights, kind);
          const PressureBasis standard(nodes, shapes, weights, Basis::standard);
          n_prescribed += basis.empty();
          for (unsigned int q = first; q < last; ++q)
            {
              points[q].shape = basis.at(shapes[q - first]);
              resolve(elasticity.hanging_nodes(), points[q].shape);
              if (kind == Basis::standard)
                continue;
              points[q].interpolation = standard.at(shapes[q - first]);
              resolve(elasticity.hanging_nodes(), points[q].interpolation);
            }
        }
      return n_prescribed;
    }

    template <int dim>
    bool
    has_shapes(const std::vector<ContactPoint<dim>> &points)
    {
      return std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !point.shape.empty();
      });
    }

    template <int dim>
    void
    check_gaps(const ContactPair<dim>               &pair,
               const std::vector<ContactPoint<dim>> &points,
               const MPI_Comm                        comm)
    {
      const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !std::isfinite(point.gap);
      });
      if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
        throw SceneError(pair.slave_place + ": Initial gap = " + pair.initial_gap +
                         " is not a number somewhere on '" + pair.slave + "'; correct the formula");
    }

    template <int dim>
    std::vector<std::pair<SparseRow, double>>
    whole_faces(const Elasticity<dim> &elasticity, const Slave<dim> &slave)
    {
      std::vector<std::pair<SparseRow, double>> result;
      Trace<dim>                                trace(elasticity);
      const QGauss<dim - 1>                     rule(elasticity.finite_element().degree + 1);
      for (unsigned int i = 0; i < slave.faces.size(); ++i)
        {
          trace.reinit(slave.faces[i].first, slave.faces[i].second);
          for (unsigned int q = 0; q < rule.size(); ++q)
            result.emplace_back(trace.shape(unit_point<dim>(slave.faces[i].second, rule.point(q))),
                                rule.weight(q) * slave.patches[i].jacobian(rule.point(q)));
        }
      return result;
    }

    /// With the pair's slave and master as they are.
    template <int dim>
    ContactSurface<dim>
    one_sided(const Elasticity<dim>  &elasticity,
              const ContactPair<dim> &pair,
              const Obstacle<dim>    *obstacle,
              const ContactMethod    &method,
              const Integration      &integration)
    {
      const MPI_Comm      comm = elasticity.mesh().communicator();
      ContactSurface<dim> surface;
      Slave<dim>          slave;
      slave.faces   = owned_faces(elasticity, pair.slave);
      slave.patches = patches(elasticity, slave.faces);
      surface.faces = slave.faces.size();
      const double limit =
        pair.search_distance > 0 ? pair.search_distance : elasticity.mesh().size() / 10;
      auto paired = obstacle ?
                      obstacle_points(slave.patches, *obstacle, integration, limit) :
                      pair_points(slave.patches,
                                  master_faces(elasticity,
                                               owned_faces(elasticity, pair.master),
                                               method.predictor() == Predictor::normal_stress),
                                  integration,
                                  limit,
                                  comm,
                                  surface.statistics);
      drop_empty_points(slave.patches, paired);
      surface.points = contact_points(elasticity, pair, method, slave, paired);
      check_gaps(pair, surface.points, comm);
      const auto n_prescribed =
        set_shapes(elasticity, method, integration.basis, slave, paired, surface.points);
      const bool some_prescribed = Utilities::MPI::max(n_prescribed, comm) > 0,
                 some_free = Utilities::MPI::max(has_shapes(surface.points) ? 1 : 0, comm) > 0;
      if (some_prescribed && (!obstacle || !some_free))
        throw SceneError(
          pair.slave_place + ": the displacement of faces of '" + pair.slave +
          "' is prescribed along the normal at all their nodes, so that they cannot carry an "
          "unknown pressure; exchange Slave and Master, or take Contact method/Method = penalty");
      surface.whole = whole_faces(elasticity, slave);
      return surface;
    }

    /// Adds the points of the master as slave.
    template <int dim>
    void
    add_other_side(ContactSurface<dim> &surface, const ContactSurface<dim> &other)
    {
      for (const ContactPoint<dim> &point : other.points)
        {
          surface.points.push_back(point);
          surface.points.back().face += surface.faces;
          surface.points.back().normal *= -1;
        }
      surface.whole.insert(surface.whole.end(), other.whole.begin(), other.whole.end());
      for (ContactPoint<dim> &point : surface.points)
        point.weight /= 2;
      for (auto &entry : surface.whole)
        entry.second /= 2;
      surface.faces += other.faces;
    }
  } // namespace



  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, const MPI_Comm comm)
  {
    double covered = 0, whole = 0;
    for (const auto &point : surface.points)
      covered += point.weight;
    for (const auto &[shape, weight] : surface.whole)
      whole += weight;
    return Utilities::MPI::sum(covered, comm) / Utilities::MPI::sum(whole, comm);
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration)
  {
    ContactSurface<dim> surface = one_sided(elasticity, pair, obstacle, method, integration);
    if (method.unbiased() && !obstacle)
      {
        ContactPair<dim> other = pair;
        std::swap(other.slave, other.master);
        add_other_side(surface, one_sided<dim>(elasticity, other, nullptr, method, integration));
      }
    return surface;
  }



  template double
  covered_share(const ContactSurface<2> &, MPI_Comm);
  template double
  covered_share(const ContactSurface<3> &, MPI_Comm);
  template ContactSurface<2>
  make_contact_surface(const Elasticity<2> &,
                       const ContactPair<2> &,
                       const Obstacle<2> *,
                       const ContactMethod &,
                       const Integration &);
  template ContactSurface<3>
  make_contact_surface(const Elasticity<3> &,
                       const ContactPair<3> &,
                       const Obstacle<3> *,
                       const ContactMethod &,
                       const Integration &);
} // namespace Signorini
