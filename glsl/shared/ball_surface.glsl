// A ball's material under the light, for both looks. Needs shared/frame.glsl and shared/lighting.glsl.
uniform sampler2D surface;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float shininess;

vec3 ball_colour(vec3 texel, vec4 tint, vec3 place, vec3 normal) {
    vec3 own = texel * diffuse;
    float lightness = dot(own, vec3(0.2126, 0.7152, 0.0722));
    vec3 albedo = mix(own, vec3(0.45 + 0.55 * lightness), tint.w) * tint.rgb;
    return srgb(lit(albedo, specular, shininess, place, normal));
}
