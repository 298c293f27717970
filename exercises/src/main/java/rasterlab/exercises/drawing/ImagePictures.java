package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Raster;
import rasterlab.exercises.drawing.ThreePictures.Drawn;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.PicturePart;

/** Draws the answer of a case whose output is an image. */
public final class ImagePictures {
    /** Pixels of an image that are shown each way, at most. */
    static final int MOST = 512;

    /** The number of pixels each way up to which even a noisy image is small as a file. */
    private static final int FEWEST = 8;

    /** Sides of the squares below what is transparent, in pixels of the picture. */
    private static final int SQUARE = 8;

    private static final int LIGHT = 0xFFFFFF;
    private static final int DARK = 0xC4CAD2;

    /**
     * The enlargement from which wrong pixels are crosses; below it they are at least so many
     * pixels wide.
     */
    private static final int SMALLEST_CROSS = 8;

    private static final int SMALLEST_SPOT = 3;
    private static final double RING = 12;

    private final Raster expected;
    private final Raster actual;
    private final ImageComparison comparison;
    private final Pixel center;

    private ImagePictures(Raster expected, Raster actual, int tolerance) {
        this.expected = expected;
        this.actual = actual;
        comparison = new ImageComparison(expected, actual, tolerance);
        center = comparison.first().orElse(new Pixel(expected.width() / 2, expected.height() / 2));
    }

    /**
     * Draws the expected image, the actual one, and the expected one pale and gray under the wrong
     * pixels in red, the stronger the more they differ. Small images are enlarged by a whole
     * factor; of large or very varied ones the part around the first wrong pixel is shown. Squares
     * of two grays show through what is transparent.
     *
     * @param expected the right image
     * @param actual the image to look at, of the same size
     * @param tolerance levels, 0 to 255, by which a channel of a right pixel may differ
     * @return three pictures of one size: expected, actual, difference
     * @throws IllegalArgumentException if the sizes differ or the tolerance is negative
     */
    public static List<CasePicture> of(Raster expected, Raster actual, int tolerance) {
        return new ImagePictures(expected, actual, tolerance).drawn();
    }

    private List<CasePicture> drawn() {
        int most = MOST;
        List<CasePicture> pictures = drawn(part(most));
        while (most > FEWEST
                && pictures.stream().anyMatch(each -> each.png().length > PngBytes.MOST))
            pictures = drawn(part(most /= 2));
        return pictures;
    }

    private ImagePart part(int most) {
        return ImagePart.around(PixelWindow.of(expected), center.x(), center.y(), most);
    }

    private List<CasePicture> drawn(ImagePart part) {
        return ThreePictures.of(
                new Drawn(
                        PngBytes.of(onSquares(expected, part)),
                        size(part).and(colorSaid(expected))),
                new Drawn(PngBytes.of(onSquares(actual, part)), size(part).and(colorSaid(actual))),
                new Drawn(PngBytes.of(difference(part)), differenceSaid()));
    }

    private static BufferedImage onSquares(Raster image, ImagePart part) {
        return part.drawn(
                (column, row, x, y) ->
                        over(
                                image.argb(column, row),
                                (x / SQUARE + y / SQUARE) % 2 == 0 ? LIGHT : DARK));
    }

    /** A color 0xAARRGGBB over an opaque one. */
    private static int over(int argb, int below) {
        int alpha = argb >>> 24;
        int rgb = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int sum = (argb >> shift & 255) * alpha + (below >> shift & 255) * (255 - alpha);
            rgb |= (sum + 127) / 255 << shift;
        }
        return rgb;
    }

    private BufferedImage difference(ImagePart part) {
        BufferedImage picture =
                part.drawn((column, row, x, y) -> pale(over(expected.argb(column, row), LIGHT)));
        Graphics2D g = picture.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        PixelWindow shown = part.shown();
        for (int row = shown.ymin(); row <= shown.ymax(); row++)
            for (int column = shown.xmin(); column <= shown.xmax(); column++)
                if (comparison.wrong(column, row) > 0) spot(g, part, column, row);
        if (part.factor() < SMALLEST_CROSS)
            comparison.first().ifPresent(each -> ring(g, part, each));
        g.dispose();
        return picture;
    }

    /** A gray of 170 to 255, by the usual weights of red, green and blue (ITU-R BT.601). */
    private static int pale(int rgb) {
        int luma = (299 * (rgb >> 16 & 255) + 587 * (rgb >> 8 & 255) + 114 * (rgb & 255)) / 1000;
        return 0x010101 * (170 + luma / 3);
    }

    /** A wrong pixel, and its cross where there is room for one. */
    private void spot(Graphics2D g, ImagePart part, int column, int row) {
        int side = Math.max(SMALLEST_SPOT, part.factor());
        int out = (side - part.factor()) / 2;
        g.setColor(strength(comparison.wrong(column, row)));
        g.fillRect(part.left(column) - out, part.top(row) - out, side, side);
        if (part.factor() >= SMALLEST_CROSS)
            PixelMark.EXTRA.paint(g, part.left(column), part.top(row), side);
    }

    /** A red from light for 1 level to full for 255. */
    static Color strength(int levels) {
        double share = 0.35 + 0.65 * Math.sqrt(levels / 255.0);
        Color full = Ink.MISSING;
        return new Color(
                (int) Math.round(255 - (255 - full.getRed()) * share),
                (int) Math.round(255 - (255 - full.getGreen()) * share),
                (int) Math.round(255 - (255 - full.getBlue()) * share));
    }

    private static void ring(Graphics2D g, ImagePart part, Pixel pixel) {
        double x = part.left(pixel.x()) + part.factor() / 2.0;
        double y = part.top(pixel.y()) + part.factor() / 2.0;
        var ring = new Ellipse2D.Double(x - RING, y - RING, 2 * RING, 2 * RING);
        g.setColor(Ink.PAPER);
        g.setStroke(new BasicStroke(5));
        g.draw(ring);
        g.setColor(PixelMark.COLOUR);
        g.setStroke(new BasicStroke(2.5f));
        g.draw(ring);
    }

    private Message size(ImagePart part) {
        Message said = Message.of("drawing.image.size", expected.width(), expected.height());
        var shown = new PicturePart(part.shown(), PixelWindow.of(expected), center);
        if (!shown.isWhole()) said = said.and(shown.said());
        return part.factor() == 1
                ? said
                : said.and(Message.of("drawing.image.enlarged", part.factor()));
    }

    /** The color of the first wrong pixel, if there is any. */
    private Message colorSaid(Raster image) {
        Optional<Pixel> first = comparison.first();
        if (first.isEmpty()) return Message.NONE;
        Pixel pixel = first.get();
        int argb = image.argb(pixel.x(), pixel.y());
        return Message.of(
                "drawing.image.color",
                "(" + pixel.x() + ", " + pixel.y() + ")",
                argb >> 16 & 255,
                argb >> 8 & 255,
                argb & 255,
                argb >>> 24);
    }

    private Message differenceSaid() {
        Optional<Pixel> first = comparison.first();
        if (first.isEmpty()) return Message.of("drawing.same");
        Pixel pixel = first.get();
        return Message.of(
                        "drawing.image.wrong",
                        comparison.count(),
                        (long) expected.width() * expected.height())
                .and(
                        Message.of(
                                "drawing.image.first",
                                "(" + pixel.x() + ", " + pixel.y() + ")",
                                comparison.wrong(pixel.x(), pixel.y())));
    }
}
