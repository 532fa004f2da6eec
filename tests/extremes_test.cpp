// Can a row of the table of extremes fail? Each is run on mirrors that are broken in some way.
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "cpu/cpu_backend.h"
#include "measure/extreme_trial.h"
#include "support/catch.h"

using namespace ballpit;
using measure::ExtremeCase;
using measure::ExtremeRow;
using measure::ExtremeTrial;

namespace {

enum class Fault { none, idle, push, not_a_number, forgetful };

// A mirror with a fault in every substep.
class FaultyBackend : public cpu::CpuBackend<float> {
public:
    explicit FaultyBackend(Fault fault) : fault_(fault) {}

    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override {
        if (fault_ == Fault::idle) {
            return;
        }
        CpuBackend<float>::run(schedule, params, first, last);
        if (fault_ != Fault::none && last == schedule.dispatches.size() && schedule.ball_count > 0) {
            spoil(schedule.in_place ? Slot::velocities : Slot::next_velocities);
        }
    }

private:
    void spoil(Slot slot) {
        auto velocities = read_slot<vec4>(*this, slot);
        if (fault_ == Fault::not_a_number) {
            velocities[0].y = std::numeric_limits<float>::quiet_NaN();
        } else if (fault_ == Fault::push) {
            velocities[0].y += 0.05f * static_cast<float>(++pushes_);
        } else {  // forgetful: other bits in every run
            static std::uint32_t runs = 0;
            velocities[0].y += 1e-3f * static_cast<float>(++runs);
        }
        write(slot, std::as_bytes(std::span(velocities)));
    }

    Fault fault_;
    int pushes_ = 0;
};

ExtremeRow row_of(const ExtremeCase& extreme, Fault fault) {
    return measure::run_extreme(extreme, [fault] { return std::make_unique<FaultyBackend>(fault); });
}

}  // namespace

TEST_CASE("a row passes where all of its claims hold, and has at least one", "[extremes]") {
    const measure::MakeBackend none = [] { return std::make_unique<FaultyBackend>(Fault::none); };
    const auto passes = [&](void (*run)(ExtremeTrial&)) {
        return measure::run_extreme({"E0", "input", "right", run}, none).passed();
    };
    CHECK_FALSE(passes([](ExtremeTrial&) {}));
    CHECK(passes([](ExtremeTrial& trial) { trial.at_most("a", 1.0, 1.0); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.at_most("a", 1.1, 1.0); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.at_least("a", 0.9, 1.0); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.near("a", 1.02, 1.0, 0.01); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.at_most("a", std::nan(""), 1.0); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.at_least("a", std::nan(""), 1.0); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) { trial.near("a", std::nan(""), 1.0, 0.01); }));
    CHECK_FALSE(passes([](ExtremeTrial&) { throw std::runtime_error("broken"); }));
    CHECK_FALSE(passes([](ExtremeTrial& trial) {
        trial.expect(true, "yes");
        trial.require(false, "no");
    }));
}

TEST_CASE("what does not hold stands first in a row, and is marked", "[extremes]") {
    ExtremeRow row;
    row.claims = {{true, "a"}, {false, "b"}, {true, "c"}};
    CHECK(row.found() == "NOT AS IT MUST BE: b; a; c");
    row.signs = {{"x", 2.0}, {"y", 0.5}};
    CHECK(row.warned() == "x 2, y 0.5");
}

TEST_CASE("every row notices a broken device, unless it asks none", "[extremes]") {
    const std::set<std::string_view> no_device = {
        "E11", "E12", "E20"};  // the parser; no time, in which nothing runs; the clock alone
    for (const ExtremeCase& extreme : measure::extreme_cases()) {
        std::string noticed;
        for (const Fault fault : {Fault::idle, Fault::push, Fault::not_a_number, Fault::forgetful}) {
            noticed += noticed.empty() && !row_of(extreme, fault).passed() ? "yes" : "";
        }
        CAPTURE(extreme.id, extreme.input);
        CHECK((noticed == "yes") != no_device.contains(extreme.id));
    }
}
