// SPDX-License-Identifier: Apache-2.0
#include "source_directory.h"

std::string
source_directory()
{
  return SIGNORINI_SOURCE_DIR;
}
