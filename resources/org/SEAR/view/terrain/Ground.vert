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
// Period of the grain, metres.
const float REPEATED = 9.6;
#endif

#if defined(SHADOWED) && defined(SUN_SHADOW)
uniform mat4 m_SunView;
varying vec3 sunPlace;
#endif

// Height in metres that halves the haze.
const float THIN = 3000.0;

void main() {
    gl_Position = g_WorldViewProjectionMatrix * vec4(inPosition, 1.0);
    place = (inPosition.zx - m_Area.yx) * m_Area.wz;
#ifdef GRAIN
    // relative to a place near the camera, so that the numbers are small
    grain = (inPosition.xz - floor(g_CameraPosition.xz / REPEATED) * REPEATED) / REPEATED;
#endif
    // from a great height the line of sight crosses less air
    haze = 1.0 - exp(-distance(inPosition, g_CameraPosition) / (m_Clear * (1.0 + max(0.0, g_CameraPosition.y - inPosition.y) / THIN)));
#if defined(SHADOWED) && defined(SUN_SHADOW)
    // ground has no transform: its vertices are in world coordinates
    sunPlace = (m_SunView * vec4(inPosition, 1.0)).xyz;
#endif
}
