package rasterlab.app.row;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.PixelMark;

/** Bands below each other, what is wrong in them, the error along the row, and the picture. */
final class RowPainter {
    private static final int MARGIN = 20;
    private static final int GAP = 12;
    private static final int MARK = 16;

    /** The highest that a band gets; a lower stage has lower ones. */
    private static final int HIGHEST = 84;

    /** With less for each, there are bands and nothing else. */
    private static final int LOWEST = 10;

    /** View units that a pixel needs for a mark of its own; narrower ones share a bar. */
    private static final double MARKED = 7;

    private final Graphics2D g;
    private final Texts texts;
    private final RowChoice choice;
    private final RowScene scene;
    private final StageColours colours = StageColours.now();
    private final FontMetrics metrics;
    private double wide;

    RowPainter(Graphics2D g, Texts texts, RowChoice choice, RowScene scene) {
        this.g = g;
        this.texts = texts;
        this.choice = choice;
        this.scene = scene;
        metrics = g.getFontMetrics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    /** The pixel under a view x, or the nearer end of the row. */
    static int pixelAt(int x, int width, int pixels) {
        int pixel = (int) Math.floor((x - MARGIN) * (double) pixels / (width - 2 * MARGIN));
        return Math.max(0, Math.min(pixels - 1, pixel));
    }

    void paint(int width, int height) {
        wide = width - 2.0 * MARGIN;
        boolean answered = scene.errors().length > 0;
        int parts = scene.bands().size() + 1 + (scene.image().isPresent() ? 2 : 0);
        int words = metrics.getHeight() + 4;
        int high = Math.min(HIGHEST, (height - 2 * MARGIN - MARK) / parts - words - GAP);
        if (wide < 1) return;
        if (high < LOWEST) {
            bandsAlone(height);
            return;
        }
        int y = MARGIN;
        for (RowScene.Band band : scene.bands()) {
            y = say(texts.text("band." + band.key(), choice.method()), y);
            band(band, y, high);
            words(band, y + high / 2 + metrics.getAscent() / 2);
            chosen(y, high);
            y += high + GAP;
        }
        if (!answered) y = failure(y);
        else {
            marks(y - GAP + 2);
            y = errors(y + MARK, high) + GAP;
        }
        if (scene.image().isPresent()) image(scene.image().get(), y, height - MARGIN);
    }

    /** All that a very low stage has room for, in the same order. */
    private void bandsAlone(int height) {
        int step = height / scene.bands().size();
        int high = Math.max(1, step - 4);
        int y = 2;
        for (RowScene.Band band : scene.bands()) {
            band(band, y, high);
            chosen(y, high);
            y += step;
        }
    }

    /** Returns the view y below the words. */
    private int say(String words, int y) {
        int below = y;
        g.setColor(colours.ink());
        for (String line : Wrapping.lines(words, (int) wide, metrics::stringWidth)) {
            g.drawString(line, MARGIN, below + metrics.getAscent());
            below += metrics.getHeight();
        }
        return below + 4;
    }

    private double x(double pixel) {
        return MARGIN + wide * pixel / scene.pixels();
    }

    private void band(RowScene.Band band, int y, int high) {
        var row = new BufferedImage(scene.pixels(), 1, BufferedImage.TYPE_INT_ARGB);
        row.setRGB(0, 0, scene.pixels(), 1, band.argb(), 0, scene.pixels());
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(row, MARGIN, y, (int) wide, high, null);
        g.setColor(colours.axis());
        g.setStroke(new BasicStroke(1));
        g.drawRect(MARGIN, y, (int) wide, high);
    }

    /** In the middle of each run of pixels with the same words, if it has room for them. */
    private void words(RowScene.Band band, int base) {
        int from = 0;
        for (int i = 1; i <= scene.pixels(); i++) {
            String words = band.words().apply(from);
            if (i < scene.pixels() && band.words().apply(i).equals(words)) continue;
            int width = metrics.stringWidth(words);
            g.setColor(MethodColours.inkOn(new Color(band.argb()[from])));
            if (x(i) - x(from) > 2 * width)
                g.drawString(words, (int) (x(from) + x(i) - width) / 2, base);
            from = i;
        }
    }

    /** A frame round the chosen pixel, at least as wide as can be seen. */
    private void chosen(int y, int high) {
        double from = x(choice.pixel());
        double width = Math.max(3, wide / scene.pixels());
        var frame = new Rectangle2D.Double(from, y, width, high);
        g.setColor(colours.ground());
        g.setStroke(new BasicStroke(4));
        g.draw(frame);
        g.setColor(colours.focus());
        g.setStroke(new BasicStroke(2));
        g.draw(frame);
    }

    private void marks(int y) {
        double size = Math.min(MARK - 2, wide / scene.pixels());
        for (int i = 0; i < scene.pixels(); i++) {
            if (!scene.wrong()[i]) continue;
            int from = i;
            if (size >= MARKED) {
                PixelMark.EXTRA.paint(g, (x(i) + x(i + 1) - size) / 2, y, size);
                continue;
            }
            while (i + 1 < scene.pixels() && scene.wrong()[i + 1]) i++;
            g.setColor(PixelMark.COLOUR);
            g.fill(new Rectangle2D.Double(x(from), y + 3, Math.max(1, x(i + 1) - x(from)), 6));
        }
    }

    /** Why the method has no band. */
    private int failure(int y) {
        return say(
                texts.text(
                        scene.verdict().kind().code(),
                        choice.method(),
                        Complaints.said(texts.language(), scene.verdict().detail())),
                y + MARK);
    }

    /** Bars from below, the worst as high as there is room; returns the view y below them. */
    private int errors(int top, int high) {
        double worst = 0;
        for (double error : scene.errors()) worst = Math.max(worst, error);
        int y =
                say(
                        texts.text(
                                "errors." + choice.topic(),
                                Shown.number(worst, 3, texts.locale()),
                                scene.wrongPixels(),
                                scene.pixels()),
                        top);
        g.setColor(colours.margin());
        g.fillRect(MARGIN, y, (int) wide, high);
        g.setColor(MethodColours.edgeOn(colours.margin(), MethodColours.of(choice.method())));
        var area = new Path2D.Double();
        area.moveTo(MARGIN, y + high);
        for (int i = 0; i < scene.pixels(); i++) {
            double up = worst == 0 ? 0 : high * Math.min(1, scene.errors()[i] / worst);
            area.lineTo(x(i), y + high - up);
            area.lineTo(x(i + 1), y + high - up);
        }
        area.lineTo(MARGIN + wide, y + high);
        g.fill(area);
        g.setColor(colours.axis());
        g.drawLine(MARGIN, y + high, MARGIN + (int) wide, y + high);
        return y + high;
    }

    /** The picture with the footprint of the chosen pixel, brought into it where it repeats. */
    private void image(RowScene.Image image, int top, int bottom) {
        int y = say(texts.text("picture", image.width(), image.height()), top);
        int size = bottom - y;
        if (size < MARK) return;
        var texels = new BufferedImage(image.width(), image.height(), BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < image.height(); row++)
            texels.setRGB(
                    0,
                    image.height() - 1 - row,
                    image.width(),
                    1,
                    image.argb(),
                    row * image.width(),
                    image.width());
        g.drawImage(texels, MARGIN, y, size, size, null);
        g.setColor(colours.axis());
        g.drawRect(MARGIN, y, size, size);
        footprint(image, y, size);
    }

    private void footprint(RowScene.Image image, int y, int size) {
        double[] f = image.footprints();
        int at = 6 * choice.pixel();
        double s = f[at] - Math.floor(f[at]);
        double t = f[at + 1] - Math.floor(f[at + 1]);
        var outline = new Path2D.Double();
        double[][] corners = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
        for (double[] corner : corners) {
            double px = MARGIN + size * (s + corner[0] * f[at + 2] + corner[1] * f[at + 4]);
            double py = y + size * (1 - (t + corner[0] * f[at + 3] + corner[1] * f[at + 5]));
            if (outline.getCurrentPoint() == null) outline.moveTo(px, py);
            else outline.lineTo(px, py);
        }
        outline.closePath();
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(5));
        g.draw(outline);
        g.setColor(PixelMark.COLOUR);
        g.setStroke(new BasicStroke(2));
        g.draw(outline);
    }
}
