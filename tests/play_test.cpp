// Throwing balls, dragging walls, pulling balls while a scene runs: what each does, and that all of it can be stepped
// over.
#include <set>

#include "app/room.h"
#include "app/window_play.h"
#include "support/catch.h"
#include "support/headless_gui.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

app::Session make_session(std::string_view scene, std::uint32_t balls = 0) {
    app::WindowOptions options;
    options.scene = test::shipped_scene(scene);
    options.scene_file = std::string(scene);
    options.settings = options.scene.settings;
    options.settings.balls = balls == 0 ? options.settings.balls : balls;
    options.settings.substeps = 2;
    options.seed = test::seed_of(options.scene);
    options.backend = "cpu";
    return app::Session(options, false, "");
}

std::uint64_t hash_now(app::Session& session) { return hash_state(session.simulation().raw_state()); }

// A window in front of the box, with everything that play meets in it.
struct Table {
    app::Session session;
    app::Input input;
    app::Play play;
    app::Eye eye;

    explicit Table(std::string_view scene, std::uint32_t balls = 0) : session(make_session(scene, balls)) {
        eye.extent = {1000.0f, 800.0f, 1000.0f, 800.0f};
        eye.camera = view::home(app::room_half_extent(session.simulation()), 1.25f);
    }

    view::vec2 place_of(const vec3& point) const {
        const vec4 clip = view::projection(eye.camera, app::room_half_extent(session.simulation()), 1.25f) *
                          view::view_matrix(eye.camera) * vec4(point, 1.0f);
        return {500.0f * (1.0f + clip.x / clip.w), 400.0f * (1.0f - clip.y / clip.w)};
    }
    void button(Uint32 type, const view::vec2& place) {
        SDL_Event event{};
        event.type = type;
        event.button.type = type;
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = static_cast<Sint32>(place.x);
        event.button.y = static_cast<Sint32>(place.y);
        input.handle(event, false, 800);
    }
    void move(const view::vec2& place) {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        event.motion.x = static_cast<Sint32>(place.x);
        event.motion.y = static_cast<Sint32>(place.y);
        event.motion.xrel = event.motion.yrel = 20;
        input.handle(event, false, 800);
    }
    // What a frame does; false where the camera has turned.
    bool frame(bool over_panel = false) {
        const view::Camera before = eye.camera;
        eye.camera = input.moved(eye.camera, app::room_half_extent(session.simulation()), 0.0f, false, over_panel);
        play.update(session, input, eye, over_panel);
        session.apply(false);
        return before.yaw == eye.camera.yaw && before.pitch == eye.camera.pitch;
    }
};

}  // namespace

TEST_CASE("what is thrown is by itself like the largest ball of the scene", "[play]") {
    Table table("newtons_cradle");
    const Variety before = table.session.simulation().variety();
    table.play.act(ui::Action::shoot_ball, table.session, table.eye, std::nullopt);
    const Simulation& simulation = table.session.simulation();
    CHECK(simulation.added() == 1);
    CHECK(simulation.variety().radii == before.radii);
    CHECK(simulation.variety().masses == before.masses);
}

TEST_CASE("everything that is played can be stepped over, back and forth, to the same bytes", "[play]") {
    Table table("pile", 200);
    app::Session& session = table.session;
    std::vector<std::uint64_t> hashes;
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            hashes.push_back(hash_now(session));
            session.step();
        }
    };
    run(3);
    table.play.act(ui::Action::shoot_ball, session, table.eye, std::nullopt);
    run(3);
    table.play.act(ui::Action::add_cluster, session, table.eye, std::nullopt);
    run(3);
    table.play.act(ui::Action::toggle_shake, session, table.eye, std::nullopt);
    session.apply(false);
    run(3);
    Settings settings = session.wanted();
    settings.walls_low.x = 1.0;
    settings.walls_high.z = -0.5;
    session.want(settings);
    session.apply(false);
    run(3);
    settings.pull = Pull{7, dvec3(0.0, 0.0, 1.0)};
    session.want(settings);
    session.apply(false);
    run(3);
    settings.pull.reset();
    session.want(settings);
    session.apply(false);
    run(3);
    const std::uint64_t end = hash_now(session);
    CHECK(session.simulation().added() > 1);
    CHECK(session.simulation().box() != session.simulation().scene_box());
    for (std::size_t i = hashes.size(); i-- > 0;) {
        session.back(StepUnit::step);
        INFO("step " << i);
        CHECK(hash_now(session) == hashes[i]);
    }
    CHECK(session.simulation().settings().balls == 200);
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        session.step();
    }
    CHECK(hash_now(session) == end);
    session.update();
    CHECK_FALSE(session.stepper().divergence());
    session.restart(false);
    CHECK(session.simulation().settings().balls == 200);
    CHECK(session.simulation().added() == 0);
    CHECK(hash_now(session) == hashes[0]);
}

