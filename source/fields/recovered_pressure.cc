#include <signorini/contact/lagrange.h>
#include <signorini/fields/nodal_fields.h>
#include <signorini/fields/recovered_pressure.h>

#include <array>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int max_steps = 40;
    constexpr double       enough    = 1e-9; // of the largest pressure, that a step changes

    template <int dim>
    constexpr unsigned int n_corners = dim == 2 ? 2 : 4;

    /// The linear functions of the corners of a face and their derivatives, at a parameter.
    template <int dim>
    struct Corners
    {
      std::array<double, n_corners<dim>>             value;
      std::array<Tensor<1, dim - 1>, n_corners<dim>> slope;

      explicit Corners(const Point<dim - 1> &xi)
      {
        const auto x = lagrange(1, xi[0]), y = lagrange(1, xi[dim - 2]);
        for (unsigned int c = 0; c < n_corners<dim>; ++c)
          {
            const unsigned int i = c % 2, j = c / 2;
            value[c]    = x[i][0] * (dim == 3 ? y[j][0] : 1.);
            slope[c][0] = x[i][1] * (dim == 3 ? y[j][0] : 1.);
            if (dim == 3)
              slope[c][dim - 2] = x[i][0] * y[j][1];
          }
      }
    };

    /// The number of a corner among the nodes of a face.
    template <int dim>
    unsigned int
    node_of_corner(const unsigned int corner, const unsigned int degree)
    {
      return degree * (corner % 2) + (corner / 2) * degree * (degree + 1);
    }

    /// Means over the linear functions of the vertices, on the layout of the displacement.
    template <int dim>
    class Recovery
    {
    public:
      Recovery(const Snapshot<dim> &s, const unsigned int pair)
        : s(s)
        , surface(s.surfaces[pair])
        , raw(s.elasticity.with_ghosts(nodal_field(s, s.pressure, pair)))
        , status(s.elasticity.with_ghosts(nodal_field(s, s.active, pair)))
        , area(s.elasticity.zero_vector())
        , open_area(s.elasticity.zero_vector())
        , offset(dim, s.elasticity.zero_vector())
        , matrices(surface.slave_faces.size())
      {
        // Of points, which have rows of their own.
        if (!samples_nodes(s.contact))
          {
            first_row = s.pressure.local_range().first;
            for (unsigned int p = 0; p < pair; ++p)
              first_row += s.surfaces[p].points.size();
          }
        for (const ContactPoint<dim> &point : surface.points)
          {
            const SlaveFace<dim> &face    = surface.slave_faces[point.face];
            const bool            is_open = has_open_node(face);
            const Corners<dim>    at(point.xi);
            add_to_matrices(point, at);
            for (unsigned int c = 0; c < n; ++c)
              {
                const auto   v = vertex(face, c);
                const double w = point.weight * at.value[c];
                area(v) += w;
                if (is_open)
                  open_area(v) += w;
                for (unsigned int d = 0; d < dim; ++d)
                  offset[d](v) += w * (point.position[d] - corner(face, c)[d]);
              }
          }
        area.compress(VectorOperation::add);
        open_area.compress(VectorOperation::add);
        for (LA::Vector &component : offset)
          divide(component);
      }

      LA::Vector
      run() const
      {
        const LA::Vector        means    = mean_pressure();
        const double            most     = means.linfty_norm();
        LA::Vector              q        = means;
        std::vector<LA::Vector> gradient = mean_gradients(q);
        double                  before   = std::numeric_limits<double>::max();
        for (unsigned int step = 0; step < max_steps; ++step)
          {
            gradient              = corrected(mean_gradients(q), gradient);
            const LA::Vector next = keep_at_edges(next_guess(q, means, gradient), means);
            q -= next;
            const double change = q.linfty_norm();
            // On meshes that are too irregular for it, what was reached.
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
      static constexpr unsigned int n = n_corners<dim>;

      /// Of the linear functions of a face: int phi_c phi_e dA, int phi_c grad phi_e dA.
      struct FaceMatrices
      {
        std::array<std::array<double, n>, n>         mass{};
        std::array<std::array<Tensor<1, dim>, n>, n> gradient{};
      };

      void
      add_to_matrices(const ContactPoint<dim> &point, const Corners<dim> &at)
      {
        const SlaveFace<dim>               &face = surface.slave_faces[point.face];
        std::array<Tensor<1, dim>, dim - 1> tangents;
        for (unsigned int c = 0; c < n; ++c)
          for (unsigned int d = 0; d < dim - 1; ++d)
            tangents[d] += at.slope[c][d] * Tensor<1, dim>(corner(face, c));
        Tensor<2, dim - 1> metric;
        for (unsigned int d = 0; d < dim - 1; ++d)
          for (unsigned int e = 0; e < dim - 1; ++e)
            metric[d][e] = tangents[d] * tangents[e];
        const Tensor<2, dim - 1> inverse = invert(metric);
        FaceMatrices            &matrix  = matrices[point.face];
        for (unsigned int e = 0; e < n; ++e)
          {
            const Tensor<1, dim - 1> raised = inverse * at.slope[e];
            Tensor<1, dim>           gradient;
            for (unsigned int d = 0; d < dim - 1; ++d)
              gradient += raised[d] * tangents[d];
            for (unsigned int c = 0; c < n; ++c)
              {
                matrix.mass[c][e] += point.weight * at.value[c] * at.value[e];
                matrix.gradient[c][e] += point.weight * at.value[c] * gradient;
              }
          }
      }

      static types::global_dof_index
      vertex(const SlaveFace<dim> &face, const unsigned int c)
      {
        return face.nodes[node_of_corner<dim>(c, face.degree)];
      }

      static const Point<dim> &
      corner(const SlaveFace<dim> &face, const unsigned int c)
      {
        return face.positions[node_of_corner<dim>(c, face.degree)];
      }

      bool
      is_open(const types::global_dof_index node) const
      {
        return status(node) < 1 - 1e-6;
      }

      bool
      has_open_node(const SlaveFace<dim> &face) const
      {
        for (const auto node : face.nodes)
          if (is_open(node))
            return true;
        return false;
      }

      /// From an integral to a mean, zero where there is no area.
      void
      divide(LA::Vector &integral) const
      {
        integral.compress(VectorOperation::add);
        for (const auto i : integral.locally_owned_elements())
          integral(i) = area(i) > 0 ? integral(i) / area(i) : 0.;
        integral.compress(VectorOperation::insert);
      }

      /// Of a pressure in the dual basis int phi_i lambda dA = p_i int phi_i dA on each face.
      LA::Vector
      mean_pressure() const
      {
        LA::Vector   result = s.elasticity.zero_vector();
        unsigned int q      = 0;
        for (const ContactPoint<dim> &point : surface.points)
          {
            const SlaveFace<dim> &face    = surface.slave_faces[point.face];
            const bool            is_dual = !point.interpolation.empty();
            const Corners<dim>    at(point.xi);
            const auto            shape = node_functions(face.degree, point.xi);
            double                own   = 0;
            if (!samples_nodes_here())
              own = s.pressure(first_row + q);
            else if (!is_dual)
              for (unsigned int i = 0; i < shape.size(); ++i)
                own += shape[i] * raw(face.nodes[i]);
            for (unsigned int c = 0; c < n; ++c)
              {
                double weighted = at.value[c] * own;
                if (samples_nodes_here() && is_dual)
                  for (unsigned int i = 0; i < shape.size(); ++i)
                    weighted += share(c, i, face.degree) * shape[i] * raw(face.nodes[i]);
                result(vertex(face, c)) += point.weight * weighted;
              }
            ++q;
          }
        divide(result);
        return result;
      }

      bool
      samples_nodes_here() const
      {
        return first_row == numbers::invalid_dof_index;
      }

      /// Value of the linear function of corner c at node i.
      static double
      share(const unsigned int c, const unsigned int i, const unsigned int degree)
      {
        Point<dim - 1> xi;
        xi[dim - 2] = double(i / (degree + 1)) / degree;
        xi[0]       = double(i % (degree + 1)) / degree;
        return Corners<dim>(xi).value[c];
      }

      static std::vector<double>
      node_functions(const unsigned int degree, const Point<dim - 1> &xi)
      {
        const auto          x = lagrange(degree, xi[0]), y = lagrange(degree, xi[dim - 2]);
        std::vector<double> result;
        for (unsigned int j = 0; j <= (dim == 3 ? degree : 0); ++j)
          for (unsigned int i = 0; i <= degree; ++i)
            result.push_back(x[i][0] * (dim == 3 ? y[j][0] : 1.));
        return result;
      }

      LA::Vector
      means_of_linear(const LA::Vector &vertices) const
      {
        const LA::Vector q      = s.elasticity.with_ghosts(vertices);
        LA::Vector       result = s.elasticity.zero_vector();
        for (unsigned int f = 0; f < matrices.size(); ++f)
          if (const SlaveFace<dim> &face = surface.slave_faces[f]; face.degree > 0)
            for (unsigned int c = 0; c < n; ++c)
              for (unsigned int e = 0; e < n; ++e)
                result(vertex(face, c)) += matrices[f].mass[c][e] * q(vertex(face, e));
        divide(result);
        return result;
      }

      /// Along the surface, of the linear interpolant, means at the vertices.
      std::vector<LA::Vector>
      mean_gradients(const LA::Vector &vertices) const
      {
        const LA::Vector        q = s.elasticity.with_ghosts(vertices);
        std::vector<LA::Vector> result(dim, s.elasticity.zero_vector());
        for (unsigned int f = 0; f < matrices.size(); ++f)
          if (const SlaveFace<dim> &face = surface.slave_faces[f]; face.degree > 0)
            for (unsigned int c = 0; c < n; ++c)
              {
                Tensor<1, dim> sum;
                for (unsigned int e = 0; e < n; ++e)
                  sum += q(vertex(face, e)) * matrices[f].gradient[c][e];
                for (unsigned int d = 0; d < dim; ++d)
                  result[d](vertex(face, c)) += sum[d];
              }
        for (LA::Vector &component : result)
          divide(component);
        return result;
      }

      /// The means of the linear interpolant's gradients are gradients at the offsets d, those
      /// along d at 3/2 d.
      std::vector<LA::Vector>
      corrected(std::vector<LA::Vector> means, const std::vector<LA::Vector> &gradient) const
      {
        std::vector<LA::Vector> change(dim, s.elasticity.zero_vector());
        for (unsigned int d = 0; d < dim; ++d)
          {
            std::vector<LA::Vector> curvature = mean_gradients(gradient[d]);
            for (unsigned int e = 0; e < dim; ++e)
              {
                curvature[e].scale(offset[e]);
                change[d] += curvature[e];
              }
          }
        for (const auto i : area.locally_owned_elements())
          {
            double along = 0, square = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                along += change[d](i) * offset[d](i);
                square += offset[d](i) * offset[d](i);
              }
            for (unsigned int d = 0; d < dim; ++d)
              means[d](i) -= change[d](i) + (square > 0 ? 0.5 * along / square * offset[d](i) : 0.);
          }
        for (LA::Vector &component : means)
          component.compress(VectorOperation::add);
        return means;
      }

      LA::Vector
      next_guess(const LA::Vector              &q,
                 const LA::Vector              &means,
                 const std::vector<LA::Vector> &gradient) const
      {
        LA::Vector excess = means_of_linear(q); // M q - q
        excess -= q;
        for (unsigned int d = 0; d < dim; ++d)
          {
            LA::Vector along = gradient[d];
            along.scale(offset[d]);
            excess += along;
          }
        excess *= -0.5;
        excess += means;
        return excess;
      }

      LA::Vector
      keep_at_edges(const LA::Vector &inside, const LA::Vector &at_edges) const
      {
        LA::Vector result = inside;
        for (const auto i : result.locally_owned_elements())
          if (open_area(i) > 0)
            result(i) = at_edges(i);
        result.compress(VectorOperation::insert);
        return result;
      }

      /// Values at the nodes of a face from those at its corners.
      std::vector<double>
      values_on(const SlaveFace<dim>          &face,
                const LA::Vector              &q,
                const std::vector<LA::Vector> &gradient) const
      {
        const bool          is_smooth = !has_open_node(face);
        const unsigned int  k = face.degree, rows = dim == 3 ? k + 1 : 1;
        std::vector<double> values(face.nodes.size());
        for (unsigned int c = 0; c < n; ++c)
          values[node_of_corner<dim>(c, k)] = q(vertex(face, c));
        const auto middle = [&](const unsigned int a, const unsigned int b, const unsigned int m) {
          double               bend = 0;
          const Tensor<1, dim> way  = face.positions[b] - face.positions[a];
          for (unsigned int d = 0; d < dim; ++d)
            bend += (gradient[d](face.nodes[a]) - gradient[d](face.nodes[b])) * way[d];
          values[m] = (values[a] + values[b]) / 2 + (is_smooth ? bend / 8 : 0.);
        };
        for (unsigned int j = 0; j < rows; j += k)
          middle(j * (k + 1), j * (k + 1) + k, j * (k + 1) + 1);
        if (dim == 3)
          {
            for (unsigned int i = 0; i <= k; i += k)
              middle(i, k * (k + 1) + i, k + 1 + i);
            values[4] = (values[1] + values[3] + values[5] + values[7]) / 2 -
                        (values[0] + values[2] + values[6] + values[8]) / 4;
          }
        return values;
      }

      LA::Vector
      with_nodes_between(const LA::Vector &vertices, const std::vector<LA::Vector> &gradient) const
      {
        const LA::Vector        q = s.elasticity.with_ghosts(vertices);
        std::vector<LA::Vector> slopes;
        for (const LA::Vector &component : gradient)
          slopes.push_back(s.elasticity.with_ghosts(component));
        LA::Vector sum = s.elasticity.zero_vector(), count = sum;
        for (const SlaveFace<dim> &face : surface.slave_faces)
          {
            const std::vector<double> values =
              face.degree == 2 ? values_on(face, q, slopes) : values_of(face.nodes);
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
      const LA::Vector           raw, status; ///< with ghosts
      types::global_dof_index    first_row = numbers::invalid_dof_index;
      LA::Vector              area, open_area; ///< int phi_v dA, and that on faces with open nodes
      std::vector<LA::Vector> offset;          ///< d
      std::vector<FaceMatrices> matrices;      ///< of slave faces
    };
  } // namespace



  template <int dim>
  LA::Vector
  recovered_pressure(const Snapshot<dim> &s, const unsigned int pair)
  {
    unsigned int degree = 0;
    for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
      degree = std::max(degree, face.degree);
    if (Utilities::MPI::max(degree, s.elasticity.mesh().communicator()) < 2)
      return nodal_field(s, s.pressure, pair);
    return Recovery<dim>(s, pair).run();
  }



  template LA::Vector
  recovered_pressure(const Snapshot<2> &, unsigned int);
  template LA::Vector
  recovered_pressure(const Snapshot<3> &, unsigned int);
} // namespace Signorini
