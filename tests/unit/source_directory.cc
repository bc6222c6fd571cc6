#include "source_directory.h"

std::string
source_directory()
{
  return SIGNORINI_SOURCE_DIR;
}
