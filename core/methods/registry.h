#pragma once

#include "core/methods/method.h"

#include <string>
#include <vector>

namespace texloom {

/// A method that this build was made without, such as one whose library was not there.
struct AbsentMethod {
    std::string id;
    std::string reason; ///< in one sentence, with what to do
};

/// The methods that were left out of this build. Recipes that name them can be read, and say so when run.
const std::vector<AbsentMethod>& absentMethods();

/// Adds a method from outside core/methods/, as the tests' own are, or says why one is not there. A static
/// object of this kind does it beside the method's declaration: methods() is first asked for later.
class Registration {
public:
    Registration(const std::string& id, const Method& method);
    explicit Registration(const AbsentMethod& absent);
};

} // namespace texloom
