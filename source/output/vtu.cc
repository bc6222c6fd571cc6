// SPDX-License-Identifier: Apache-2.0
#include "output/files.h"
#include "output/pieces.h"
#include "solid/stress.h"
#include <signorini/solid/model.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Columns of the data that the postprocessor computes: von Mises stress, the stress row by
    /// row, and the principal stresses.
    enum Column : unsigned int
    {
      mises,
      tensor,
      principal = tensor + 9,
      n_columns = principal + 3
    };

    constexpr char first_of_stress[] = "stress_0";



    /// Computes all stress quantities from the displacement.
    template <int dim>
    class StressPostprocessor : public DataPostprocessor<dim>
    {
    public:
      StressPostprocessor(const Elasticity<dim> &elasticity)
        : elasticity(elasticity)
      {}

      /// Compute the stress columns at the points of one cell.
      void
      evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &inputs,
                            std::vector<Vector<double>>                &computed) const override
      {
        const auto cell = inputs.template get_cell<dim>();
        for (unsigned int q = 0; q < computed.size(); ++q)
          {
            Tensor<2, dim> gradient;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d] = inputs.solution_gradients[q][d];
            Tensor<1, dim> u;
            for (unsigned int d = 0; d < dim; ++d)
              u[d] = inputs.solution_values[q][d];
            const SymmetricTensor<2, 3> sigma =
              elasticity.stress(*cell, gradient, u, inputs.evaluation_points[q]);
            computed[q][Column::mises] = von_mises(sigma);
            for (unsigned int c = 0; c < 9; ++c)
              computed[q][Column::tensor + c] = sigma[c / 3][c % 3];
            const std::array<double, 3> principal = eigenvalues(sigma); // the largest first
            for (unsigned int c = 0; c < 3; ++c)
              computed[q][Column::principal + c] = principal[c];
          }
      }

      std::vector<std::string>
      get_names() const override
      {
        std::vector<std::string> names = {"von_mises", first_of_stress};
        for (unsigned int c = 1; c < 9; ++c)
          names.push_back("stress_" + std::to_string(c));
        for (unsigned int c = 1; c <= 3; ++c)
          names.push_back("principal_stress_" + std::to_string(c));
        return names;
      }

      // Tensors of deal.II have dim * dim components, without sigma_zz of plane strain or the hoop
      // stress: the class Bodies combines nine scalars to one tensor.
      std::vector<DataComponentInterpretation::DataComponentInterpretation>
      get_data_component_interpretation() const override
      {
        return {Column::n_columns, DataComponentInterpretation::component_is_scalar};
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values | update_gradients | update_quadrature_points;
      }

    private:
      const Elasticity<dim> &elasticity;
    };



    /// The output of bodies, with the components of the stress as one tensor.
    template <int dim>
    class Bodies : public DataOut<dim>
    {
    public:
      /// Write the files.
      /// @return the name of the record
      std::string
      write(const PieceSettings &settings, const MPI_Comm comm) const
      {
        return write_pieces(this->get_patches(),
                            this->get_dataset_names(),
                            get_nonscalar_data_ranges(),
                            settings,
                            comm);
      }

    private:
      NonscalarRanges
      get_nonscalar_data_ranges() const override
      {
        NonscalarRanges    ranges = DataOut<dim>::get_nonscalar_data_ranges();
        const auto         names  = this->get_dataset_names();
        const unsigned int first =
          std::find(names.begin(), names.end(), first_of_stress) - names.begin();
        ranges.emplace_back(first,
                            first + 8,
                            "stress",
                            DataComponentInterpretation::component_is_part_of_tensor);
        return ranges;
      }
    };



    /// @return the names of all bodies.
    template <int dim>
    std::vector<std::string>
    names_of_bodies(const Mesh<dim> &mesh)
    {
      std::vector<std::string> names;
      for (unsigned int b = 0; b < mesh.n_bodies(); ++b)
        names.push_back(mesh.body_name(b));
      return names;
    }



    /// @return the index of the body of each locally owned cell.
    template <int dim>
    Vector<float>
    body_of_cells(const Mesh<dim> &mesh)
    {
      const auto   &triangulation = mesh.triangulation();
      Vector<float> bodies(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          bodies[cell->active_cell_index()] = mesh.body(cell);
      return bodies;
    }
  } // namespace



  // Displacement and stress on patches with as many subdivisions as the degree; body and rank as
  // cell data.
  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory)
  {
    const Elasticity<dim>         &elasticity    = snapshot.elasticity;
    const auto                    &triangulation = elasticity.mesh().triangulation();
    const LA::Vector               displacement  = elasticity.with_ghosts(snapshot.displacement);
    const StressPostprocessor<dim> stresses(elasticity);
    const Vector<float>            bodies = body_of_cells(elasticity.mesh());
    Vector<float>                  subdomain(triangulation.n_active_cells());
    subdomain = triangulation.locally_owned_subdomain();

    const std::vector<DataComponentInterpretation::DataComponentInterpretation> is_vector(
      dim, DataComponentInterpretation::component_is_part_of_vector);
    Bodies<dim> out;
    out.attach_dof_handler(elasticity.dof_handler());
    out.add_data_vector(displacement,
                        std::vector<std::string>(dim, "displacement"),
                        DataOut<dim>::type_dof_data,
                        is_vector);
    out.add_data_vector(displacement, stresses);
    out.add_data_vector(bodies, "body", DataOut<dim>::type_cell_data);
    out.add_data_vector(subdomain, "subdomain", DataOut<dim>::type_cell_data);
    // Cells become as many subcells in each direction as the degree, and curved cells keep their
    // curvature also inside of bodies.
    out.build_patches(elasticity.mesh().mapping(),
                      elasticity.degree(),
                      DataOut<dim>::curved_inner_cells);
    return out.write({directory,
                      "solution",
                      snapshot.step,
                      snapshot.time,
                      "body",
                      names_of_bodies(elasticity.mesh())},
                     elasticity.mesh().communicator());
  }



  template std::string
  write_bodies(const Snapshot<2> &, const std::string &);
  template std::string
  write_bodies(const Snapshot<3> &, const std::string &);
} // namespace Signorini
