#import "Common/ShaderLib/GLSLCompat.glsllib"

uniform mat4 g_WorldViewProjectionMatrix;
uniform mat4 g_ViewMatrix;
uniform mat3 g_NormalMatrix;
uniform vec4 m_Diffuse;
uniform vec3 m_ToSun;
uniform vec3 m_SunLight;
uniform vec3 m_SkyLight;

attribute vec3 inPosition;
attribute vec3 inNormal;

// Light per vertex: under an infinitely distant sun a flat side looks the same as with light per pixel.
varying vec4 color;

#ifdef PICTURE
attribute vec2 inTexCoord;
varying vec2 place;
#endif

#ifdef CORNER_COLORS
attribute vec4 inColor;
#endif

#ifdef SUN_SHADOW
uniform mat4 g_WorldMatrix;
uniform mat4 m_SunView;
// Position in the sun's view, and the cosine of the angle to the sun.
varying vec4 sunPlace;
// Offset from the surface at which the shadow is sampled, metres: more than a pixel of the fine square, else edges shadow themselves.
const float OFF = 0.012;
#endif

void main() {
    gl_Position = g_WorldViewProjectionMatrix * vec4(inPosition, 1.0);
    float turned = dot(normalize(g_NormalMatrix * inNormal), (g_ViewMatrix * vec4(m_ToSun, 0.0)).xyz);
    color = vec4(m_SkyLight + m_SunLight * max(0.0, turned), 1.0) * m_Diffuse;
#ifdef PICTURE
    place = inTexCoord;
#endif
#ifdef CORNER_COLORS
    color *= inColor;
#endif
#ifdef SUN_SHADOW
    vec3 off = OFF * normalize((g_WorldMatrix * vec4(inNormal, 0.0)).xyz);
    sunPlace = vec4((m_SunView * (g_WorldMatrix * vec4(inPosition, 1.0) + vec4(off, 0.0))).xyz, turned);
#endif
}
