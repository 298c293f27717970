package rasterlab.app.opengl.state;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.texture.Texture;

/** The lab's own images for textures, made for each size and number of components. */
public final class LabImages {
    private static final int CHECKERS = 8;

    private List<Object> made = List.of();
    private Texture texture;

    /** The texture of a choice; the same one as long as it stays the same. */
    public synchronized Optional<Texture> of(GlChoice choice) {
        if (choice.is(Setting.TEXTURE_2D, "off")) return Optional.empty();
        List<Object> asked =
                List.of(
                        choice.get(Setting.IMAGE),
                        choice.get(Setting.SIZE),
                        choice.get(Setting.COMPONENTS),
                        choice.file());
        if (!asked.equals(made)) texture = make(choice);
        made = asked;
        return Optional.of(texture);
    }

    private static Texture make(GlChoice choice) {
        int components = Integer.parseInt(choice.get(Setting.COMPONENTS));
        if (choice.is(Setting.IMAGE, "file")) return file(choice, components);
        String[] size = choice.parts(Setting.SIZE);
        int width = Integer.parseInt(size[0]);
        int height = Integer.parseInt(size[1]);
        int[] argb = new int[width * height];
        for (int i = 0; i < argb.length; i++) {
            double s = (i % width + 0.5) / width;
            double t = (i / width + 0.5) / height;
            argb[i] =
                    switch (choice.get(Setting.IMAGE)) {
                        case "checker" -> checker(s, t);
                        case "waves" -> waves(s, t);
                        default -> map(s, t);
                    };
        }
        return texture(width, height, components, argb);
    }

    private static Texture file(GlChoice choice, int components) {
        Texture image = choice.file().orElseThrow().texture();
        int width = image.width();
        int height = image.height();
        int[] argb = new int[width * height];
        for (int i = 0; i < argb.length; i++) argb[i] = image.level(0).texel(i % width, i / width);
        return texture(width, height, components, argb);
    }

    /** The texture, with one or two components of the grey that the eye takes a colour for. */
    private static Texture texture(int width, int height, int components, int[] argb) {
        if (components < 3)
            for (int i = 0; i < argb.length; i++) {
                int p = argb[i];
                int gray =
                        (299 * (p >> 16 & 255) + 587 * (p >> 8 & 255) + 114 * (p & 255) + 500)
                                / 1000;
                argb[i] = p & 0xFF00FFFF | gray << 16;
            }
        return Texture.of(width, height, components, argb);
    }

    private static int checker(double s, double t) {
        boolean dark = ((int) (s * CHECKERS) + (int) (t * CHECKERS)) % 2 == 0;
        return dark ? 0x60303848 : 0xFFF2EEDC;
    }

    /** Colours that change slowly, so that neighbouring texels differ little. */
    private static int waves(double s, double t) {
        int red = wave(2 * s);
        int green = wave(2 * t);
        return wave(s + t) << 24 | red << 16 | green << 8 | 255 - (red + green) / 2;
    }

    private static int wave(double turns) {
        return (int) Math.round(128 + 100 * Math.sin(2 * Math.PI * turns));
    }

    /**
     * A made-up map of the world: land where a sum of waves is high, ice towards the poles, a line
     * every 30 degrees; the sea is half transparent.
     */
    private static int map(double s, double t) {
        double east = 2 * Math.PI * s;
        double north = Math.PI * (t - 0.5);
        double height =
                Math.sin(2 * east + 1.5 * Math.sin(3 * north)) * Math.cos(north)
                        + 0.6 * Math.sin(3 * east - 4 * north)
                        + 0.4 * Math.cos(5 * east + 2 * north);
        if (onLine(s * 12) || onLine(t * 6)) return 0xFFF8F4E0;
        if (Math.abs(north) > 1.25 + 0.08 * Math.sin(7 * east)) return 0xFFF4F8FC;
        if (height < 0.15) return 0x80000000 | 0x2860A8;
        return height < 0.75 ? 0xFF4C9A4A : 0xFFB08A50;
    }

    private static boolean onLine(double cells) {
        double beside = cells - Math.rint(cells);
        return Math.abs(beside) < 0.04;
    }
}
