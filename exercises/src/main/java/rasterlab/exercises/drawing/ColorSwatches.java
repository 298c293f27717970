package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorSheet;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.raster.PixelMark;

/**
 * Several colours in all models as patches: a row for each colour, a column for each model, the
 * right colour on the left half of a patch and the one that came on the right half. A cross marks
 * numbers that are off by more than four of 255 levels, whatever colour they look like.
 */
public final class ColorSwatches {
    private static final int LEFT = 34;
    private static final int TOP = 26;
    private static final int WIDTH = 84;
    private static final int HEIGHT = 34;
    private static final int GAP = 6;
    private static final int LEVELS = 255;
    private static final double SEEN = 4.0 / LEVELS;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);

    private final ColorConverter converter = new ColorTopic().method("formula").implementation();
    private final ColorSheet exact;
    private final ColorSheet actual;
    private final int count;

    /**
     * @param exact the right numbers
     * @param actual numbers of as many colours
     */
    public ColorSwatches(ColorSheet exact, ColorSheet actual) {
        this.exact = exact;
        this.actual = actual;
        count = exact.in(ColorModel.RGB).length / ColorModel.RGB.size();
    }

    /** The picture as PNG; it has no numbers but those of its rows. */
    public byte[] png() {
        int columns = ColorModel.values().length;
        var image =
                new BufferedImage(
                        LEFT + columns * (WIDTH + GAP),
                        TOP + count * (HEIGHT + GAP),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Ink.PAPER);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.setFont(FONT);
        for (ColorModel model : ColorModel.values()) column(g, model);
        g.setColor(Ink.LABEL);
        for (int i = 0; i < count; i++) g.drawString((i + 1) + ".", 8, y(i) + 22);
        g.dispose();
        return PngBytes.small(image);
    }

    private void column(Graphics2D g, ColorModel model) {
        int x = LEFT + model.ordinal() * (WIDTH + GAP);
        g.setColor(Ink.LABEL);
        g.drawString(model.code(), x + 2, 18);
        for (int i = 0; i < count; i++) {
            double[] right = numbers(exact, model, i);
            double[] came = numbers(actual, model, i);
            patch(g, x, y(i), color(model, right));
            patch(g, x + WIDTH / 2, y(i), color(model, came));
            g.setColor(Ink.GRID);
            g.drawRect(x, y(i), WIDTH, HEIGHT);
            if (isWrong(model, right, came))
                PixelMark.EXTRA.paint(g, x + WIDTH / 2.0 + 6, y(i) + 2.0, HEIGHT - 4);
        }
    }

    private static int y(int row) {
        return TOP + row * (HEIGHT + GAP);
    }

    private static double[] numbers(ColorSheet sheet, ColorModel model, int place) {
        int size = model.size();
        return Arrays.copyOfRange(sheet.in(model), place * size, (place + 1) * size);
    }

    private static void patch(Graphics2D g, int x, int y, Color color) {
        g.setColor(color);
        g.fillRect(x, y, WIDTH / 2, HEIGHT);
    }

    /** The colour of those numbers; that of the paper where they are none. */
    private Color color(ColorModel model, double[] numbers) {
        try {
            double[] rgb = converter.convert(model, numbers.clone(), ColorModel.RGB);
            return new Color(level(rgb[0]), level(rgb[1]), level(rgb[2]));
        } catch (IllegalArgumentException refused) {
            return Ink.PAPER;
        }
    }

    private static int level(double share) {
        return (int) Math.round(LEVELS * Math.max(0, Math.min(1, share)));
    }

    /** Whether a number is off by more than is seen, or is none where the right one is. */
    static boolean isWrong(ColorModel model, double[] right, double[] came) {
        for (int i = 0; i < right.length; i++) {
            if (Double.isNaN(right[i]) != Double.isNaN(came[i])) return true;
            double apart = Math.abs(right[i] - came[i]) / model.highest(i);
            if (apart > SEEN && !(model.isHue(i) && 1 - apart <= SEEN)) return true;
        }
        return false;
    }
}
