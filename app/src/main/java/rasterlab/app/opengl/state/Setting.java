package rasterlab.app.opengl.state;

import java.util.List;
import java.util.Locale;

/**
 * A state of OpenGL that a control sets, and what it may be: names as the program writes them,
 * numbers, or words of our own.
 */
public enum Setting {
    SCENE(Group.SCENE, "sphere", "quad", "globe"),
    PROJECTION(Group.SCENE, "perspective", "ortho"),
    NEAR_FAR(Group.SCENE, "1:20", "0.001:100000"),
    DISPLAY_LIST(Group.SCENE, "off", "on"),

    LIGHTING(Group.LIGHT, "light-material", "light-color", "color"),
    SHADE_MODEL(Group.LIGHT, "GL_SMOOTH", "GL_FLAT"),
    LIGHTS(Group.LIGHT, "1", "2", "8"),
    LIGHT_PLACE(Group.LIGHT, "front", "inside", "far"),
    LIGHT_TERMS(Group.LIGHT, "all", "ambient", "diffuse", "specular"),
    SPOT(Group.LIGHT, "180", "30", "30:16"),
    ATTENUATION(Group.LIGHT, "1:0:0", "0:1:0", "0.5:0:0.5"),
    GLOBAL_AMBIENT(Group.LIGHT, "0.2", "0", "0.6"),
    LOCAL_VIEWER(Group.LIGHT, "GL_FALSE", "GL_TRUE"),
    TWO_SIDE(Group.LIGHT, "GL_TRUE", "GL_FALSE"),

    FRONT_MATERIAL(Group.MATERIAL, "brass", "emerald", "plastic", "glowing"),
    BACK_MATERIAL(Group.MATERIAL, "emerald", "brass", "plastic", "glowing"),
    SHININESS(Group.MATERIAL, "32", "0", "8", "128"),
    ALPHA(Group.MATERIAL, "1", "0.75", "0.5", "0.25"),

    POLYGON_MODE(Group.POLYGON, "GL_FILL", "GL_LINE", "GL_POINT"),
    CULL_FACE(Group.POLYGON, "off", "GL_BACK", "GL_FRONT", "GL_FRONT_AND_BACK"),
    FRONT_FACE(Group.POLYGON, "GL_CCW", "GL_CW"),

    TEXTURE_2D(Group.TEXTURE, "off", "on"),
    IMAGE(Group.TEXTURE, "map", "checker", "waves", "file"),
    SIZE(Group.TEXTURE, "256:128", "100:60", "16:8"),
    COMPONENTS(Group.TEXTURE, "3", "1", "2", "4"),
    ENV_MODE(Group.TEXTURE, "GL_MODULATE", "GL_DECAL", "GL_BLEND", "GL_REPLACE"),
    MIN_FILTER(
            Group.TEXTURE,
            "GL_LINEAR",
            "GL_NEAREST",
            "GL_NEAREST_MIPMAP_NEAREST",
            "GL_LINEAR_MIPMAP_NEAREST",
            "GL_NEAREST_MIPMAP_LINEAR",
            "GL_LINEAR_MIPMAP_LINEAR"),
    MAG_FILTER(Group.TEXTURE, "GL_LINEAR", "GL_NEAREST"),
    WRAP_S(Group.TEXTURE, "GL_REPEAT", "GL_MIRRORED_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP"),
    WRAP_T(Group.TEXTURE, "GL_REPEAT", "GL_MIRRORED_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP"),
    TEXTURE_MATRIX(Group.TEXTURE, "identity", "scale", "rotate", "translate"),
    COORDINATES(Group.TEXTURE, "even", "uneven"),
    INTERPOLATION(Group.TEXTURE, "perspective", "affine"),

    DEPTH_TEST(Group.PIXEL, "on", "off"),
    DEPTH_MASK(Group.PIXEL, "GL_TRUE", "GL_FALSE"),
    DEPTH_FUNC(Group.PIXEL, "GL_LESS", "GL_GREATER"),
    BLEND(
            Group.PIXEL,
            "off",
            "GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA",
            "GL_SRC_ALPHA:GL_ONE",
            "GL_ZERO:GL_SRC_COLOR"),
    ALPHA_TEST(Group.PIXEL, "off", "GL_GEQUAL", "GL_LESS"),
    SCISSOR_TEST(Group.PIXEL, "off", "on");

    private final Group group;
    private final List<String> options;

    /**
     * @param options the first one is what the lab opens with
     */
    Setting(Group group, String... options) {
        this.group = group;
        this.options = List.of(options);
    }

    public Group group() {
        return group;
    }

    /** What it may be, the first being what the lab opens with. */
    public List<String> options() {
        return options;
    }

    /** Lower-case name with hyphens, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
