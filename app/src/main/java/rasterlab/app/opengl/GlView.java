package rasterlab.app.opengl;

import java.util.Locale;
import java.util.function.UnaryOperator;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;

/** Scenes on which a state is seen to matter or to fail. */
public enum GlView {
    /** One-sided light: lit as the front is, the tube's inner side is dark or wrong. */
    ONE_SIDE(
            choice ->
                    choice.with(Setting.TWO_SIDE, "GL_FALSE")
                            .with(Setting.LIGHT_PLACE, "inside")
                            .turned(0, 20)),
    /** Light reckoned in four corners only: the highlight inside is lost. */
    LOST_HIGHLIGHT(
            choice ->
                    choice.with(Setting.SCENE, "quad")
                            .with(Setting.TEXTURE_2D, "off")
                            .with(Setting.SHININESS, "128")
                            .turned(0, -15)),
    /** Coordinates linear on the picture, which is wrong in perspective. */
    AFFINE(
            choice ->
                    choice.with(Setting.SCENE, "quad")
                            .with(Setting.IMAGE, "checker")
                            .with(Setting.ENV_MODE, "GL_REPLACE")
                            .with(Setting.INTERPOLATION, "affine")
                            .turned(15, 10)),
    /** Texels smaller than pixels, of which one is taken. */
    ALIASING(
            choice ->
                    choice.with(Setting.SCENE, "quad")
                            .with(Setting.IMAGE, "checker")
                            .with(Setting.ENV_MODE, "GL_REPLACE")
                            .with(Setting.MIN_FILTER, "GL_NEAREST")
                            .with(Setting.TEXTURE_MATRIX, "scale")
                            .turned(12, 45)
                            .dollied(2)),
    /** All meridians of the map meet in one point. */
    POLES(choice -> choice.with(Setting.SCENE, "globe").turned(0, 40)),
    /** Most depths lie right before the near plane, few are left for the scene. */
    DEPTH_BITS(choice -> choice.with(Setting.NEAR_FAR, "0.001:100000")),
    /** The nearer surface is drawn first and hides the one that should shine through it. */
    BLEND_ORDER(
            choice ->
                    choice.with(Setting.BLEND, "GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA")
                            .with(Setting.ALPHA, "0.5")),
    /** No depth test: the last triangle wins. */
    NO_DEPTH(choice -> choice.with(Setting.DEPTH_TEST, "off"));

    private final UnaryOperator<GlChoice> change;

    GlView(UnaryOperator<GlChoice> change) {
        this.change = change;
    }

    /** Lower-case name with hyphens, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The choice that shows it. */
    public GlChoice choice() {
        return change.apply(GlChoice.first());
    }
}
