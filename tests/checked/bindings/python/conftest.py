# SPDX-License-Identifier: GPL-3.0-or-later
import hypothesis

# The same cases each time; how long one takes depends on the machine.
hypothesis.settings.register_profile("oplus", derandomize=True, database=None, deadline=None, max_examples=150)
hypothesis.settings.load_profile("oplus")
