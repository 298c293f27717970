package rasterlab.app.canvas.method;

import java.awt.Color;
import java.util.List;
import java.util.Map;
import rasterlab.engine.raster.PixelMark;

/**
 * The palette of the methods' colours, and what stands out from what.
 *
 * <p>A topic's card tells which method has which, in its lab and in every chart. The first eleven
 * of the palette are told apart with every common colour blindness; where more are needed, marks
 * and dashes help. {@link #VERMILLION} belongs to wrong pixels, no method has it. Source: M. Okabe,
 * K. Ito, Color Universal Design, 2008.
 */
public final class MethodColors {
    public static final Color ORANGE = new Color(0xE69F00);
    public static final Color SKY_BLUE = new Color(0x56B4E9);
    public static final Color GREEN = new Color(0x009E73);
    public static final Color YELLOW = new Color(0xF0E442);
    public static final Color BLUE = new Color(0x0072B2);
    public static final Color VERMILLION = PixelMark.COLOR;
    public static final Color PURPLE = new Color(0xCC79A7);
    public static final Color GRAY = new Color(0x7F7F7F);

    /** This and the next two: P. Tol, Colour schemes, 2021, palette "muted". */
    public static final Color WINE = new Color(0x882255);

    public static final Color INDIGO = new Color(0x332288);
    public static final Color OLIVE = new Color(0x999933);

    /** The palette "dark" of the same source. */
    public static final Color DARK_GREEN = new Color(0x225522);

    /** The palette "muted" again. */
    public static final Color MAGENTA = new Color(0xAA4499);

    /** The palette "light". */
    public static final Color ROSE = new Color(0xFFAABB);

    /**
     * This and the next four are of no published palette, whose like-named colours are too near to
     * those above: they were found by measuring, as the class's tests do.
     */
    public static final Color BROWN = new Color(0x692B04);

    public static final Color SLATE = new Color(0x4F5769);
    public static final Color TEAL = new Color(0x49C796);
    public static final Color SAND = new Color(0xCFCB9A);
    public static final Color VIOLET = new Color(0xA000F0);

    /**
     * The colours for lines on a dark ground, in which the usual ones drown; merely paler, they
     * would be others. No published palette: these were found by measuring, as the class's tests
     * do, the contrast with the dark stage, at least 3, the distance from every other colour of the
     * palette, at least 0.12 in OKLab, and the same with red and green taken together: as far as on
     * white, or 40 levels.
     */
    private static final Map<Color, Color> ON_DARK =
            Map.of(
                    WINE, new Color(0xF8DEF1),
                    INDIGO, new Color(0x2F59FB),
                    DARK_GREEN, new Color(0xD8FFC7),
                    BROWN, new Color(0x915F1A),
                    SLATE, new Color(0x3D8CFF));

    /** The colours of methods without one of their own, those first that differ most. */
    static final List<Color> PALETTE =
            List.of(
                    BLUE,
                    ORANGE,
                    GREEN,
                    PURPLE,
                    SKY_BLUE,
                    WINE,
                    GRAY,
                    YELLOW,
                    INDIGO,
                    OLIVE,
                    DARK_GREEN,
                    TEAL,
                    ROSE,
                    BROWN,
                    MAGENTA,
                    SLATE,
                    SAND,
                    VIOLET);

    private MethodColors() {}

    /**
     * The colour's darker or lighter kin that stands out from a ground with a contrast of at least
     * 3, for the edges of pixels.
     */
    public static Color edgeOn(Color ground, Color color) {
        return standingOut(ground, color, 3);
    }

    /**
     * The method's colour with a contrast of at least 4.5, for words and thin lines.
     *
     * <p>Source: W3C, Web Content Accessibility Guidelines 2.1, 2018, 1.4.3.
     */
    public static Color textOn(Color ground, Color color) {
        return standingOut(ground, color, 4.5);
    }

    /**
     * The colour, or where that drowns in a dark ground its kin there, with a contrast of at least
     * 3: for wide lines and marks.
     */
    public static Color lineOn(Color ground, Color color) {
        Color kin = inkOn(ground).equals(Color.WHITE) ? ON_DARK.getOrDefault(color, color) : color;
        return contrast(kin, ground) >= 3 ? kin : edgeOn(ground, kin);
    }

    private static Color standingOut(Color ground, Color color, double contrast) {
        Color end = inkOn(ground);
        for (int part = 1; part < 16; part++) {
            Color mixed = mix(color, end, part / 16.0);
            if (contrast(mixed, ground) >= contrast) return mixed;
        }
        return end;
    }

    /**
     * @param share of {@code other}, in [0, 1]
     */
    public static Color mix(Color one, Color other, double share) {
        return new Color(
                level(one.getRed(), other.getRed(), share),
                level(one.getGreen(), other.getGreen(), share),
                level(one.getBlue(), other.getBlue(), share));
    }

    private static int level(int one, int other, double share) {
        return (int) Math.round(one + (other - one) * share);
    }

    /** Black or white, whichever stands out more on that colour. */
    public static Color inkOn(Color background) {
        return contrast(Color.BLACK, background) >= contrast(Color.WHITE, background)
                ? Color.BLACK
                : Color.WHITE;
    }

    /**
     * Contrast of two colours, from 1 (equal) to 21 (black on white).
     *
     * <p>(L₁ + 0.05) / (L₂ + 0.05), L being the relative luminance in [0, 1], the greater one
     * first. Source: W3C, Web Content Accessibility Guidelines 2.1, 2018.
     */
    public static double contrast(Color one, Color other) {
        double a = luminance(one) + 0.05;
        double b = luminance(other) + 0.05;
        return Math.max(a, b) / Math.min(a, b);
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed())
                + 0.7152 * linear(color.getGreen())
                + 0.0722 * linear(color.getBlue());
    }

    /** Converts an sRGB level in 0..255 to linear light in [0, 1]. */
    private static double linear(int level) {
        double s = level / 255.0;
        return s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
    }
}