TEST_CASE("a scene without a fill takes thrown balls, and gives them back", "[play]") {
    Table table("two_balls");
    app::Session& session = table.session;
    for (int i = 0; i < 3; ++i) {
        table.play.act(ui::Action::shoot_ball, session, table.eye, std::nullopt);
    }
    REQUIRE(session.simulation().settings().balls == 5);
    const auto thrown_first = session.simulation().raw_state().positions[2];
    for (const std::uint32_t balls : {4u, 3u}) {
        Settings settings = session.wanted();
        settings.balls = balls;
        session.want(settings);
        session.apply(false);
        CHECK(session.take_message().empty());
        CHECK(session.simulation().schedule().ball_count == balls);
        CHECK(session.simulation().raw_state().positions[2] == thrown_first);
        ui::State state;
        session.describe(state);
        CHECK(state.most_balls == balls);
    }
    session.step();
    session.restart(false);
    CHECK(session.simulation().settings().balls == 2);
}

TEST_CASE("more balls than there may be are refused in a sentence", "[play]") {
    app::Session session = make_session("two_balls");
    CHECK_FALSE(session.add_balls(std::vector<BallSpec>(maximum_balls)));
    CHECK(contains(session.take_message(), "no more balls can be added"));
    CHECK(session.simulation().settings().balls == 2);
    CHECK(session.add_balls({BallSpec{}}));
}

TEST_CASE("the hand drags a wall along its normal, and leaves it where it was let go", "[play]") {
    Table table("pile", 1);
    Settings still = table.session.wanted();
    still.laws.gravity = false;
    table.session.want(still);
    table.session.apply(false);
    table.play.act(ui::Action::toggle_hand, table.session, table.eye, std::nullopt);
    table.frame();
    const view::Box drawn = app::drawn_box(table.session.simulation());
    const vec3 middle = 0.5f * (drawn.low + drawn.high);
    const vec3 grip(middle.x, drawn.low.y, middle.z + 0.8f * (drawn.high.z - middle.z));
    const vec3 there = grip + vec3(0.0f, 0.5f, 0.0f);
    table.button(SDL_MOUSEBUTTONDOWN, table.place_of(grip));
    CHECK(table.frame());
    table.move(table.place_of(there));
    CHECK(table.frame());  // the camera stays
    CHECK(table.session.wanted().walls_low.y == Approx(0.5).margin(0.05));
    view::Overlay overlay;
    table.play.add_to(overlay, table.session);
    CHECK(overlay.lines.size() == 8);  // the wall, and where it goes
    table.button(SDL_MOUSEBUTTONUP, table.place_of(there));
    table.frame();
    CHECK_FALSE(table.input.take_click());
    CHECK(table.session.wanted().walls_low.y == Approx(0.5).margin(0.05));
    for (int i = 0; i < 120; ++i) {
        table.session.step();
    }
    const Box now = table.session.simulation().box();
    CHECK(now.lower.y == Approx(static_cast<double>(drawn.low.y) + 0.5).margin(0.05));
    CHECK(app::drawn_box(table.session.simulation()).low.y == static_cast<float>(now.lower.y));
}

TEST_CASE("the hand pulls a ball as long as it is closed", "[play]") {
    Table table("two_balls");
    table.play.act(ui::Action::toggle_hand, table.session, table.eye, std::nullopt);
    table.frame();
    const vec3 ball(table.session.simulation().raw_state().positions[1]);
    table.button(SDL_MOUSEBUTTONDOWN, table.place_of(ball));
    table.frame();
    REQUIRE(table.session.simulation().settings().pull);
    CHECK(table.session.simulation().settings().pull->ball == 1);
    const vec3 there = ball + 0.5f * view::up(table.eye.camera);
    table.move(table.place_of(there));
    table.frame();
    CHECK(glm::distance(table.session.simulation().settings().pull->target, dvec3(there)) < 0.05);
    view::Overlay overlay;
    table.play.add_to(overlay, table.session);
    REQUIRE(overlay.tether);
    CHECK(overlay.tether->ball == 1);
    CHECK(overlay.highlights.size() == 1);
    CHECK(table.play.describe(table.session).held_ball == 1u);
    const dvec3 target = table.session.simulation().settings().pull->target;
    const double before = glm::distance(dvec3(table.session.simulation().raw_state().positions[1]), target);
    for (int i = 0; i < 20; ++i) {
        table.session.step();
    }
    CHECK(glm::distance(dvec3(table.session.simulation().raw_state().positions[1]), target) < before);
    table.button(SDL_MOUSEBUTTONUP, table.place_of(there));
    table.frame();
    CHECK_FALSE(table.session.simulation().settings().pull);
}

