#include "cpu/collide.h"

#include "cpu/collider.h"
#include "cpu/neighbours.h"

namespace ballpit::cpu {

template <class Real>
void collide(const SubstepParams<Real>& params, Features features, const CollideInput<Real>& in,
             const CollideOutput<Real>& out, Status& status, BallRange balls) {
    const Collider<Real> collider{params, features, in, status};
    const auto contact_force = [&](const Ball<Real>& ball) {
        Vec3<Real> force(0);
        for_each_neighbour(params, features, in.keys, in.cell_ranges, ball.position, ball.id,
                           [&](std::uint32_t other) { collider.add_pair(ball, other, force); });
        return force;
    };
    for (std::uint32_t id = balls.first; id < balls.end; ++id) {
        collider.advance(id, out, contact_force);
    }
}

template void collide(const SubstepParams<float>&, Features, const CollideInput<float>&, const CollideOutput<float>&,
                      Status&, BallRange);
template void collide(const SubstepParams<double>&, Features, const CollideInput<double>&, const CollideOutput<double>&,
                      Status&, BallRange);

}  // namespace ballpit::cpu
