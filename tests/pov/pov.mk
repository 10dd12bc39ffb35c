# SPDX-License-Identifier: MIT
# Exported scenes against POV-Ray, which was not written here; a part of the Makefile.

POV_CHECK := $(BUILD)/release/tests/pov/pov_check

$(POV_CHECK).o: tests/pov/pov_check.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(POV_CHECK): $(POV_CHECK).o $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

# Generated scenes that are held against it, beside those of the table in check.sh.
GENERATED ?= 100

# Where povray is not there and can't be installed, the check says so and is skipped.
.PHONY: pov
pov: $(POV_CHECK) $(BUILD)/superframe $(RELATIONS) ## Hold exported scenes against POV-Ray: pictures and ray counts
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh pov || true
	@sh tests/pov/check.sh $(BUILD)
	@sh tests/pov/generated.sh $(BUILD) $(GENERATED)
