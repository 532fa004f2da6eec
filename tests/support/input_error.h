// The sentence with which something is refused.
#pragma once

#include <string>

#include "core/error.h"

namespace ballpit::test {

/// The message of the InputError that `action` throws; "accepted" if it throws none.
template <class Action>
std::string complaint_of(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace ballpit::test
