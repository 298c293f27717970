package rasterlab.app.opengl.state;

import java.util.List;
import java.util.Locale;

/**
 * A state of OpenGL that a control sets, and what it may be: names as the program writes them,
 * numbers, or words of our own.
 */
public enum Setting {
    SCENE(Group.SCENE, "glBegin, glEnd", "sphere", "quad", "globe"),
    PROJECTION(Group.SCENE, "glFrustum, glOrtho", "perspective", "ortho"),
    NEAR_FAR(Group.SCENE, "glFrustum(…, near, far)", "1:20", "0.001:100000"),
    DISPLAY_LIST(Group.SCENE, "glNewList, glEndList, glCallList", "off", "on"),

    LIGHTING(
            Group.LIGHT,
            "glEnable(GL_LIGHTING), glColorMaterial",
            "light-material",
            "light-color",
            "color"),
    SHADE_MODEL(Group.LIGHT, "glShadeModel", "GL_SMOOTH", "GL_FLAT"),
    LIGHTS(Group.LIGHT, "glEnable(GL_LIGHT0) …", "1", "2", "8"),
    LIGHT_PLACE(Group.LIGHT, "glLightfv(…, GL_POSITION, …)", "front", "inside", "far"),
    LIGHT_TERMS(
            Group.LIGHT,
            "glLightfv(…, GL_AMBIENT, …), GL_DIFFUSE, GL_SPECULAR",
            "all",
            "ambient",
            "diffuse",
            "specular"),
    SPOT(Group.LIGHT, "glLightf(…, GL_SPOT_CUTOFF, …), GL_SPOT_EXPONENT", "180", "30", "30:16"),
    ATTENUATION(
            Group.LIGHT,
            "glLightf(…, GL_CONSTANT_ATTENUATION, …), LINEAR, QUADRATIC",
            "1:0:0",
            "0:1:0",
            "0.5:0:0.5"),
    GLOBAL_AMBIENT(Group.LIGHT, "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, …)", "0.2", "0", "0.6"),
    LOCAL_VIEWER(
            Group.LIGHT, "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, …)", "GL_FALSE", "GL_TRUE"),
    TWO_SIDE(Group.LIGHT, "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, …)", "GL_TRUE", "GL_FALSE"),

    FRONT_MATERIAL(
            Group.MATERIAL,
            "glMaterialfv(GL_FRONT, …)",
            "brass",
            "emerald",
            "plastic",
            "chalk",
            "glowing"),
    BACK_MATERIAL(
            Group.MATERIAL,
            "glMaterialfv(GL_BACK, …)",
            "emerald",
            "brass",
            "plastic",
            "chalk",
            "glowing"),
    SHININESS(Group.MATERIAL, "glMaterialf(…, GL_SHININESS, …)", "32", "0", "8", "128"),
    ALPHA(
            Group.MATERIAL,
            "glColor4f(…, alpha), glMaterialfv(…, GL_DIFFUSE, …)",
            "1",
            "0.75",
            "0.5",
            "0.25"),

    POLYGON_MODE(Group.POLYGON, "glPolygonMode", "GL_FILL", "GL_LINE", "GL_POINT"),
    CULL_FACE(
            Group.POLYGON,
            "glEnable(GL_CULL_FACE), glCullFace",
            "off",
            "GL_BACK",
            "GL_FRONT",
            "GL_FRONT_AND_BACK"),
    FRONT_FACE(Group.POLYGON, "glFrontFace", "GL_CCW", "GL_CW"),

    TEXTURE_2D(Group.TEXTURE, "glEnable(GL_TEXTURE_2D)", "off", "on"),
    IMAGE(Group.TEXTURE, "glBindTexture, glTexImage2D", "map", "checker", "waves", "file"),
    SIZE(Group.TEXTURE, "glTexImage2D(…, width, height, …)", "256:128", "100:60", "16:8"),
    COMPONENTS(Group.TEXTURE, "glTexImage2D(…, format, …)", "3", "1", "2", "4"),
    ENV_MODE(
            Group.TEXTURE,
            "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, …)",
            "GL_MODULATE",
            "GL_DECAL",
            "GL_BLEND",
            "GL_REPLACE"),
    MIN_FILTER(
            Group.TEXTURE,
            "glTexParameteri(…, GL_TEXTURE_MIN_FILTER, …)",
            "GL_LINEAR",
            "GL_NEAREST",
            "GL_NEAREST_MIPMAP_NEAREST",
            "GL_LINEAR_MIPMAP_NEAREST",
            "GL_NEAREST_MIPMAP_LINEAR",
            "GL_LINEAR_MIPMAP_LINEAR"),
    MAG_FILTER(
            Group.TEXTURE,
            "glTexParameteri(…, GL_TEXTURE_MAG_FILTER, …)",
            "GL_LINEAR",
            "GL_NEAREST"),
    WRAP_S(
            Group.TEXTURE,
            "glTexParameteri(…, GL_TEXTURE_WRAP_S, …)",
            "GL_REPEAT",
            "GL_MIRRORED_REPEAT",
            "GL_CLAMP_TO_EDGE",
            "GL_CLAMP"),
    WRAP_T(
            Group.TEXTURE,
            "glTexParameteri(…, GL_TEXTURE_WRAP_T, …)",
            "GL_REPEAT",
            "GL_MIRRORED_REPEAT",
            "GL_CLAMP_TO_EDGE",
            "GL_CLAMP"),
    TEXTURE_MATRIX(
            Group.TEXTURE, "glMatrixMode(GL_TEXTURE)", "identity", "scale", "rotate", "translate"),
    COORDINATES(Group.TEXTURE, "glTexCoord2f", "even", "uneven"),
    INTERPOLATION(
            Group.TEXTURE, "glHint(GL_PERSPECTIVE_CORRECTION_HINT, …)", "perspective", "affine"),

    DEPTH_TEST(Group.PIXEL, "glEnable(GL_DEPTH_TEST)", "on", "off"),
    DEPTH_MASK(Group.PIXEL, "glDepthMask", "GL_TRUE", "GL_FALSE"),
    DEPTH_FUNC(Group.PIXEL, "glDepthFunc", "GL_LESS", "GL_GREATER"),
    BLEND(
            Group.PIXEL,
            "glEnable(GL_BLEND), glBlendFunc",
            "off",
            "GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA",
            "GL_SRC_ALPHA:GL_ONE",
            "GL_ZERO:GL_SRC_COLOR"),
    ALPHA_TEST(Group.PIXEL, "glEnable(GL_ALPHA_TEST), glAlphaFunc", "off", "GL_GEQUAL", "GL_LESS"),
    SCISSOR_TEST(Group.PIXEL, "glEnable(GL_SCISSOR_TEST), glScissor", "off", "on");

    private final Group group;
    private final String call;
    private final List<String> options;

    /**
     * @param call what sets it in a program
     * @param options the first one is what the lab opens with
     */
    Setting(Group group, String call, String... options) {
        this.group = group;
        this.call = call;
        this.options = List.of(options);
    }

    public Group group() {
        return group;
    }

    /** The call that sets it in a program, such as {@code glShadeModel}. */
    public String call() {
        return call;
    }

    /** The values that it may have; the lab opens with the first. */
    public List<String> options() {
        return options;
    }

    /** Lower-case name with hyphens, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
