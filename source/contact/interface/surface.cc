#include "contact/interface/surface.h"

#include "contact/interface/one_sided.h"
#include <signorini/contact/methods/method.h>

#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
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
      surface.frames.insert(surface.frames.end(), other.frames.begin(), other.frames.end());
      surface.seam_frames.insert(surface.seam_frames.end(),
                                 other.seam_frames.begin(),
                                 other.seam_frames.end());
      for (const Seam<dim> &seam : other.seams)
        {
          surface.seams.push_back(seam);
          surface.seams.back().face += surface.faces;
        }
      for (Seam<dim> &seam : surface.seams)
        seam.weight /= 2;
      surface.whole.insert(surface.whole.end(), other.whole.begin(), other.whole.end());
      for (ContactPoint<dim> &point : surface.points)
        point.weight /= 2;
      for (auto &entry : surface.whole)
        entry.second /= 2;
      surface.slave_faces.resize(surface.faces);
      surface.slave_faces.insert(surface.slave_faces.end(),
                                 other.slave_faces.begin(),
                                 other.slave_faces.end());
      surface.has_held = surface.has_held || other.has_held;
      surface.faces += other.faces;
      surface.is_apart = surface.is_apart && other.is_apart;
    }
  } // namespace



  template <int dim>
  SparseRow
  ContactPoint<dim>::row() const
  {
    SparseRow  result;
    Components all;
    all.fill(true);
    for_each_entry(*this, all, [&](const auto column, const double value) {
      result.emplace_back(column, value);
    });
    return result;
  }



  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, const MPI_Comm comm)
  {
    double covered = 0, whole = 0;
    for (const auto &point : surface.points)
      covered += point.weight;
    for (const auto &[shape, weight] : surface.whole)
      whole += weight;
    whole = Utilities::MPI::sum(whole, comm);
    return whole > 0 ? Utilities::MPI::sum(covered, comm) / whole : 0.;
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Configuration<dim>  &configuration,
                       const ContactPair<dim>    &pair,
                       const Obstacle<dim>       *obstacle,
                       const ContactMethod       &method,
                       const Integration         &integration,
                       const SearchRange         &range,
                       const ContactSurface<dim> *former)
  {
    const std::vector<LaidPoint<dim>>  none;
    const std::vector<LaidPoint<dim>> &laid = former ? former->laid : none;
    auto                               surface =
      one_sided_surface(configuration, pair, obstacle, method, integration, range, laid);
    if (method.unbiased() && !obstacle)
      {
        ContactPair<dim> other = pair;
        std::swap(other.slave, other.master);
        other.self_side                                   = -pair.self_side;
        const std::vector<LaidPoint<dim>> &laid_on_master = former ? former->laid_on_master : none;
        const auto                         of_master      = one_sided_surface<dim>(
          configuration, other, nullptr, method, integration, range, laid_on_master);
        surface.laid_on_master = of_master.laid;
        add_other_side(surface, of_master);
      }
    return surface;
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration)
  {
    return make_contact_surface<dim>(
      Configuration<dim>(elasticity), pair, obstacle, method, integration, {}, nullptr);
  }



#define INSTANTIATE(dim)                                                                           \
  template struct ContactPoint<dim>;                                                               \
  template double              covered_share(const ContactSurface<dim> &, MPI_Comm);               \
  template ContactSurface<dim> make_contact_surface(const Configuration<dim> &,                    \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &,                           \
                                                    const SearchRange &,                           \
                                                    const ContactSurface<dim> *);                  \
  template ContactSurface<dim> make_contact_surface(const Elasticity<dim> &,                       \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
