// SPDX-License-Identifier: Apache-2.0
#include "fields/recovered_pressure.h"

#include "fields/nodal_fields.h"
#include "fields/recovery_steps.h"
#include "fields/surface_gradient.h"
#include "geometry/face_functions.h"

#include <array>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int max_steps = 200;
    constexpr double       enough    = 1e-9; // of the largest pressure, that a step changes

    /// The iteration of recovered_pressure() for faces of degree 2. Fields have one value for each
    /// vertex of the slave faces (FaceVertices); m_v and the like are means weighted with the
    /// linear function phi_v of a vertex.
    template <int dim>
    class Recovery
    {
    public:
      /// Integrate the functions over the contact points: areas, offsets and the matrices of the
      /// faces. Collective.
      /// @param values the density on the rows of the gap operator
      Recovery(const Snapshot<dim> &s, const unsigned int pair, const LA::Vector &values)
        : s(s)
        , surface(s.surfaces[pair])
        , by_row(values)
        , raw(s.elasticity.with_ghosts(nodal_field(s, values, pair)))
        , status(s.elasticity.with_ghosts(nodal_field(s, s.active, pair)))
        , number_of_pair(pair)
        , vertices(s.elasticity, surface.slave_faces)
        , matrices(surface.slave_faces.size())
      {
        area = open_area = part_area = vertices.zero();
        offset.assign(dim, vertices.zero());
        for (const ContactPoint<dim> &point : surface.points)
          {
            const unsigned int    f       = point.face;
            const SlaveFace<dim> &face    = surface.slave_faces[f];
            const bool            is_open = is_at_edge(face);
            const Functions       at(face.reference_cell(), point.xi);
            add_to_matrices(point, at);
            for (unsigned int c = 0; c < n; ++c)
              {
                const double w = point.weight * at.value[c];
                area(vertices[f][c]) += w;
                if (is_open)
                  open_area(vertices[f][c]) += w;
                if (is_part(face))
                  part_area(vertices[f][c]) += w;
                for (unsigned int d = 0; d < dim; ++d)
                  offset[d](vertices[f][c]) +=
                    w * (point.slave_force_point[d] - Vertices::position(face, c)[d]);
              }
          }
        area.compress(VectorOperation::add);
        open_area.compress(VectorOperation::add);
        part_area.compress(VectorOperation::add);
        for (Field &component : offset)
          divide(component);
      }

      /// @return the recovered nodal pressure. The fixed-point iteration contracts on all but very
      /// irregular meshes. It ends if a step changes less than 1e-9 of the largest pressure, if the
      /// steps grow (then the means themselves are the result), or after 200 steps. Each step costs
      /// a few vectors of the surface. Collective.
      LA::Vector
      run() const
      {
        const Field        means    = mean_pressure();
        const double       most     = means.linfty_norm();
        Field              q        = means;
        std::vector<Field> gradient = mean_gradients(q);
        double             before   = std::numeric_limits<double>::max();
        for (unsigned int step = 0; step < max_steps; ++step)
          {
            gradient         = corrected(mean_gradients(q), gradient);
            const Field next = keep_at_edges(next_guess(q, means, gradient), means);
            q -= next;
            const double change = q.linfty_norm();
            // The iteration does not contract on this mesh: the means themselves are taken.
            if (step > 4 && change >= before)
              return with_nodes_between(means, gradient);
            q = next;
            if (change <= enough * most)
              break;
            before = change;
          }
        return with_nodes_between(q, gradient);
      }

    private:
      using Vertices  = FaceVertices<dim>;
      using Functions = typename Vertices::Functions;
      using Field     = typename Vertices::Field;

      static constexpr unsigned int n = Vertices::n;

      /// The integrals of the linear functions of a face: int phi_c phi_e dA, int phi_c grad phi_e
      /// dA.
      struct FaceMatrices
      {
        std::array<std::array<double, n>, n>         mass{};
        std::array<std::array<Tensor<1, dim>, n>, n> gradient{};
      };

      /// Add a contact point to the matrices of its face.
      void
      add_to_matrices(const ContactPoint<dim> &point, const Functions &at)
      {
        const SlaveFace<dim>               &face = surface.slave_faces[point.face];
        std::array<Tensor<1, dim>, dim - 1> tangents;
        for (unsigned int c = 0; c < n; ++c)
          for (unsigned int d = 0; d < dim - 1; ++d)
            tangents[d] += at.slope[c][d] * Tensor<1, dim>(Vertices::position(face, c));
        FaceMatrices &matrix = matrices[point.face];
        for (unsigned int e = 0; e < n; ++e)
          {
            const Tensor<1, dim> gradient = surface_gradient<dim>(tangents, at.slope[e]);
            for (unsigned int c = 0; c < n; ++c)
              {
                matrix.mass[c][e] += point.weight * at.value[c] * at.value[e];
                matrix.gradient[c][e] += point.weight * at.value[c] * gradient;
              }
          }
      }

      /// @return whether a node is not entirely in contact.
      bool
      is_open(const types::global_dof_index node) const
      {
        return status(node) < 1 - 1e-6;
      }

      /// @return whether a face has a node that is not in contact.
      bool
      has_open_node(const SlaveFace<dim> &face) const
      {
        for (const auto node : face.nodes)
          if (is_open(node))
            return true;
        return false;
      }

      /// @return whether the master covers the face only partly, so that values at vertices would
      /// be extrapolations.
      static bool
      is_part(const SlaveFace<dim> &face)
      {
        constexpr double nearly_whole = 0.9;
        return face.covered < nearly_whole;
      }

      /// @return whether the face is at the edge of the contact area or of the master.
      bool
      is_at_edge(const SlaveFace<dim> &face) const
      {
        return is_part(face) || has_open_node(face);
      }

      /// Divide an integral by the area of the vertex functions; zero where there is no area.
      /// Collective.
      void
      divide(Field &integral) const
      {
        integral.compress(VectorOperation::add);
        for (unsigned int k = 0; k < integral.locally_owned_size(); ++k)
          integral.local_element(k) =
            area.local_element(k) > 0 ? integral.local_element(k) / area.local_element(k) : 0.;
      }

      /// @return the means m of the computed pressure. In the dual basis int phi_i lambda dA = p_i
      /// int phi_i dA on each face, so that the means follow from the coefficients without the dual
      /// functions. Collective.
      Field
      mean_pressure() const
      {
        Field result = vertices.zero();
        // Points have rows of their own.
        const bool at_nodes = samples_nodes(s.contact);
        auto       row      = first_row(s, number_of_pair);
        for (const ContactPoint<dim> &point : surface.points)
          {
            const SlaveFace<dim>    &face    = surface.slave_faces[point.face];
            const bool               is_dual = !point.interpolation.empty();
            const Functions          at(face.reference_cell(), point.xi);
            const FaceFunctions<dim> shape(face.reference_cell(), face.degree, point.xi);
            double                   own = 0;
            if (!at_nodes)
              own = by_row(row++);
            else if (!is_dual)
              for (unsigned int i = 0; i < shape.size(); ++i)
                own += shape.value(i) * raw(face.nodes[i]);
            for (unsigned int c = 0; c < n; ++c)
              {
                double weighted = at.value[c] * own;
                if (at_nodes && is_dual)
                  for (unsigned int i = 0; i < shape.size(); ++i)
                    weighted += share(c, i, face) * shape.value(i) * raw(face.nodes[i]);
                result(vertices[point.face][c]) += point.weight * weighted;
              }
          }
        divide(result);
        return result;
      }

      /// @return the value of the linear function of corner c at node i.
      static double
      share(const unsigned int c, const unsigned int i, const SlaveFace<dim> &face)
      {
        const auto shape = face.reference_cell();
        return Functions(shape, face_lattice<dim>(shape, face.degree)[i]).value[c];
      }

      /// @return the means of the linear interpolant of a field. Collective.
      Field
      means_of_linear(const Field &field) const
      {
        const Field q      = Vertices::with_ghosts(field);
        Field       result = vertices.zero();
        for (unsigned int f = 0; f < matrices.size(); ++f)
          if (surface.slave_faces[f].degree > 0)
            for (unsigned int c = 0; c < n; ++c)
              for (unsigned int e = 0; e < n; ++e)
                result(vertices[f][c]) += matrices[f].mass[c][e] * q(vertices[f][e]);
        divide(result);
        return result;
      }

      /// @return the means of the surface gradients of the linear interpolant of a field, component
      /// by component. Collective.
      std::vector<Field>
      mean_gradients(const Field &field) const
      {
        const Field        q = Vertices::with_ghosts(field);
        std::vector<Field> result(dim, vertices.zero());
        for (unsigned int f = 0; f < matrices.size(); ++f)
          if (surface.slave_faces[f].degree > 0)
            for (unsigned int c = 0; c < n; ++c)
              {
                Tensor<1, dim> sum;
                for (unsigned int e = 0; e < n; ++e)
                  sum += q(vertices[f][e]) * matrices[f].gradient[c][e];
                for (unsigned int d = 0; d < dim; ++d)
                  result[d](vertices[f][c]) += sum[d];
              }
        for (Field &component : result)
          divide(component);
        return result;
      }

      /// @return gradients at the vertices. The means of the gradients of the linear interpolant
      /// are gradients at the offsets d, those along d at 3/2 d; the difference is corrected by the
      /// gradient of the last iterate. At faces that are covered partly the means are returned:
      /// with offsets of more than half a face the correction would grow from step to step.
      std::vector<Field>
      corrected(std::vector<Field> means, const std::vector<Field> &gradient) const
      {
        std::vector<Field> change(dim, vertices.zero());
        for (unsigned int d = 0; d < dim; ++d)
          {
            std::vector<Field> curvature = mean_gradients(gradient[d]);
            for (unsigned int e = 0; e < dim; ++e)
              {
                curvature[e].scale(offset[e]);
                change[d] += curvature[e];
              }
          }
        for (unsigned int k = 0; k < area.locally_owned_size(); ++k)
          {
            if (part_area.local_element(k) > 0)
              continue;
            double along = 0, square = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                along += change[d].local_element(k) * offset[d].local_element(k);
                square += std::pow(offset[d].local_element(k), 2);
              }
            for (unsigned int d = 0; d < dim; ++d)
              means[d].local_element(k) -=
                change[d].local_element(k) +
                (square > 0 ? 0.5 * along / square * offset[d].local_element(k) : 0.);
          }
        return means;
      }

      /// @return the next iterate m - (M q - q), see recovered_pressure().
      Field
      next_guess(const Field &q, const Field &means, const std::vector<Field> &gradient) const
      {
        Field excess = means_of_linear(q); // M q - q
        excess -= q;
        for (unsigned int d = 0; d < dim; ++d)
          {
            Field along = gradient[d];
            along.scale(offset[d]);
            excess += along;
          }
        excess *= -0.5;
        excess += means;
        return excess;
      }

      /// @return a field with the values of another one at vertices of faces at the edge of
      /// contact.
      Field
      keep_at_edges(Field inside, const Field &at_edges) const
      {
        for (unsigned int k = 0; k < inside.locally_owned_size(); ++k)
          if (open_area.local_element(k) > 0)
            inside.local_element(k) = at_edges.local_element(k);
        return inside;
      }

      /// @return the nodal field, as the mean over faces, from values and gradients at vertices;
      /// zero at open nodes. Collective.
      LA::Vector
      with_nodes_between(const Field &field, const std::vector<Field> &gradient) const
      {
        const Field        q      = Vertices::with_ghosts(field);
        std::vector<Field> slopes = gradient; // copies have no ghosts
        for (const Field &component : slopes)
          component.update_ghost_values();
        // The mean over the faces of each node.
        LA::Vector sum = s.elasticity.zero_vector(), count = sum;
        for (unsigned int f = 0; f < surface.slave_faces.size(); ++f)
          {
            const SlaveFace<dim>     &face = surface.slave_faces[f];
            const std::vector<double> values =
              face.degree == 2 ? hermite_values(face, vertices[f], !is_at_edge(face), q, slopes) :
                                 values_of(face.nodes);
            for (unsigned int i = 0; i < values.size(); ++i)
              {
                sum(face.nodes[i]) += is_open(face.nodes[i]) ? 0. : values[i];
                count(face.nodes[i]) += 1;
              }
          }
        for (LA::Vector *v : {&sum, &count})
          v->compress(VectorOperation::add);
        for (const auto i : sum.locally_owned_elements())
          if (count(i) > 0)
            sum(i) /= count(i);
        sum.compress(VectorOperation::insert);
        s.elasticity.hanging_nodes().distribute(sum);
        return sum;
      }

      /// @return the nodal pressures of some nodes.
      std::vector<double>
      values_of(const std::vector<types::global_dof_index> &nodes) const
      {
        std::vector<double> result;
        for (const auto node : nodes)
          result.push_back(raw(node));
        return result;
      }

      const Snapshot<dim>       &s;
      const ContactSurface<dim> &surface;
      const LA::Vector          &by_row;
      /// Nodal density and status, with ghost values.
      const LA::Vector   raw, status;
      const unsigned int number_of_pair;
      const Vertices     vertices;
      /// For each vertex int phi_v dA, that over faces at an edge, and that over faces that are
      /// covered partly.
      Field area, open_area, part_area;
      /// The offsets d of the vertex functions, component by component.
      std::vector<Field> offset;
      /// The matrices of all slave faces.
      std::vector<FaceMatrices> matrices;
    };
  } // namespace



  template <int dim>
  LA::Vector
  recovered_density(const Snapshot<dim> &s,
                    const unsigned int   pair,
                    const LA::Vector    &values,
                    const bool           is_positive)
  {
    unsigned int degree = 0;
    for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
      degree = std::max(degree, face.degree);
    const LA::Vector raw    = nodal_field(s, values, pair);
    LA::Vector       result = Utilities::MPI::max(degree, s.elasticity.mesh().communicator()) < 2 ?
                                raw :
                                Recovery<dim>(s, pair, values).run();
    extrapolate_to_dirichlet_nodes(s, pair, raw, is_positive, result);
    to_present_areas(s, pair, result);
    fill_between(s, pair, result);
    return result;
  }



  // Computed once for each pair and stored in the snapshot.
  template <int dim>
  const LA::Vector &
  recovered_pressure(const Snapshot<dim> &s, const unsigned int pair)
  {
    const auto [place, is_new] = s.recovered->try_emplace(pair);
    if (is_new)
      place->second = recovered_density(s, pair, s.pressure, s.pairs[pair].can_separate);
    return place->second;
  }



  template const LA::Vector &
  recovered_pressure(const Snapshot<2> &, unsigned int);
  template const LA::Vector &
  recovered_pressure(const Snapshot<3> &, unsigned int);
  template LA::Vector
  recovered_density(const Snapshot<2> &, unsigned int, const LA::Vector &, bool);
  template LA::Vector
  recovered_density(const Snapshot<3> &, unsigned int, const LA::Vector &, bool);
} // namespace Signorini
