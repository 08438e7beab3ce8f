// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/function_of_scale.hpp"
