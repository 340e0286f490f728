#import "Common/ShaderLib/GLSLCompat.glsllib"

uniform mat4 g_WorldViewProjectionMatrix;
uniform vec3 g_CameraPosition;
uniform vec4 m_Area;
uniform float m_Clear;

attribute vec3 inPosition;

varying vec2 place;
varying float haze;

#ifdef GRAIN
varying vec2 grain;
// Metres after which the grain is repeated.
const float REPEATED = 9.6;
#endif

#if defined(SHADOWED) && defined(SUN_SHADOW)
uniform mat4 m_SunView;
varying vec3 sunPlace;
#endif

// Metres of height that halve the haze.
const float THIN = 3000.0;

void main() {
    gl_Position = g_WorldViewProjectionMatrix * vec4(inPosition, 1.0);
    place = (inPosition.zx - m_Area.yx) * m_Area.wz;
#ifdef GRAIN
    // counted from near the camera, so that the numbers are small
    grain = (inPosition.xz - floor(g_CameraPosition.xz / REPEATED) * REPEATED) / REPEATED;
#endif
    // from high up one looks through less of the air
    haze = 1.0 - exp(-distance(inPosition, g_CameraPosition) / (m_Clear * (1.0 + max(0.0, g_CameraPosition.y - inPosition.y) / THIN)));
#if defined(SHADOWED) && defined(SUN_SHADOW)
    // ground is not moved: its corners are where it is in the world
    sunPlace = (m_SunView * vec4(inPosition, 1.0)).xyz;
#endif
}
