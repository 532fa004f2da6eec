// A ball's material under the light, for both looks. Needs shared/frame.glsl and shared/lighting.glsl.
uniform sampler2D surface;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float shininess;

// tint.w 1: the colour tells a quantity, of the texture only the lightness remains. tint.w 0: a hint; white stays
// almost white, as if the dye took to the rest only.
vec3 ball_colour(vec3 texel, vec4 tint, vec3 place, vec3 normal) {
    vec3 own = texel * diffuse;
    float lightness = dot(own, vec3(0.2126, 0.7152, 0.0722));
    vec3 hinted = own * mix(vec3(1.0), tint.rgb, 0.9 - 0.8 * smoothstep(0.5, 1.0, lightness));
    vec3 told = tint.rgb * (0.45 + 0.55 * lightness);
    return srgb(lit(mix(hinted, told, tint.w), specular, shininess, place, normal));
}
