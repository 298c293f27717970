package rasterlab.app.signmap;

import java.awt.Color;
import java.awt.image.BufferedImage;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.engine.signmap.SignMap;

/**
 * Paints a map, y growing up: each answer in its colour, and over it, where it is wrong, stripes
 * that rise to the right where it is more than right and fall where it is less.
 */
final class SignPainter {
    /** Dots from stripe to stripe, and of a stripe. */
    private static final int PERIOD = 6;

    private static final int STRIPE = 3;

    private static final double PLUS = 0.4;
    private static final double PLUS_ON_DARK = 0.65;
    private static final double ZERO = 0.85;
    private static final double MINUS = 0.28;

    private final ChartLook look;
    private final Color plus;
    private final Color zero;
    private final Color minus;

    SignPainter(ChartLook look) {
        this.look = look;
        boolean paper = look.ground().equals(Color.WHITE);
        plus = MethodColors.mix(look.ground(), MethodColors.BLUE, paper ? PLUS : PLUS_ON_DARK);
        zero = MethodColors.mix(look.ground(), MethodColors.YELLOW, ZERO);
        minus = MethodColors.mix(look.ground(), MethodColors.GRAY, MINUS);
    }

    /** The meaning of a dot of the picture. */
    enum DotMeaning {
        PLUS,
        ZERO,
        MINUS,
        EXTRA,
        MISSING,
        NONE
    }

    /**
     * @param dots of the picture for each point, across and down
     */
    BufferedImage image(SignMap map, int dots) {
        int size = dots * map.size();
        var image = new BufferedImage(size, size, BufferedImage.TYPE_INT_RGB);
        var row = new int[size];
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++)
                row[x] = color(map, x / dots, map.size() - 1 - y / dots, x, y).getRGB();
            image.setRGB(0, y, size, 1, row, 0, size);
        }
        return image;
    }

    private Color color(SignMap map, int column, int row, int x, int y) {
        int answer = map.answer(column, row);
        if (answer == SignMap.NONE) return color(DotMeaning.NONE, x, y);
        Color own = color(dot(map, answer), x, y);
        if (!map.wrong(column, row)) return own;
        DotMeaning wrong = answer > map.exact(column, row) ? DotMeaning.EXTRA : DotMeaning.MISSING;
        return striped(wrong, x, y) ? MethodColors.VERMILLION : own;
    }

    private static DotMeaning dot(SignMap map, int answer) {
        if (answer > 0) return DotMeaning.PLUS;
        return answer < 0 || map.yesOrNo() ? DotMeaning.MINUS : DotMeaning.ZERO;
    }

    /** The colour of a dot at that place of a picture. */
    Color color(DotMeaning dot, int x, int y) {
        return switch (dot) {
            case PLUS -> plus;
            case ZERO -> zero;
            case MINUS -> minus;
            case EXTRA, MISSING -> striped(dot, x, y) ? MethodColors.VERMILLION : look.ground();
            case NONE -> x % PERIOD < 2 && y % PERIOD < 2 ? MethodColors.VERMILLION : look.ground();
        };
    }

    private static boolean striped(DotMeaning wrong, int x, int y) {
        int along = wrong == DotMeaning.EXTRA ? x + y : x - y;
        return Math.floorMod(along, PERIOD) < STRIPE;
    }
}
