# SPDX-License-Identifier: MIT
# Relations that need no expected value, held on generated scenes; a part of the Makefile.

RELATIONS := $(BUILD)/release/relations/relations
RELATIONS_OBJECTS := $(patsubst tests/relations/%.c,$(BUILD)/release/relations/%.o,$(wildcard tests/relations/*.c))

$(BUILD)/release/relations/%.o: tests/relations/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -Itests/relations -MMD -MP -c -o $@ $<

$(RELATIONS): $(RELATIONS_OBJECTS) $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

.PHONY: relations
relations: $(RELATIONS) ## Hold relations on generated scenes (SEEDS=A:B, RELATION=name, SECONDS=limit)
	@$(RELATIONS) $(BUILD)/relations SEEDS=$(or $(SEEDS),0:300) SECONDS=$(or $(SECONDS),3600) $(if $(RELATION),RELATION=$(RELATION))
