#include <signorini/contact/gap_operator.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Tensor<1, 3>
    moment_of(const Point<dim> &x, const Tensor<1, dim> &n)
    {
      Tensor<1, 3> m;
      if constexpr (dim == 2)
        m[0] = x[0] * n[1] - x[1] * n[0];
      else
        m = cross_product_3d(x, n);
      return m;
    }

    /// A share of a contact point that goes to a row of the gap operator.
    struct Share
    {
      types::global_dof_index row;
      double                  weight;
    };

    /// Which rows there are, and which shares of each contact point they take.
    struct Rows
    {
      IndexSet owned;
      IndexSet writable; ///< owned, and those that points of this rank contribute to
      std::vector<std::vector<std::vector<Share>>> shares; ///< [pair][point]
      std::vector<unsigned int>                    pair;
      std::vector<types::global_dof_index>         node;
    };

    template <int dim>
    Rows
    quadrature_rows(const std::vector<ContactSurface<dim>> &surfaces, const MPI_Comm comm)
    {
      Rows rows;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        rows.pair.insert(rows.pair.end(), surfaces[p].points.size(), p);
      rows.owned    = LA::contiguous_partition(rows.pair.size(), comm);
      rows.writable = rows.owned;
      auto row      = rows.owned.begin();
      for (const auto &surface : surfaces)
        {
          rows.shares.emplace_back();
          for (const auto &point : surface.points)
            rows.shares.back().push_back({{*row++, point.weight}});
        }
      return rows;
    }

    /// Areas of the nodes of one pair, at their first degree of freedom: with a partner, and all.
    template <int dim>
    std::pair<LA::Vector, LA::Vector>
    node_areas(const Elasticity<dim> &elasticity, const ContactSurface<dim> &surface)
    {
      LA::Vector paired = elasticity.zero_vector(), all = elasticity.zero_vector();
      for (const auto &point : surface.points)
        for (const auto &[node, value] : point.shape)
          paired(node) += value * point.weight;
      for (const auto &[shape, weight] : surface.whole)
        for (const auto &[node, value] : shape)
          all(node) += std::abs(value) * weight;
      paired.compress(VectorOperation::add);
      all.compress(VectorOperation::add);
      return {paired, all};
    }

    template <int dim>
    Rows
    node_rows(const Elasticity<dim> &elasticity, const std::vector<ContactSurface<dim>> &surfaces)
    {
      Rows                    rows;
      std::vector<LA::Vector> numbers; // row of each node, one vector a pair; -1: none
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          const auto [paired, all] = node_areas(elasticity, surfaces[p]);
          numbers.push_back(elasticity.zero_vector());
          numbers.back() = -1.;
          for (const auto i : elasticity.owned())
            // A node beyond the rim of the master, with next to no area, has no gap to speak of.
            if (all(i) > 0 && paired(i) > 0.01 * all(i))
              {
                numbers.back()(i) = rows.node.size();
                rows.node.push_back(i);
                rows.pair.push_back(p);
              }
          numbers.back().compress(VectorOperation::insert);
        }
      rows.owned    = LA::contiguous_partition(rows.node.size(), elasticity.mesh().communicator());
      rows.writable = rows.owned;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          for (const auto i : elasticity.owned())
            if (numbers[p](i) >= 0)
              numbers[p](i) = numbers[p](i) + *rows.owned.begin();
          numbers[p].compress(VectorOperation::insert);
          const LA::Vector                  number = elasticity.with_ghosts(numbers[p]);
          std::set<types::global_dof_index> foreign;
          rows.shares.emplace_back();
          for (const auto &point : surfaces[p].points)
            {
              rows.shares.back().emplace_back();
              for (const auto &[node, value] : point.shape)
                if (number(node) >= 0)
                  {
                    const auto row = static_cast<types::global_dof_index>(number(node));
                    rows.shares.back().back().push_back({row, value * point.weight});
                    if (!rows.owned.is_element(row))
                      foreign.insert(row);
                  }
            }
          rows.writable.add_indices(foreign.begin(), foreign.end());
        }
      return rows;
    }

    using Indices = std::vector<types::global_dof_index>;

    /// The rows of B that the points of one slave face contribute to, as a dense matrix: adding it
    /// to B at once costs a fraction of adding point by point.
    struct FaceMatrix
    {
      Indices            rows, columns;
      FullMatrix<double> values;
    };

    void
    sort_and_unite(Indices &indices)
    {
      std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    }

    unsigned int
    position_in(const Indices &indices, const types::global_dof_index i)
    {
      return std::lower_bound(indices.begin(), indices.end(), i) - indices.begin();
    }

    template <int dim>
    FaceMatrix
    face_matrix(const ContactSurface<dim>             &surface,
                const std::vector<std::vector<Share>> &shares,
                const unsigned int                     first,
                const unsigned int                     last)
    {
      FaceMatrix matrix;
      for (unsigned int q = first; q < last; ++q)
        {
          for (const Share &share : shares[q])
            matrix.rows.push_back(share.row);
          for (const auto &entry : surface.points[q].row)
            matrix.columns.push_back(entry.first);
        }
      sort_and_unite(matrix.rows);
      sort_and_unite(matrix.columns);
      matrix.values.reinit(matrix.rows.size(), matrix.columns.size());
      for (unsigned int q = first; q < last; ++q)
        for (const auto &[column, value] : surface.points[q].row)
          {
            const unsigned int j = position_in(matrix.columns, column);
            for (const auto &[row, weight] : shares[q])
              matrix.values(position_in(matrix.rows, row), j) += weight * value;
          }
      return matrix;
    }

    template <int dim>
    std::vector<FaceMatrix>
    face_matrices(const Rows &rows, const std::vector<ContactSurface<dim>> &surfaces)
    {
      std::vector<FaceMatrix> matrices;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          const auto &points = surfaces[p].points;
          for (unsigned int first = 0, last = 0; first < points.size(); first = last)
            {
              while (last < points.size() && points[last].face == points[first].face)
                ++last;
              matrices.push_back(face_matrix(surfaces[p], rows.shares[p], first, last));
            }
        }
      return matrices;
    }

    template <int dim>
    void
    assemble_matrix(GapOperator                            &contact,
                    const Rows                             &rows,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const IndexSet                         &columns,
                    const MPI_Comm                          comm)
    {
      const std::vector<FaceMatrix>     matrices = face_matrices(rows, surfaces);
      TrilinosWrappers::SparsityPattern pattern(rows.owned, columns, rows.writable, comm, 0u);
      for (const FaceMatrix &matrix : matrices)
        for (const auto row : matrix.rows)
          pattern.add_entries(row, matrix.columns.begin(), matrix.columns.end(), true);
      pattern.compress();
      contact.B.reinit(pattern);
      for (const FaceMatrix &matrix : matrices)
        contact.B.add(matrix.rows, matrix.columns, matrix.values);
      contact.B.compress(VectorOperation::add);
    }

    template <int dim>
    void
    assemble_vectors(GapOperator                            &contact,
                     const Rows                             &rows,
                     const std::vector<ContactSurface<dim>> &surfaces,
                     const MPI_Comm                          comm)
    {
      const unsigned int n_moments = dim == 2 ? 1 : 3;
      contact.weight.reinit(rows.owned, comm);
      contact.rest_gap.reinit(contact.weight);
      contact.stiffness.reinit(contact.weight);
      contact.position.assign(dim, contact.zero());
      contact.normal.assign(dim, contact.zero());
      contact.moment.assign(n_moments, contact.zero());

      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          {
            const ContactPoint<dim> &point  = surfaces[p].points[q];
            const Tensor<1, 3>       moment = moment_of(point.position, point.normal);
            for (const auto &[row, weight] : rows.shares[p][q])
              {
                contact.weight(row) += weight;
                contact.rest_gap(row) += weight * point.gap;
                contact.stiffness(row) += weight * point.stiffness;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    contact.position[d](row) += weight * point.position[d];
                    contact.normal[d](row) += weight * point.normal[d];
                  }
                for (unsigned int d = 0; d < n_moments; ++d)
                  contact.moment[d](row) += weight * moment[d];
              }
          }
    }

    /// Put the points of nodes where the nodes are, instead of the weighted mean of their
    /// surroundings.
    template <int dim>
    void
    move_to_nodes(GapOperator &contact, const Elasticity<dim> &elasticity)
    {
      // A node that is slave in two pairs has two rows.
      std::multimap<types::global_dof_index, types::global_dof_index> rows_of;
      auto                                                            row = contact.node.begin();
      for (const auto i : contact.weight.locally_owned_elements())
        rows_of.emplace(*row++, i);

      const auto                          &fe = elasticity.finite_element();
      FEValues<dim>                        values(elasticity.mesh().mapping(),
                           fe,
                           Quadrature<dim>(fe.get_unit_support_points()),
                           update_quadrature_points);
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(indices);
            if (std::none_of(indices.begin(), indices.end(), [&](const auto i) {
                  return rows_of.count(i);
                }))
              continue;
            values.reinit(cell);
            for (unsigned int i = 0; i < indices.size(); ++i)
              for (auto [at, last] = rows_of.equal_range(indices[i]); at != last; ++at)
                for (unsigned int d = 0; d < dim; ++d)
                  contact.position[d](at->second) = values.quadrature_point(i)[d];
          }
      for (LA::Vector &v : contact.position)
        v.compress(VectorOperation::insert);
    }

    /// From sums over the points' weights to means.
    void
    normalise(GapOperator &contact)
    {
      contact.weight.compress(VectorOperation::add);
      LA::Vector inverse = contact.zero();
      for (const auto i : inverse.locally_owned_elements())
        inverse(i) = 1 / contact.weight(i);
      inverse.compress(VectorOperation::insert);

      std::vector<LA::Vector *> means = {&contact.rest_gap, &contact.stiffness};
      for (auto *group : {&contact.position, &contact.normal, &contact.moment})
        for (LA::Vector &v : *group)
          means.push_back(&v);
      for (LA::Vector *v : means)
        {
          v->compress(VectorOperation::add);
          v->scale(inverse);
        }
      LA::scale_rows(contact.B, inverse);
    }
  } // namespace



  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const Sampling                          sampling)
  {
    const MPI_Comm comm = elasticity.mesh().communicator();
    const Rows     rows = sampling == Sampling::nodes ? node_rows(elasticity, surfaces) :
                                                        quadrature_rows(surfaces, comm);

    auto         result  = std::make_unique<GapOperator>();
    GapOperator &contact = *result;
    contact.dofs         = elasticity.owned();
    contact.pair         = rows.pair;
    contact.node         = rows.node;
    assemble_matrix(contact, rows, surfaces, elasticity.owned(), comm);
    assemble_vectors(contact, rows, surfaces, comm);
    normalise(contact);
    if (sampling == Sampling::nodes)
      move_to_nodes(contact, elasticity);

    LA::Vector free = elasticity.zero_vector();
    free            = 1.;
    elasticity.constraints().set_zero(free);
    contact.B_free.copy_from(contact.B);
    LA::scale_columns(contact.B_free, free);
    contact.initial_gap = contact.rest_gap;
    return result;
  }



  void
  GapOperator::set_obstacle_motion(const std::vector<std::vector<double>> &motion)
  {
    initial_gap = rest_gap;
    auto p      = pair.begin();
    for (const auto i : weight.locally_owned_elements())
      {
        for (unsigned int d = 0; d < normal.size(); ++d)
          initial_gap(i) = initial_gap(i) - normal[d](i) * motion[*p][d];
        ++p;
      }
    initial_gap.compress(VectorOperation::insert);
  }



  LA::Vector
  GapOperator::gap(const LA::Vector &u) const
  {
    LA::Vector g = zero();
    if (!empty())
      B.vmult(g, u);
    g += initial_gap;
    return g;
  }



  namespace
  {
    LA::Vector
    transposed(const LA::SparseMatrix &B, const GapOperator &contact, const LA::Vector &p)
    {
      // Not the communicator of p: an empty vector may have been assigned without one.
      LA::Vector force(contact.dofs, contact.weight.get_mpi_communicator());
      if (contact.empty())
        return force;
      LA::Vector weighted = p;
      weighted.scale(contact.weight);
      B.Tvmult(force, weighted);
      return force;
    }
  } // namespace



  LA::Vector
  GapOperator::force(const LA::Vector &p) const
  {
    return transposed(B_free, *this, p);
  }



  LA::Vector
  GapOperator::total_force(const LA::Vector &p) const
  {
    return transposed(B, *this, p);
  }



  void
  GapOperator::scatter(const LA::Vector &points, LA::Vector &nodal) const
  {
    const IndexSet rows = points.locally_owned_elements();
    auto           row  = rows.begin();
    for (const auto dof : node)
      nodal(dof) = points(*row++);
    nodal.compress(VectorOperation::insert);
  }



  void
  GapOperator::gather(const LA::Vector &nodal, LA::Vector &points) const
  {
    const IndexSet rows = points.locally_owned_elements();
    auto           row  = rows.begin();
    for (const auto dof : node)
      points(*row++) = nodal(dof);
    points.compress(VectorOperation::insert);
  }



  template std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<2> &, const std::vector<ContactSurface<2>> &, Sampling);
  template std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<3> &, const std::vector<ContactSurface<3>> &, Sampling);
} // namespace Signorini
