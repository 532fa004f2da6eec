// What goes in and out of CpuBackend: slots in the layout of layout.h, and the history of a few balls.
#include <algorithm>
#include <cassert>
#include <utility>

#include "cpu/cpu_backend.h"

namespace ballpit::cpu {

namespace {

template <class T>
Bytes bytes_of(std::span<const T> elements) {
    const auto bytes = std::as_bytes(elements);
    return {bytes.begin(), bytes.end()};
}

// The shader's layout is float; the reference rounds on the way out.
template <class To, class From>
Bytes converted_bytes(const std::vector<From>& elements) {
    std::vector<To> converted(elements.begin(), elements.end());
    return bytes_of<To>(converted);
}

template <class T>
void overwrite(std::vector<T>& elements, std::span<const std::byte> bytes) {
    assert(bytes.size() <= elements.size() * sizeof(T));
    if (!bytes.empty()) {
        std::memcpy(elements.data(), bytes.data(), bytes.size());
    }
}

template <class From, class To>
void overwrite_converted(std::vector<To>& elements, std::span<const std::byte> bytes) {
    const std::vector<From> given = typed<From>(bytes);
    assert(given.size() <= elements.size());
    std::ranges::transform(given, elements.begin(), [](const From& value) { return To(value); });
}

template <class Real>
LeftOut<Real> left_out_of(const Compensation& c) {
    return {Vec3<Real>(vec3(c.x, c.y, c.z)), Vec3<Real>(vec3(c.vx, c.vy, c.vz))};
}

template <class Real>
Bytes compensation_bytes(const std::vector<LeftOut<Real>>& left_out) {
    std::vector<Compensation> compensations;
    for (const LeftOut<Real>& left : left_out) {
        const vec3 x(left.position);
        const vec3 v(left.velocity);
        compensations.push_back({x.x, x.y, x.z, v.x, v.y, v.z});
    }
    return bytes_of<Compensation>(compensations);
}

}  // namespace

template <class Real>
Bytes CpuBackend<Real>::read(Slot slot) {
    switch (slot) {
        case Slot::positions:
            return converted_bytes<vec4>(positions_);
        case Slot::velocities:
            return converted_bytes<vec4>(velocities_);
        case Slot::next_positions:
            return converted_bytes<vec4>(next_positions_);
        case Slot::next_velocities:
            return converted_bytes<vec4>(next_velocities_);
        case Slot::damping_ratios:
            return converted_bytes<float>(damping_ratios_);
        case Slot::keys:
            return bytes_of<Key>(keys_);
        case Slot::cell_ranges:
            return bytes_of<CellRange>(cell_ranges_);
        case Slot::status:
            return bytes_of<Status>({&status_, 1});
        case Slot::compensations:
            return compensation_bytes(left_out_);
        case Slot::built_positions:
            return converted_bytes<vec4>(built_positions_);
        case Slot::sorted_positions:
            return converted_bytes<vec4>(sorted_positions_);
        case Slot::sorted_velocities:
            return converted_bytes<vec4>(sorted_velocities_);
        case Slot::used_tiles:
            return bytes_of<std::uint32_t>(used_tiles_);
        case Slot::tickets:
            return bytes_of<std::uint32_t>(tickets_);
        case Slot::scattered_keys:
            return bytes_of<Key>(scattered_keys_);
        case Slot::tile_counts:
            return bytes_of<std::uint32_t>(tile_counts_);
        case Slot::origins:
            return bytes_of<std::uint32_t>(origins_);
    }
    return {};
}

template <class Real>
void CpuBackend<Real>::write(Slot slot, std::span<const std::byte> bytes) {
    switch (slot) {
        case Slot::positions:
            return overwrite_converted<vec4>(positions_, bytes);
        case Slot::velocities:
            return overwrite_converted<vec4>(velocities_, bytes);
        case Slot::next_positions:
            return overwrite_converted<vec4>(next_positions_, bytes);
        case Slot::next_velocities:
            return overwrite_converted<vec4>(next_velocities_, bytes);
        case Slot::damping_ratios:
            return overwrite_converted<float>(damping_ratios_, bytes);
        case Slot::keys:
            return overwrite(keys_, bytes);
        case Slot::cell_ranges:
            return overwrite(cell_ranges_, bytes);
        case Slot::status:
            assert(bytes.size() == sizeof(Status));
            std::memcpy(&status_, bytes.data(), sizeof(Status));
            return;
        case Slot::compensations:
            std::ranges::transform(typed<Compensation>(bytes), left_out_.begin(), left_out_of<Real>);
            return;
        case Slot::built_positions:
            return overwrite_converted<vec4>(built_positions_, bytes);
        case Slot::sorted_positions:
            return overwrite_converted<vec4>(sorted_positions_, bytes);
        case Slot::sorted_velocities:
            return overwrite_converted<vec4>(sorted_velocities_, bytes);
        case Slot::used_tiles:
            return overwrite(used_tiles_, bytes);
        case Slot::tickets:
            return overwrite(tickets_, bytes);
        case Slot::scattered_keys:
            return overwrite(scattered_keys_, bytes);
        case Slot::tile_counts:
            return overwrite(tile_counts_, bytes);
        case Slot::origins:
            return overwrite(origins_, bytes);
    }
}

// Nothing has been left out so far where the state does not say; nothing is kept where no law asks for it.
template <class Real>
void CpuBackend<Real>::load_left_out(std::span<const Compensation> compensations, const Schedule& schedule) {
    left_out_.assign(schedule.features.has(Feature::compensated) ? schedule.ball_count : 0, {});
    for (std::size_t i = 0; i < std::min(left_out_.size(), compensations.size()); ++i) {
        left_out_[i] = left_out_of<Real>(compensations[i]);
    }
}

template <class Real>
void CpuBackend<Real>::request(Slot slot) {
    auto& requested = requested_[static_cast<std::size_t>(slot)];
    if (!requested) {
        requested = read(slot);
    }
}

template <class Real>
std::optional<Bytes> CpuBackend<Real>::poll(Slot slot) {
    return std::exchange(requested_[static_cast<std::size_t>(slot)], std::nullopt);
}

template <class Real>
void CpuBackend<Real>::start_history(std::uint32_t entries) {
    history_limit_ = std::size_t{entries} * 2 * positions_.size() * sizeof(vec4);
    history_ = {};
    history_.reserve(history_limit_);
    requested_history_.reset();
}

template <class Real>
void CpuBackend<Real>::record_history() {
    for (const Slot slot : {Slot::positions, Slot::velocities}) {
        const Bytes copy = read(slot);
        history_.insert(history_.end(), copy.begin(), copy.end());
    }
    assert(history_.size() <= history_limit_);
}

template <class Real>
void CpuBackend<Real>::request_history() {
    if (!requested_history_) {
        requested_history_ = std::exchange(history_, {});
        history_.reserve(history_limit_);
    }
}

template <class Real>
std::optional<Bytes> CpuBackend<Real>::poll_history() {
    return std::exchange(requested_history_, std::nullopt);
}

// The members that this file defines; cpu_backend.cpp has the rest.
template Bytes CpuBackend<float>::read(Slot);
template void CpuBackend<float>::write(Slot, std::span<const std::byte>);
template void CpuBackend<float>::load_left_out(std::span<const Compensation>, const Schedule&);
template void CpuBackend<float>::request(Slot);
template std::optional<Bytes> CpuBackend<float>::poll(Slot);
template void CpuBackend<float>::start_history(std::uint32_t);
template void CpuBackend<float>::record_history();
template void CpuBackend<float>::request_history();
template std::optional<Bytes> CpuBackend<float>::poll_history();
template Bytes CpuBackend<double>::read(Slot);
template void CpuBackend<double>::write(Slot, std::span<const std::byte>);
template void CpuBackend<double>::load_left_out(std::span<const Compensation>, const Schedule&);
template void CpuBackend<double>::request(Slot);
template std::optional<Bytes> CpuBackend<double>::poll(Slot);
template void CpuBackend<double>::start_history(std::uint32_t);
template void CpuBackend<double>::record_history();
template void CpuBackend<double>::request_history();
template std::optional<Bytes> CpuBackend<double>::poll_history();

}  // namespace ballpit::cpu
