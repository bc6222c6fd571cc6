// SPDX-License-Identifier: Apache-2.0
#pragma once

// The instruction sets that Highway compiles kernels for; to be included before any header of
// Highway. Disabled are sets between others that have vectors of the same width and nothing else
// that is needed here, and those whose width is not known at compile time, whose vectors cannot be
// elements of arrays.
#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
