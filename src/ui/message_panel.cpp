// One sentence that the user should know: a fallback, a file or setting that was refused.
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

void message_panel(const State& state, Commands& commands) {
    ImGui::PushTextWrapPos(26.0f * em());
    text(state.message);
    ImGui::PopTextWrapPos();
    if (key_button("Close##message", key_hint(Action::close), 7.0f * em())) {
        commands.push_back(DismissMessage{});
    }
}

}  // namespace ballpit::ui
