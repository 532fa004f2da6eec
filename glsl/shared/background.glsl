// A calm, dark backdrop; `height` from 0 (bottom of the picture) to 1. The noise of less than one step keeps the
// gradient from showing bands on a projector.
vec3 background(float height) {
    vec3 shade = mix(vec3(0.085, 0.105, 0.135), vec3(0.190, 0.235, 0.295), smoothstep(0.0, 1.0, height));
#ifdef SIMPLE
    return shade;
#endif
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return shade + (noise - 0.5) / 255.0;
}
