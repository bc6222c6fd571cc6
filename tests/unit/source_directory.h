// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Where the sources lie. Only this file is compiled differently in each clone.
std::string
source_directory();
