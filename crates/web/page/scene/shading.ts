// What the shaders of grains, chains and walls share.

/** Places of the data become places of the scene, whose size is about 1 whatever the size of the grains. */
export const PLACE = /* glsl */ `
uniform vec3 origin;
uniform float scale;
vec3 place(vec3 x) { return (x - origin) * scale; }
`;

/** Stands for a value that is not finite: not every driver tells NaN in a shader. */
export const NO_VALUE = -1e30;

/** Colour of a value, through a texture of 256 colours: a map (\`categories\` is 0) or a list of categories (1). */
export const COLOUR = /* glsl */ `
uniform sampler2D colours;
uniform vec2 range;
uniform float categories;
uniform vec3 noValue;
vec3 colourOf(float value) {
    if (value < -1e29) return noValue;
    float t = categories > 0.5
        ? (mod(value, 10.0) + 0.5) / 256.0
        : clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0;
    return texture(colours, vec2(t, 0.5)).rgb;
}
`;

/** Where a row of a table of numbers is in its texture. */
export const TABLE = /* glsl */ `
ivec2 cell(int row, sampler2D table) {
    int width = textureSize(table, 0).x;
    return ivec2(row % width, row / width);
}
`;

/** Light from the camera and a little from above left, with dark rims that part neighbours. */
export const LIGHT = /* glsl */ `
vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
    float facing = max(dot(normal, toEye), 0.0);
    float side = max(dot(normal, normalize(vec3(-0.5, 0.7, 0.5))), 0.0);
    float side2 = side * side;
    float side8 = side2 * side2 * side2 * side2;
    return colour * (0.34 + 0.42 * facing + 0.26 * side) + vec3(0.10 * side8 * side8 * side8);
}
`;

/** A plane in view space beyond which nothing is drawn: \`dot(clip.xyz, x) <= clip.w\` stays. */
export const CLIP = /* glsl */ `
uniform vec4 clip;
uniform float clipped;
bool cut(vec3 x) { return clipped > 0.5 && dot(clip.xyz, x) > clip.w; }
`;

/** Opacity as a pattern of pixels: needs no order from back to front. */
export const DITHER = /* glsl */ `
bool sifted(float opacity) {
    if (opacity >= 1.0) return false;
    // interleaved gradient noise, J. Jimenez (2014)
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) >= opacity;
}
`;

/** Depth of a place in view space. */
export const DEPTH = /* glsl */ `
uniform mat4 projection;
float depthOf(vec3 x) {
    return 0.5 - 0.5 * (projection[2][2] * x.z + projection[3][2]) / x.z;
}
`;