TEST_CASE("beside the box the hand looks around, on a panel it does nothing", "[play]") {
    Table table("two_balls");
    const Settings before = table.session.wanted();
    table.play.act(ui::Action::toggle_hand, table.session, table.eye, std::nullopt);
    table.frame();
    table.button(SDL_MOUSEBUTTONDOWN, {2.0f, 2.0f});
    table.frame();
    table.move({60.0f, 40.0f});
    CHECK_FALSE(table.frame());
    table.button(SDL_MOUSEBUTTONUP, {60.0f, 40.0f});
    table.frame();
    table.button(SDL_MOUSEBUTTONDOWN, {500.0f, 400.0f});
    CHECK(table.frame(true));
    table.move({540.0f, 440.0f});
    CHECK(table.frame(true));
    CHECK(table.session.wanted() == before);
}

TEST_CASE("without walls nothing shakes and nothing is dragged, and both are told", "[play]") {
    Table table("two_balls");
    Settings settings = table.session.wanted();
    settings.laws.walls = settings.laws.shake = false;
    table.session.want(settings);
    table.session.apply(false);
    table.play.act(ui::Action::toggle_shake, table.session, table.eye, std::nullopt);
    CHECK(contains(table.play.take_message(), "Shaking needs walls"));
    CHECK_FALSE(table.session.wanted().laws.shake);
    table.play.act(ui::Action::toggle_hand, table.session, table.eye, std::nullopt);
    table.frame();
    const view::Box drawn = app::drawn_box(table.session.simulation());
    table.button(SDL_MOUSEBUTTONDOWN, table.place_of({drawn.low.x * 0.9f, drawn.low.y, drawn.high.z * 0.9f}));
    table.frame();
    CHECK(contains(table.play.take_message(), "no walls to drag"));
}

TEST_CASE("beside the box a key to throw says where to point", "[play]") {
    Table table("two_balls");
    for (const ui::Action action : {ui::Action::shoot_ball, ui::Action::add_cluster}) {
        table.play.act(action, table.session, table.eye, view::vec2(1.0f, 1.0f));
        CHECK(contains(table.play.take_message(), "point there"));
    }
    CHECK(table.session.simulation().added() == 0);
}

TEST_CASE("the room stays while the box swings", "[play]") {
    app::Session session = make_session("pile", 1);
    Settings settings = session.wanted();
    settings.laws.shake = true;
    settings.shake_amplitude = dvec3(0.3, 0.0, 0.1);
    session.want(settings);
    session.apply(false);
    const vec3 room = app::room_half_extent(session.simulation());
    std::set<float> places;
    for (int i = 0; i < 60; ++i) {
        session.step();
        CHECK(app::room_half_extent(session.simulation()) == room);
        const view::Box now = app::drawn_box(session.simulation());
        places.insert(now.low.x);
        CHECK(glm::all(glm::lessThanEqual(glm::max(glm::abs(now.low), glm::abs(now.high)), room)));
    }
    CHECK(places.size() > 10);
}

TEST_CASE("the play section has sliders for what there is to play with", "[ui]") {
    test::HeadlessGui gui;
    ui::PlayState play;
    ui::State state;
    const std::array<ui::SceneChoice, 1> scenes = {{{"Rain", "Balls fall."}}};
    state.scenes = scenes;
    state.play = &play;
    const auto text = [&] {
        return gui.text([&] {
            ImGui::Dummy(ImVec2(350.0f, 1.0f));
            ImGui::GetStateStorage()->SetInt(ImGui::GetID("Play"), 1);  // open
            ui::Commands commands;
            ui::play_section(state, commands);
        });
    };
    CHECK(contains(text(), "Cluster"));
    CHECK(contains(text(), "no walls"));
    CHECK_FALSE(contains(text(), "Wall speed"));
    state.settings.laws.walls = true;
    CHECK(contains(text(), "Wall speed"));
    CHECK_FALSE(contains(text(), "Frequency"));
    CHECK_FALSE(contains(text(), "Walls back"));
    state.settings.laws.shake = true;
    play.walls_moved = true;
    CHECK(contains(text(), "Frequency"));
    CHECK(contains(text(), "Walls back"));
}
