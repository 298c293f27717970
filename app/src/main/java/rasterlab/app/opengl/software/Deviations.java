package rasterlab.app.opengl.software;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;

/**
 * Why the two pictures of a choice may differ: what the software pipeline does not have, and what
 * OpenGL leaves open.
 */
public enum Deviations {
    /** The engine's depth test keeps what is nearer, no other function. */
    DEPTH_FUNC,
    /** The engine drops small alphas, not large ones. */
    ALPHA_LESS,
    /** The engine mixes by alpha only. */
    BLEND_FUNC,
    /** OpenGL is always right in perspective; the hint for less is not obeyed today. */
    AFFINE,
    /** DECAL with a texture without colours is not defined. */
    DECAL,
    /** OpenGL may choose between levels of detail within bounds. */
    LEVEL_OF_DETAIL,
    /** Where lines meet, either may draw the common pixel. */
    LINE_ENDS,
    /** Where a front and a back face meet, both edges have one depth. */
    SHARED_EDGES,
    /** Depths are whole numbers in OpenGL, floating ones in the engine. */
    DEPTH_BITS;

    /** The deviations that a choice brings about. */
    public static List<Deviations> of(GlChoice choice) {
        var found = new ArrayList<Deviations>();
        if (choice.is(Setting.DEPTH_FUNC, "GL_GREATER") && choice.is(Setting.DEPTH_TEST, "on"))
            found.add(DEPTH_FUNC);
        if (choice.is(Setting.ALPHA_TEST, "GL_LESS")) found.add(ALPHA_LESS);
        if (choice.is(Setting.BLEND, "GL_SRC_ALPHA:GL_ONE")
                || choice.is(Setting.BLEND, "GL_ZERO:GL_SRC_COLOR")) found.add(BLEND_FUNC);
        boolean wire = choice.is(Setting.SCENE, "sphere");
        boolean told =
                choice.is(Setting.SHADE_MODEL, "GL_FLAT") || !choice.is(Setting.BLEND, "off");
        if (wire && told) found.add(LINE_ENDS);
        if (choice.is(Setting.POLYGON_MODE, "GL_LINE")) found.add(SHARED_EDGES);
        if (choice.is(Setting.NEAR_FAR, "0.001:100000")) found.add(DEPTH_BITS);
        if (choice.is(Setting.TEXTURE_2D, "on")) addTextures(choice, found);
        return List.copyOf(found);
    }

    private static void addTextures(GlChoice choice, List<Deviations> found) {
        if (choice.is(Setting.INTERPOLATION, "affine")) found.add(AFFINE);
        boolean decal = choice.is(Setting.ENV_MODE, "GL_DECAL");
        if (decal && choice.number(Setting.COMPONENTS) < 3) found.add(DECAL);
        if (choice.get(Setting.MIN_FILTER).contains("MIPMAP")) found.add(LEVEL_OF_DETAIL);
    }

    /** Lower-case name with hyphens, part of keys. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
