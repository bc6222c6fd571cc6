#include <signorini/row_view.h>
#include <signorini/solve/contact_system.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  ContactSystem::ContactSystem(const LA::SparseMatrix &stiffness,
                               const ContactLaw       &law,
                               FreeMotions             free_motions,
                               const LA::SparseMatrix *geometric)
    : K(stiffness)
    , G(geometric)
    , law(law)
    , contact(law.gap_operator())
    , saddle(law.is_mixed())
    , motions(std::move(free_motions))
    , D(contact.zero())
    , X(contact.zero())
    , Y(contact.zero())
    , A(contact.zero())
    , I(contact.zero())
  {
    if (!saddle && !contact.empty())
      make_surface_pattern();
  }



  ContactSystem::~ContactSystem() = default;



  void
  ContactSystem::make_surface_pattern()
  {
    const Epetra_CrsMatrix &B = contact.B_free.trilinos_matrix();
    columns                   = std::make_unique<Epetra_Import>(B.ColMap(), B.DomainMap());
    of_columns                = std::make_unique<Epetra_Vector>(B.ColMap());
    forces                    = std::make_unique<Epetra_Vector>(B.ColMap());

    DynamicSparsityPattern entries(B.NumMyCols(), B.NumMyCols());
    for (int row = 0; row < B.NumMyRows(); ++row)
      {
        const RowView view(contact.B_free, row);
        if (row > 0 && view.has_columns_of(RowView(contact.B_free, row - 1)))
          continue;
        std::vector<unsigned int> sorted(view.columns, view.columns + view.size);
        std::sort(sorted.begin(), sorted.end());
        for (const unsigned int column : sorted)
          entries.add_entries(column, sorted.begin(), sorted.end(), true);
      }
    pattern.copy_from(entries);
    surface.reinit(pattern);
    displacement.reinit(B.NumMyCols());
    force.reinit(B.NumMyCols());
  }



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
    const auto change = [](const LA::Vector &now, std::vector<double> &before) {
      const double *const values = now.trilinos_vector()[0];
      before.resize(now.locally_owned_size(), 0.);
      std::vector<double> difference(before.size());
      for (unsigned int i = 0; i < before.size(); ++i)
        {
          difference[i] = values[i] - before[i];
          before[i]     = values[i];
        }
      return difference;
    };
    const std::vector<double> d = change(D, sums.D), x = change(X, sums.X), y = change(Y, sums.Y);
    const int                 n_rows = d.size();
    const double              theta  = contact.theta;
    FullMatrix<double>        block; // sum over points between the same two faces
    std::vector<types::global_dof_index> indices;
    for (int first = 0, last = 0; first < n_rows; first = last)
      {
        const RowView columns(contact.B_free, first);
        const int     n = columns.size;
        block.reinit(n, n);
        bool any = false;
        for (; last < n_rows; ++last)
          {
            const RowView B(contact.B_free, last);
            if (!B.has_columns_of(columns))
              break;
            if (d[last] == 0 && x[last] == 0 && y[last] == 0)
              continue;
            any = true;
            if (!contact.has_stress())
              for (int k = 0; k < n; ++k)
                for (int l = 0; l < n; ++l)
                  block(k, l) += d[last] * B.values[k] * B.values[l];
            else
              {
                const RowView S(contact.S_free, last);
                for (int k = 0; k < n; ++k)
                  for (int l = 0; l < n; ++l)
                    block(k, l) +=
                      B.values[k] * (d[last] * B.values[l] - x[last] * S.values[l]) -
                      theta * S.values[k] * (x[last] * B.values[l] + y[last] * S.values[l]);
              }
          }
        if (!any)
          continue;
        indices.assign(columns.columns, columns.columns + n);
        surface.add(indices, block);
      }
  }



  void
  ContactSystem::set_active(const LA::Vector &active)
  {
    for (const auto i : active.locally_owned_elements())
      {
        const bool        touches  = active(i) > 0;
        const LawResponse response = law.response(i, {}, touches);
        const double      W = contact.weight(i), k = contact.stiffness(i);
        D(i) = -response.dp_dg * W;
        X(i) = response.dp_ds * W;
        Y(i) = contact.has_stress() ? (1 - response.dp_ds) / contact.epsilon(i) * W : 0.;
        A(i) = saddle && touches ? k * W : 0.;
        I(i) = !saddle ? 0. : touches ? k * k * response.d_defect_d_p * W : k * W;
      }
    for (LA::Vector *v : {&D, &X, &Y, &A, &I})
      v->compress(VectorOperation::insert);
    if (!saddle && !contact.empty())
      sum_up_surface_stiffness();
    motions.set_active(active);
  }



  LA::BlockVector
  ContactSystem::zero() const
  {
    const MPI_Comm comm = K.get_mpi_communicator();
    return LA::BlockVector({K.locally_owned_range_indices(),
                            saddle ? contact.weight.locally_owned_elements() : IndexSet(0)},
                           comm);
  }



  void
  ContactSystem::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    contact_terms(dst, src);
    LA::Vector &force = workspace;
    force.reinit(src.block(0), true);
    internal_force(force, src.block(0));
    dst.block(0) += force;
    motions.add_loose(dst.block(0), src.block(0));
  }



  void
  ContactSystem::internal_force(LA::Vector &dst, const LA::Vector &u) const
  {
    K.vmult(dst, u);
    if (G)
      {
        LA::Vector moved;
        moved.reinit(dst, true);
        G->vmult(moved, u);
        dst -= moved;
      }
    motions.subtract_springs(dst, u);
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
    int error = of_columns->Import(src.trilinos_vector(), *columns, Insert);
    AssertThrow(error == 0, ExcTrilinosError(error));
    const int n = of_columns->MyLength();
    if (n > 0)
      {
        std::copy_n(of_columns->Values(), n, displacement.begin());
        surface.vmult(force, displacement);
        std::copy_n(force.begin(), n, forces->Values());
      }
    error = dst.trilinos_vector().Export(*forces, *columns, Add);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }
} // namespace Signorini
