// SPDX-License-Identifier: Apache-2.0
#include "materials/material_law.h"

#include <stdexcept>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// See with_thermal_stretch().
    class ThermalStretch : public ConstitutiveLaw
    {
    public:
      ThermalStretch(std::shared_ptr<const ConstitutiveLaw> law,
                     const StrainMeasure                    measure,
                     const Tensor<1, 3>                    &alpha)
        : law(std::move(law))
        , measure(measure)
        , alpha(alpha)
      {}

      unsigned int
      n_internal() const override
      {
        return law->n_internal();
      }

      ConstitutiveResponse
      response(const ConstitutiveInput &in, ResponseOrder wanted) const override;

    private:
      const std::shared_ptr<const ConstitutiveLaw> law;
      const StrainMeasure                          measure;
      const Tensor<1, 3>                           alpha;
    };



    // With the stretches s_i and their product s: C_ij = s_i s_j C^e_ij and W = s W_e(C^e), so that
    // S = 2 dW/dC has the components s S^e_ij/(s_i s_j), and a further derivative the same factors
    // again.
    ConstitutiveResponse
    ThermalStretch::response(const ConstitutiveInput &in, const ResponseOrder wanted) const
    {
      ConstitutiveInput elastic = in;
      if (measure == StrainMeasure::small)
        {
          for (unsigned int i = 0; i < 3; ++i)
            elastic.C[i][i] -= 2 * alpha[i] * in.temperature_rise;
          return law->response(elastic, wanted);
        }
      Tensor<1, 3> stretch;
      double       product = 1;
      for (unsigned int i = 0; i < 3; ++i)
        {
          stretch[i] = 1 + alpha[i] * in.temperature_rise;
          product *= stretch[i];
          if (!(stretch[i] > 0))
            throw std::domain_error("thermal strain below -1");
        }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          elastic.C[i][j] /= stretch[i] * stretch[j];
      ConstitutiveResponse state = law->response(elastic, wanted);
      state.energy *= product;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          {
            const double first = product / (stretch[i] * stretch[j]);
            state.stress[i][j] *= first;
            if (wanted == ResponseOrder::tangent)
              for (unsigned int k = 0; k < 3; ++k)
                for (unsigned int l = k; l < 3; ++l)
                  state.tangent[i][j][k][l] *= first / (stretch[k] * stretch[l]);
          }
      return state;
    }
  } // namespace



  std::shared_ptr<const ConstitutiveLaw>
  with_thermal_stretch(std::shared_ptr<const ConstitutiveLaw> law,
                       const StrainMeasure                    measure,
                       const Tensor<1, 3>                    &alpha)
  {
    return std::make_shared<ThermalStretch>(std::move(law), measure, alpha);
  }
} // namespace Signorini
