// How much of a ball is shown, for the programs that draw see-through balls. Needs shared/frame.glsl.
#ifdef FADED
layout(location = 5) in float presence;  // 0 to 1; 2 for a highlighted ball, which nothing leaves out

flat out float shown;

float presence_of(vec4 ball) {
    if (presence > 1.0) {
        return 1.0;
    }
    bool cut = frame.cut_away != 0.0 && dot(frame.slice_normal, ball.xyz) + ball.w > frame.slice_place;
    return cut ? 0.0 : presence;
}
#endif
