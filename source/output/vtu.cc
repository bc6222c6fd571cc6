// SPDX-License-Identifier: Apache-2.0
#include "output/files.h"
#include "output/pieces.h"
#include "solid/stress.h"
#include <signorini/solid/model.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <array>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The names of the columns of a tensor in space: its components row by row, then its principal
    /// values. Tensors of deal.II have dim * dim components, without those across the plane: the
    /// class Bodies combines nine scalars to one tensor.
    std::vector<std::string>
    columns_of(const std::string &tensor)
    {
      std::vector<std::string> result;
      for (unsigned int c = 0; c < 9; ++c)
        result.push_back(tensor + "_" + std::to_string(c));
      for (unsigned int c = 1; c <= 3; ++c)
        result.push_back("principal_" + tensor + "_" + std::to_string(c));
      return result;
    }



    /// Computes quantities from displacement and strain at points of cells: scalars, whose names
    /// are given.
    template <int dim>
    class Postprocessor : public DataPostprocessor<dim>
    {
    public:
      Postprocessor(const Elasticity<dim> &elasticity, std::vector<std::string> names)
        : elasticity(elasticity)
        , names(std::move(names))
      {}

      /// The values of a point, in the order of the names.
      virtual void
      evaluate(const CellAccessor<dim> &cell,
               const Tensor<2, dim>    &gradient,
               const Tensor<1, dim>    &u,
               const Point<dim>        &x,
               Vector<double>          &values) const = 0;

      void
      evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &inputs,
                            std::vector<Vector<double>>                &computed) const override
      {
        const auto cell = inputs.template get_cell<dim>();
        // On meshes of cells of different shapes `computed` has the size for another cell.
        const unsigned int n = inputs.evaluation_points.size();
        computed.resize(std::max<std::size_t>(computed.size(), n));
        for (unsigned int q = 0; q < n; ++q)
          {
            computed[q].reinit(names.size());
            Tensor<2, dim> gradient;
            Tensor<1, dim> u;
            for (unsigned int d = 0; d < dim; ++d)
              {
                gradient[d] = inputs.solution_gradients[q][d];
                u[d]        = inputs.solution_values[q][d];
              }
            evaluate(*cell, gradient, u, inputs.evaluation_points[q], computed[q]);
          }
      }

      std::vector<std::string>
      get_names() const override
      {
        return names;
      }

      std::vector<DataComponentInterpretation::DataComponentInterpretation>
      get_data_component_interpretation() const override
      {
        return {names.size(), DataComponentInterpretation::component_is_scalar};
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values | update_gradients | update_quadrature_points;
      }

    protected:
      /// Write a tensor to the columns of columns_of(), from column `first` on.
      static void
      write(const SymmetricTensor<2, 3> &tensor, const unsigned int first, Vector<double> &values)
      {
        for (unsigned int c = 0; c < 9; ++c)
          values[first + c] = tensor[c / 3][c % 3];
        const std::array<double, 3> principal = eigenvalues(tensor); // the largest first
        for (unsigned int c = 0; c < 3; ++c)
          values[first + 9 + c] = principal[c];
      }

      const Elasticity<dim> &elasticity;

    private:
      const std::vector<std::string> names;
    };



    /// The stress, and its von Mises stress behind it.
    template <int dim>
    class StressPostprocessor : public Postprocessor<dim>
    {
    public:
      StressPostprocessor(const Elasticity<dim> &elasticity)
        : Postprocessor<dim>(elasticity, names())
      {}

      void
      evaluate(const CellAccessor<dim> &cell,
               const Tensor<2, dim>    &gradient,
               const Tensor<1, dim>    &u,
               const Point<dim>        &x,
               Vector<double>          &values) const override
      {
        const SymmetricTensor<2, 3> sigma = this->elasticity.stress(cell, gradient, u, x);
        this->write(sigma, 0, values);
        values[values.size() - 1] = von_mises(sigma);
      }

    private:
      static std::vector<std::string>
      names()
      {
        std::vector<std::string> result = columns_of("stress");
        result.push_back("von_mises");
        return result;
      }
    };



    /// The strain.
    template <int dim>
    class StrainPostprocessor : public Postprocessor<dim>
    {
    public:
      StrainPostprocessor(const Elasticity<dim> &elasticity)
        : Postprocessor<dim>(elasticity, columns_of("strain"))
      {}

      void
      evaluate(const CellAccessor<dim> &cell,
               const Tensor<2, dim>    &gradient,
               const Tensor<1, dim>    &u,
               const Point<dim>        &x,
               Vector<double>          &values) const override
      {
        this->write(this->elasticity.strain(cell, gradient, u, x), 0, values);
      }
    };



    /// The output of bodies, with the components of stress and strain as one tensor each.
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
        NonscalarRanges ranges = DataOut<dim>::get_nonscalar_data_ranges();
        const auto      names  = this->get_dataset_names();
        for (const char *const tensor : {"stress", "strain"})
          {
            const auto first = std::find(names.begin(), names.end(), columns_of(tensor).front());
            if (first != names.end())
              ranges.emplace_back(first - names.begin(),
                                  first - names.begin() + 8,
                                  tensor,
                                  DataComponentInterpretation::component_is_part_of_tensor);
          }
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
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory, const bool with_strain)
  {
    const Elasticity<dim>         &elasticity    = snapshot.elasticity;
    const auto                    &triangulation = elasticity.mesh().triangulation();
    const LA::Vector               displacement  = elasticity.with_ghosts(snapshot.displacement);
    const StressPostprocessor<dim> stresses(elasticity);
    const StrainPostprocessor<dim> strains(elasticity);
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
    if (with_strain)
      out.add_data_vector(displacement, strains);
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
  write_bodies(const Snapshot<2> &, const std::string &, bool);
  template std::string
  write_bodies(const Snapshot<3> &, const std::string &, bool);
} // namespace Signorini
