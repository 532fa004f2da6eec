#include "app/csv.h"

#include <array>
#include <charconv>
#include <string_view>

namespace ballpit::app {

namespace {

// Shortest text that reads back as the same number, whatever the locale.
template <class Number>
void put(std::ostream& out, Number value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

template <class... Numbers>
void put_all(std::ostream& out, Numbers... values) {
    ((out << ',', put(out, values)), ...);
}

}  // namespace

void write_state(std::ostream& out, const BallState& state) {
    out << "id,x,y,z,vx,vy,vz,radius,mass\n";
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        const vec4& p = state.positions[i];
        const vec4& v = state.velocities[i];
        put(out, i);
        put_all(out, p.x, p.y, p.z, v.x, v.y, v.z, p.w, v.w);
        out << '\n';
    }
}

void write_trace_header(std::ostream& out, std::uint32_t balls) {
    out << "step,time,kinetic,potential,elastic,momentum_x,momentum_y,momentum_z,max_overlap,contacts";
    for (std::uint32_t i = 0; balls <= traced_balls && i < balls; ++i) {
        for (const char* column : {"x", "y", "z", "vx", "vy", "vz"}) {
            out << ',' << column << i;
        }
    }
    out << ",heat_drag,heat_contacts,heat_walls,work,unexplained,angular_momentum_x,angular_momentum_y,"
           "angular_momentum_z,mean_overlap,fastest,floor_force,dt_over_dt_c\n";
}

void write_trace_row(std::ostream& out, std::uint64_t step, double time, const measure::Totals& totals,
                     const BallState& state, const TracedMeters& meters) {
    put(out, step);
    put_all(out, time, totals.kinetic, totals.potential, totals.elastic, totals.momentum.x, totals.momentum.y,
            totals.momentum.z, totals.max_overlap, totals.contacts);
    for (std::uint32_t i = 0; state.count() <= traced_balls && i < state.count(); ++i) {
        const vec4& p = state.positions[i];
        const vec4& v = state.velocities[i];
        put_all(out, p.x, p.y, p.z, v.x, v.y, v.z);
    }
    const measure::Balance& b = meters.balance;
    const MeterReading& r = meters.reading;
    put_all(out, b.drag_heat, b.contact_heat, b.wall_heat, b.work, b.unexplained(), r.angular_momentum.x,
            r.angular_momentum.y, r.angular_momentum.z, r.mean_overlap_share(), r.max_speed, r.floor_force,
            meters.dt_over_critical);
    out << '\n';
}

}  // namespace ballpit::app
