#import "Common/ShaderLib/GLSLCompat.glsllib"

varying vec4 color;

#ifdef PICTURE
uniform sampler2D m_DiffuseMap;
varying vec2 place;
#endif

#ifdef OPAQUE
uniform float m_Opaque;
#endif

#ifdef SUN_SHADOW
#import "org/SEAR/view/scene/SunShadow.glsllib"
varying vec4 sunPlace;
#endif

void main() {
    vec4 seen = color;
#ifdef PICTURE
    seen *= texture2D(m_DiffuseMap, place);
#endif
#ifdef OPAQUE
    if (seen.a <= m_Opaque) {
        discard;
    }
#endif
#ifdef SUN_SHADOW
    // sides that face away from the sun are dark anyway
    seen.rgb = min(seen.rgb, 1.0) * (sunPlace.w > 0.0 ? sunlit(sunPlace.xyz) : 1.0);
#endif
    gl_FragColor = seen;
}
