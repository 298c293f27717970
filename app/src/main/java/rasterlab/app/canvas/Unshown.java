package rasterlab.app.canvas;

import java.util.Locale;
import rasterlab.app.language.Texts;

/** Why a tab cannot show an input of a topic. */
public enum Unshown {
    /** No tab is about the topic. */
    NO_TAB,
    /** Rows of depths without faces. */
    DEPTHS_ALONE,
    /** Rows or footprints of a texture without faces. */
    TEXELS_ALONE,
    /** An inner point is given, where the tab works with the corners alone. */
    INNER_POINT,
    /** A face that has no area, is not flat or not convex. */
    BROKEN_FACE,
    /** Coordinates for which there is no eye. */
    MAGNITUDE,
    /** The method fails in a picture of one size, and the tab's has another. */
    PICTURE_SIZE,
    /** A normal whose length is not 1. */
    NORMAL_LENGTH,
    /** A lamp in the point that it lights, or one that looks elsewhere. */
    LAMP,
    /** A colour that red, green and blue from 0 to 1 do not make. */
    OUTSIDE_CUBE,
    /** A case whose fields no tab reads. */
    NO_READER;

    /** The reason in the language of the texts, those of {@code canvas}. */
    public String in(Texts texts, String topic) {
        return texts.text("unshown." + code(), topic);
    }

    /** Lower-case name with hyphens. */
    String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
