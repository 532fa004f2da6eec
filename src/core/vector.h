// Vector types of the physics, in float (mirror, GPU) and double (reference).
#pragma once

#include <glm/glm.hpp>

namespace ballpit {

template <class Real>
using Vec3 = glm::vec<3, Real>;
template <class Real>
using Vec4 = glm::vec<4, Real>;

using glm::dvec3;
using glm::uvec3;
using glm::vec3;
using glm::vec4;

}  // namespace ballpit
