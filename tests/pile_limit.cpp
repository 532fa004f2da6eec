// `./run pile-limit FILE`: piles at rest with substeps around their true dt_c, as the table that docs/figures draws.
// On the mirror; a minute.
#include <array>
#include <cstdio>
#include <vector>

#include "support/piles.h"

using namespace ballpit;

namespace {

constexpr std::array marks{5,   10,  15,  20,   30,   40,   50,   70,   100,  150,  200,
                           300, 500, 700, 1000, 1500, 2000, 3000, 5000, 7000, 10000};
constexpr std::array shares{0.25, 0.9, 0.95, 0.99, 1.01, 1.02, 1.05, 1.1};

void write(std::FILE* file, bool unequal, const test::SettledPile& settled, double restitution) {
    const test::SettledPile pile = test::with_restitution(settled, restitution);
    const double critical = test::true_critical_dt(pile);
    const double gauge = test::gauge_critical_dt(pile);
    std::printf("radii %s, e = %g: dt_c %.4g ms, of the gauge %.4g ms\n", unequal ? "1:2" : "equal", restitution,
                1e3 * critical, 1e3 * gauge);
    std::fflush(stdout);
    for (const double share : shares) {
        const std::vector<test::Course> found = test::course_of(pile, share * critical, marks);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            std::fprintf(file, "%s,%g,%.6g,%.6g,%g,%d,%.4g\n", unequal ? "1:2" : "equal", restitution, critical, gauge,
                         share, marks[i], found[i].agitation);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: ./run pile-limit FILE.csv\n", stderr);
        return 2;
    }
    std::FILE* file = std::fopen(argv[1], "w");
    if (file == nullptr) {
        std::fprintf(stderr, "pile-limit: cannot write %s\n", argv[1]);
        return 2;
    }
    std::fputs("radii,restitution,critical_dt_s,gauge_dt_s,share_of_critical,substeps,largest_kinetic_mgr\n", file);
    for (const bool unequal : {false, true}) {
        const test::SettledPile settled = test::settled_pile(unequal, 300);
        write(file, unequal, settled, 1.0);
        write(file, unequal, settled, 0.5);
    }
    return std::fclose(file) == 0 ? 0 : 2;
}
