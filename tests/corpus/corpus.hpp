// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What reads the rows beside this file is a program's part, too: oplus-check conformance.
#include "properties/corpus/corpus.hpp"
