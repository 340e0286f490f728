#import "Common/ShaderLib/GLSLCompat.glsllib"

uniform sampler2D m_Picture;

varying vec2 place;
varying float haze;

#ifdef GRAIN
uniform sampler2D m_Grain;
varying vec2 grain;
// Distance at which the grain has faded, metres.
const float FAR = 150.0;
#endif

#if defined(SHADOWED) && defined(SUN_SHADOW)
#import "org/SEAR/view/scene/SunShadow.glsllib"
varying vec3 sunPlace;
#endif

const vec3 AIR = vec3(0.75, 0.82, 0.87);

void main() {
    vec3 color = texture2D(m_Picture, place).rgb;
#ifdef GRAIN
    float near = max(0.0, 1.0 - 1.0 / (gl_FragCoord.w * FAR));
    color *= 1.0 + near * near * 0.8 * (texture2D(m_Grain, grain).r - 0.5);
#endif
    color = mix(color, AIR, haze);
#if defined(SHADOWED) && defined(SUN_SHADOW)
    color *= sunlit(sunPlace);
#endif
    gl_FragColor = vec4(color, 1.0);
}
