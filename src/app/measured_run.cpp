#include "app/measured_run.h"

#include "core/error.h"
#include "gl/error.h"

namespace ballpit::app {

MeasuredRun measured_run(const Session& session, Settings settings) {
    settings.pull.reset();
    return {settings, session.scene_changes(), std::string(session.simulation().backend().name())};
}

std::optional<std::string> device_failure(const std::function<void()>& work) {
    try {
        work();
    } catch (const DeviceError& error) {
        return error.what();
    } catch (const gl::Error& error) {
        return error.what();
    }
    return std::nullopt;
}

}  // namespace ballpit::app
