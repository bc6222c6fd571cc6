// SPDX-License-Identifier: Apache-2.0
// Headers that most files use and that never change: read once, not a hundred times. With them a
// file takes half the seconds.
#include "linear_algebra/types.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>
