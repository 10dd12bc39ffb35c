/* SPDX-License-Identifier: MIT */
/* What the glue uses of DOSBox-X, written for the tests: types and save states. The other headers
 * of this folder have the rest under DOSBox-X's names. */
#ifndef SUPERFRAME_TESTS_DOSBOX_H
#define SUPERFRAME_TESTS_DOSBOX_H

#include <cstdint>
#include <istream>
#include <ostream>
#include <string>

typedef uintptr_t Bitu;

class SaveState {
  public:
    typedef std::string Error;
    struct Component {
        virtual void getBytes(std::ostream &stream) = 0;
        virtual void setBytes(std::istream &stream) = 0;
    };
    static SaveState &instance();
    void registerComponent(const std::string &name, Component &component);

    Component *registered = nullptr; /* the only one, for the test */
};

#endif
