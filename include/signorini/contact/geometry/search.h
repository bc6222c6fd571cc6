#pragma once

#include <signorini/contact/geometry/bytes.h>
#include <signorini/contact/geometry/face_patch.h>
#include <signorini/contact/geometry/projection.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
  /// A place on a master surface.
  template <int dim>
  struct MasterPlace
  {
    dealii::Point<dim>     position;
    dealii::Tensor<1, dim> normal;   ///< outward unit normal of the master there
    double                 distance; ///< closest point distance
    dealii::Point<dim>
           face_center;      ///< identity of the face: breaks ties alike on any number of ranks
    double stiffness;        ///< E/h of the master cell (force / length^3)
    double modulus = 0;      ///< E of the master cell; 0: rigid
    double size    = 0;      ///< of the master's face
    double bound   = 0;      ///< of the master cell's normal stress, see NormalStress::bound()
    dealii::Point<dim> rest; ///< the position before anything moved
  };

  /// How the gap bends: its second variation is sum_ij C_ij (T_i.d) (T_j.d') for changes d and d'
  /// of the degrees of freedom, with T_i.d = v_i . u^S + (row_i).d, u^S being the displacement of
  /// the slave point. See contact/discretisation/gap_bend.h.
  template <int dim>
  struct GapBend
  {
    std::vector<dealii::Tensor<1, dim>> directions; ///< v_i
    std::vector<std::vector<std::pair<dealii::types::global_dof_index, double>>> rows;
    std::vector<double>                                                          factors; ///< C

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, directions);
      std::size_t n = rows.size();
      serialize_bytes(ar, n);
      rows.resize(n);
      for (auto &row : rows)
        serialize_bytes(ar, row);
      serialize_bytes(ar, factors);
    }
  };

  /// The place on a master surface that belongs to a slave point, and how it moves.
  template <int dim>
  struct Partner : public MasterPlace<dim>
  {
    /// Value of a displacement's normal component there as a combination of degrees of freedom:
    /// n . u(position) = sum_j coefficient_j d_j, hanging nodes already resolved.
    std::vector<std::pair<dealii::types::global_dof_index, double>> row;
    /// The normal stress of the master there, positive in compression, likewise; for methods that
    /// ask for it.
    std::vector<std::pair<dealii::types::global_dof_index, double>> stress;
    /// That of the rises of the temperature, in terms of ThermalStrain::coefficients().
    std::vector<std::pair<dealii::types::global_dof_index, double>> thermal_stress;
    GapBend<dim> bend; ///< where surfaces have moved; its factors not yet, see bend_of_bodies()

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, static_cast<MasterPlace<dim> &>(*this));
      serialize_bytes(ar, row);
      serialize_bytes(ar, stress);
      serialize_bytes(ar, thermal_stress);
      ar &bend;
    }
  };

  /// Of the normals of two surfaces where they may touch.
  template <int dim>
  bool
  faces_each_other(const dealii::Tensor<1, dim> &slave_normal,
                   const dealii::Tensor<1, dim> &master_normal)
  {
    return slave_normal * master_normal < -0.1;
  }

  /// The face of a master that a point had before, known by where it is.
  template <int dim>
  struct FormerFace
  {
    dealii::Point<dim> center;
    double             size = 0; ///< 0: none
  };

  /// The master side of one contact pair on this rank: the faces of locally owned cells. Supplies
  /// what the search cannot know: a face's rows of shape functions and its stiffness.
  template <int dim>
  struct MasterFaces
  {
    std::vector<FacePatch<dim>> patches;
    /// Fill the rows, `stiffness` and `bound` of a partner on face i at parameter xi; position and
    /// normal are set.
    std::function<void(unsigned int i, const dealii::Point<dim - 1> &xi, Partner<dim> &partner)>
      complete;
  };

  /// What a search did on this rank; `projections` counts those for other ranks'
  /// points as well.
  struct SearchStatistics
  {
    unsigned long points = 0, points_sent = 0, projections = 0, fallbacks = 0;

    SearchStatistics &
    operator+=(const SearchStatistics &other)
    {
      points += other.points;
      points_sent += other.points_sent;
      projections += other.projections;
      fallbacks += other.fallbacks;
      return *this;
    }
  };

  /// For each slave point of this rank the closest place on the master surface of all ranks, if
  /// there is one within `reach`, facing the point (see faces_each_other()) and not
  /// beyond the rim of the surface. Collective.
  ///
  /// Points travel to the faces: every rank announces one bounding box of its master faces, points
  /// inside the inflated box go there, are projected on the faces that an R-tree yields in the
  /// order of distance, and the answers come back. No rank ever sees faces of another.
  ///
  /// Ties (a point that projects on the common edge of two faces) are broken by the face whose
  /// center is lexicographically smaller, so that the result does not depend on the partition; but
  /// a face that the point lies above goes before one whose rim it overhangs.
  ///
  /// Points with a normal of zero take faces of any orientation. Those with a former place stay
  /// with its face as long as that is no farther than 1e-3 of its size beyond the nearest: at an
  /// edge between two faces, each may push a point onto the other for ever.
  /// @param former empty, or one a point
  template <int dim>
  std::vector<std::optional<Partner<dim>>>
  find_partners(const std::vector<dealii::Point<dim>>     &points,
                const std::vector<dealii::Tensor<1, dim>> &slave_normals,
                const MasterFaces<dim>                    &master,
                double                                     reach,
                MPI_Comm                                   comm,
                SearchStatistics                          *statistics = nullptr,
                const std::vector<FormerFace<dim>>        &former     = {});

  /// Of each point of this rank, how deep it lies inside of the master's body, as far as the
  /// closest place of the surface tells, of whatever orientation; negative outside, infinity if
  /// nothing is within reach. A point behind a face that faces it may also be beyond the whole
  /// body: above a plate, whose lower side looks down as the point does not. Collective.
  template <int dim>
  std::vector<double>
  depths(const std::vector<dealii::Point<dim>> &points,
         const MasterFaces<dim>                &master,
         double                                 reach,
         MPI_Comm                               comm,
         SearchStatistics                      *statistics = nullptr);
} // namespace Signorini
