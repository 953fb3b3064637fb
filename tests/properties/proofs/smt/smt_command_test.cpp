// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/proofs/smt/query.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class SmtCommand : public Shell {};

TEST_F(SmtCommand, lists_queries) {
  const Ran ran = run("oplus-check smt --list --json", 0);
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("queries").size(), smt::queries().size());
}

}  // namespace
}  // namespace oplus
