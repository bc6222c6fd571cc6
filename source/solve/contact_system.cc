#include <signorini/interruption/interruption.h>
#include <signorini/linear_algebra/row_view.h>
#include <signorini/linear_algebra/values.h>
#include <signorini/solve/contact_system.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  ContactSystem::ContactSystem(const Stiffness    &stiffness,
                               const ContactLaw   &law,
                               FreeMotions         free_motions,
                               const BulkCoupling *bulk,
                               const bool          symmetric_bodies)
    : K(stiffness)
    , law(law)
    , contact(law.gap_operator())
    , my_bulk(bulk)
    , saddle(law.is_mixed())
    , symmetric_bodies(symmetric_bodies)
    , motions(std::move(free_motions))
    , D(law.n_components(), contact.zero())
    , X(D)
    , Y(D)
    , D_diagonal(contact.zero())
    , A(contact.zero())
    , I(contact.zero())
  {
    if (!saddle && !contact.empty())
      make_surface_pattern();
  }



  void
  ContactSystem::make_surface_pattern()
  {
    columns.emplace(contact.B_free);
    DynamicSparsityPattern entries(columns->size(), columns->size());
    const int              n_rows = contact.weight.locally_owned_size();
    for (int row = 0; row < n_rows; ++row)
      {
        const LA::RowView view(contact.B_free, row);
        if (row > 0 && view.has_columns_of(LA::RowView(contact.B_free, row - 1)))
          continue;
        std::vector<unsigned int> sorted(view.columns, view.columns + view.size);
        std::sort(sorted.begin(), sorted.end());
        for (const unsigned int column : sorted)
          entries.add_entries(column, sorted.begin(), sorted.end(), true);
      }
    pattern.copy_from(entries);
    surface.reinit(pattern);
    displacement.reinit(columns->size());
    force.reinit(columns->size());
  }



  namespace
  {
    /// What has changed since `before`, which becomes what is now.
    std::vector<std::vector<double>>
    changes(const std::vector<LA::Vector> &now, std::vector<std::vector<double>> &before)
    {
      std::vector<std::vector<double>> result(now.size());
      before.resize(now.size());
      for (unsigned int b = 0; b < now.size(); ++b)
        {
          const double *const values = LA::values_of(now[b]);
          const unsigned int  n      = now[b].locally_owned_size();
          before[b].resize(n, 0.);
          result[b].resize(n);
          for (unsigned int i = 0; i < n; ++i)
            {
              result[b][i] = values[i] - before[b][i];
              before[b][i] = values[i];
            }
        }
      return result;
    }

    /// Springs between the components a (left) and b (right) of a point.
    struct PointSprings
    {
      double d, x, y, theta;

      bool
      are_zero() const
      {
        return d == 0 && x == 0 && y == 0;
      }

      void
      add_to(FullMatrix<double> &block, const double *B_a, const double *B_b) const
      {
        for (unsigned int k = 0; k < block.m(); ++k)
          for (unsigned int l = 0; l < block.n(); ++l)
            block(k, l) += d * B_a[k] * B_b[l];
      }

      void
      add_to(FullMatrix<double> &block,
             const double       *B_a,
             const double       *S_a,
             const double       *B_b,
             const double       *S_b) const
      {
        for (unsigned int k = 0; k < block.m(); ++k)
          for (unsigned int l = 0; l < block.n(); ++l)
            block(k, l) +=
              B_a[k] * (d * B_b[l] - x * S_b[l]) - theta * S_a[k] * (x * B_b[l] + y * S_b[l]);
      }
    };
  } // namespace



  void
  ContactSystem::sum_up_surface_stiffness()
  {
    if (surface.empty())
      return; // no points on this rank
    // With normal stresses all points count, those without contact too, and most are as before:
    // only changes are added. Springs of penalties may be so stiff that taking one away would leave
    // its rounding behind.
    if (!contact.has_stress())
      {
        surface = 0;
        sums    = Sums();
      }
    const Sums         change{changes(D, sums.D), changes(X, sums.X), changes(Y, sums.Y)};
    const int          n_rows = contact.weight.locally_owned_size();
    FullMatrix<double> block; // sum over points between the same two faces
    std::vector<types::global_dof_index> indices;
    for (int first = 0, last = 0; first < n_rows; first = last)
      {
        const LA::RowView columns(contact.B_free, first);
        block.reinit(columns.size, columns.size);
        bool any = false;
        for (; last < n_rows && LA::RowView(contact.B_free, last).has_columns_of(columns); ++last)
          any |= add_row(block, last, change);
        if (!any)
          continue;
        indices.assign(columns.columns, columns.columns + columns.size);
        surface.add(indices, block);
      }
  }



  bool
  ContactSystem::add_row(FullMatrix<double> &block, const int row, const Sums &of) const
  {
    const int         n = law.n_components(), first = row - row % n;
    const LA::RowView B(contact.B_free, row);
    bool              any = false;
    for (int b = 0; b < n; ++b)
      {
        const PointSprings springs{of.D[b][row], of.X[b][row], of.Y[b][row], contact.theta};
        if (springs.are_zero())
          continue;
        any = true;
        const LA::RowView B_b(contact.B_free, first + b);
        if (!contact.has_stress())
          springs.add_to(block, B.values, B_b.values);
        else
          springs.add_to(block,
                         B.values,
                         LA::RowView(contact.S_free, row).values,
                         B_b.values,
                         LA::RowView(contact.S_free, first + b).values);
      }
    return any;
  }



  void
  ContactSystem::set_active(const LA::Vector &active)
  {
    const unsigned int n    = law.n_components();
    const IndexSet     rows = active.locally_owned_elements();
    for (auto row = rows.begin(); row != rows.end();)
      {
        const auto        first    = *row;
        const bool        touches  = active(first) > 0;
        const LawResponse response = law.response(first, {}, touches);
        for (unsigned int a = 0; a < n; ++a)
          linearise(*row++, a, response, touches);
      }
    for (auto *blocks : {&D, &X, &Y})
      for (LA::Vector &v : *blocks)
        v.compress(VectorOperation::insert);
    for (LA::Vector *v : {&D_diagonal, &A, &I})
      v->compress(VectorOperation::insert);
    if (!saddle && !contact.empty())
      sum_up_surface_stiffness();
    motions.set_active(active);
  }



  void
  ContactSystem::linearise(const types::global_dof_index i,
                           const unsigned int            a,
                           const LawResponse            &response,
                           const bool                    touches)
  {
    const double W = contact.weight(i), k = contact.coefficients.stiffness(i);
    for (unsigned int b = 0; b < law.n_components(); ++b)
      {
        D[b](i) = -response.dp_dg[a][b] * W;
        X[b](i) = response.dp_ds[a][b] * W;
        Y[b](i) = contact.has_stress() ? ((a == b ? 1 : 0) - response.dp_ds[a][b]) /
                                           contact.coefficients.epsilon(i) * W :
                                         0.;
      }
    D_diagonal(i) = -response.dp_dg[a][a] * W;
    A(i)          = saddle && touches ? k * W : 0.;
    I(i)          = !saddle ? 0. : touches ? k * k * response.compliance[a] * W : k * W;
  }



  LA::BlockVector
  ContactSystem::zero() const
  {
    std::vector<IndexSet> blocks = {K.owned(),
                                    saddle ? contact.weight.locally_owned_elements() : IndexSet(0)};
    if (my_bulk)
      blocks.push_back(my_bulk->compliance.locally_owned_elements());
    return LA::BlockVector(blocks, K.communicator());
  }



  void
  ContactSystem::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    constexpr unsigned int often = 8; // hundreds of products take hardly a second, or minutes
    if (++n_products % often == 0)
      look_for_interruption();
    contact_terms(dst, src);
    LA::Vector &force = workspace;
    force.reinit(src.block(0), true);
    internal_force(force, src.block(0));
    dst.block(0) += force;
    motions.add_loose(dst.block(0), src.block(0));
    if (my_bulk)
      add_bulk(dst, src);
  }



  void
  ContactSystem::add_bulk(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    my_bulk->B.Tvmult_add(dst.block(0), src.block(2));
    LA::Vector volume = src.block(2);
    volume.scale(my_bulk->compliance);
    volume *= -1;
    my_bulk->B.vmult_add(volume, src.block(0));
    dst.block(2) += volume;
    if (contact.has_bulk_stress())
      add_bulk_at_contact(dst, src);
  }



  void
  ContactSystem::add_bulk_at_contact(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    Assert(!transposed, dealii::StandardExceptions::ExcNotImplemented());
    // The law has one component where there is a normal stress alone.
    const auto product = [](const Blocks &block, const LA::Vector &v, const double factor) {
      LA::Vector result = v;
      result.scale(block[0]);
      result *= factor;
      return result;
    };
    LA::Vector gap = contact.zero(), stress = gap, of_bulk = gap;
    contact.B_free.vmult(gap, src.block(0));
    contact.S_free.vmult(stress, src.block(0));
    contact.S_bulk.vmult(of_bulk, src.block(2));
    contact.B_free.Tvmult_add(dst.block(0), product(X, of_bulk, -1));
    contact.S_free.Tvmult_add(dst.block(0), product(Y, of_bulk, -contact.theta));
    stress += of_bulk;
    LA::Vector sum = product(X, gap, -contact.theta);
    sum += product(Y, stress, -contact.theta);
    contact.S_bulk.Tvmult_add(dst.block(2), sum);
  }



  void
  ContactSystem::internal_force(LA::Vector &dst, const LA::Vector &du) const
  {
    K.vmult(dst, du);
    if (turns)
      contact.subtract_geometric(dst, du);
    motions.subtract_springs(dst, du);
  }



  void
  ContactSystem::contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    if (contact.empty())
      return;
    if (!saddle)
      {
        add_surface_forces(dst.block(0), src.block(0));
        return;
      }
    LA::Vector gap = contact.zero();
    contact.B_free.vmult(gap, src.block(0));
    dst.block(1) = gap;
    dst.block(1).scale(A);
    dst.block(1) *= -1;
    gap = src.block(1);
    gap.scale(I);
    dst.block(1) -= gap;
    gap = src.block(1);
    gap.scale(A);
    gap *= -1;
    contact.B_free.Tvmult_add(dst.block(0), gap);
  }



  void
  ContactSystem::add_surface_forces(LA::Vector &dst, const LA::Vector &src) const
  {
    columns->fetch(src, displacement.begin());
    if (columns->size() > 0 && transposed)
      surface.Tvmult(force, displacement);
    else if (columns->size() > 0)
      surface.vmult(force, displacement);
    columns->add(force.begin(), dst);
  }
} // namespace Signorini
