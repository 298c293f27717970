package rasterlab.app.row;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.PixelMark;

/** Bands below each other, what is wrong in them, the error along the row; the picture beside. */
final class RowPainter {
    private static final int MARGIN = RowPlan.MARGIN;
    private static final int GAP = 12;
    private static final int MARK = 16;
    private static final int BELOW_WORDS = 4;

    /** The height for each below which there are bands and nothing else. */
    private static final int LOWEST = 10;

    /** View units that a pixel needs for a mark of its own; narrower ones share a bar. */
    private static final double MARKED = 7;

    private final Graphics2D g;
    private final Texts texts;
    private final RowChoice choice;
    private final RowScene scene;
    private final StageColors colors = StageColors.now();
    private final FontMetrics metrics;
    private final RowPlan plan;
    private final double wide;

    RowPainter(Graphics2D g, Texts texts, RowChoice choice, RowScene scene, RowPlan plan) {
        this.g = g;
        this.texts = texts;
        this.choice = choice;
        this.scene = scene;
        this.plan = plan;
        wide = plan.wide();
        metrics = g.getFontMetrics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    void paint() {
        if (wide < 1) return;
        int high = high();
        if (high < LOWEST) {
            bandsAlone();
            return;
        }
        int y = MARGIN;
        for (RowScene.ColorBand band : scene.bands()) {
            y = say(name(band), y);
            band(band, y, high);
            words(band, y + high / 2 + metrics.getAscent() / 2);
            chosen(y, high);
            y += high + GAP;
        }
        if (scene.errors().length == 0) failure(y + MARK);
        else {
            marks(y - GAP + 2);
            errors(y + MARK, high);
        }
        scene.image().filter(image -> plan.column() > 0).ifPresent(this::pictures);
    }

    /** Height of a band, and of the errors below: all of them and their words fill the stage. */
    private int high() {
        boolean answered = scene.errors().length > 0;
        int parts = scene.bands().size() + (answered ? 1 : 0);
        int words = textHeight(answered ? errorWords() : failureWords());
        for (RowScene.ColorBand band : scene.bands()) words += textHeight(name(band));
        int room = plan.height() - 2 * MARGIN - words - MARK - scene.bands().size() * GAP;
        return Math.min(room / parts, (plan.height() - 2 * MARGIN) / 3);
    }

    private String name(RowScene.ColorBand band) {
        return texts.text("band." + band.key(), OwnWords.called(choice.method(), texts.language()));
    }

    /** Draws all that a very low stage has room for, in the same order. */
    private void bandsAlone() {
        int step = plan.height() / scene.bands().size();
        int high = Math.max(1, step - 4);
        int y = 2;
        for (RowScene.ColorBand band : scene.bands()) {
            band(band, y, high);
            chosen(y, high);
            y += step;
        }
    }

    /** Returns the view y below the words. */
    private int say(String words, int y) {
        return say(words, MARGIN, plan.wide(), y);
    }

    private int say(String words, int left, int width, int y) {
        int below = y;
        g.setColor(colors.ink());
        for (String line : Wrapping.lines(words, width, metrics::stringWidth)) {
            g.drawString(line, left, below + metrics.getAscent());
            below += metrics.getHeight();
        }
        return below + BELOW_WORDS;
    }

    /** View units that the words take above a band. */
    private int textHeight(String words) {
        int lines = Wrapping.lines(words, plan.wide(), metrics::stringWidth).size();
        return lines * metrics.getHeight() + BELOW_WORDS;
    }

    private double x(double pixel) {
        return MARGIN + wide * pixel / scene.pixels();
    }

    private void band(RowScene.ColorBand band, int y, int high) {
        var row = new BufferedImage(scene.pixels(), 1, BufferedImage.TYPE_INT_ARGB);
        row.setRGB(0, 0, scene.pixels(), 1, band.argb(), 0, scene.pixels());
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(row, MARGIN, y, (int) wide, high, null);
        g.setColor(colors.axis());
        g.setStroke(new BasicStroke(1));
        g.drawRect(MARGIN, y, (int) wide, high);
    }

    /**
     * Writes words in the middle of each run of pixels with the same words, if it has room for
     * them.
     */
    private void words(RowScene.ColorBand band, int base) {
        int from = 0;
        for (int i = 1; i <= scene.pixels(); i++) {
            String words = band.words().apply(from);
            if (i < scene.pixels() && band.words().apply(i).equals(words)) continue;
            int width = metrics.stringWidth(words);
            g.setColor(MethodColors.inkOn(new Color(band.argb()[from])));
            if (x(i) - x(from) > 2 * width)
                g.drawString(words, (int) (x(from) + x(i) - width) / 2, base);
            from = i;
        }
    }

    /** Draws a frame round the chosen pixel, at least as wide as can be seen. */
    private void chosen(int y, int high) {
        double from = x(choice.pixel());
        double width = Math.max(3, wide / scene.pixels());
        var frame = new Rectangle2D.Double(from, y, width, high);
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(4));
        g.draw(frame);
        g.setColor(colors.focus());
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
            g.setColor(PixelMark.COLOR);
            g.fill(new Rectangle2D.Double(x(from), y + 3, Math.max(1, x(i + 1) - x(from)), 6));
        }
    }

    /** Writes why the method has no band. */
    private void failure(int y) {
        say(failureWords(), y);
    }

    private String failureWords() {
        String detail = scene.verdict().detail();
        return OwnWords.refusal(choice.method(), detail, texts.language())
                .orElseGet(
                        () ->
                                texts.text(
                                        scene.verdict().kind().code(),
                                        choice.method(),
                                        VerdictDetail.translated(texts.language(), detail)));
    }

    private String errorWords() {
        return Texts.ofTopic(choice.topic(), texts.language())
                .text(
                        "errors",
                        Shown.number(worst(), 3, texts.locale()),
                        scene.wrongPixels(),
                        scene.pixels());
    }

    private double worst() {
        double worst = 0;
        for (double error : scene.errors()) worst = Math.max(worst, error);
        return worst;
    }

    /** Bars from below, the worst as high as there is room. */
    private void errors(int top, int high) {
        double worst = worst();
        int y = say(errorWords(), top);
        g.setColor(colors.margin());
        g.fillRect(MARGIN, y, (int) wide, high);
        g.setColor(MethodColors.edgeOn(colors.margin(), RowColors.OWN.of(choice.method())));
        var area = new Path2D.Double();
        area.moveTo(MARGIN, y + high);
        for (int i = 0; i < scene.pixels(); i++) {
            double up = worst == 0 ? 0 : high * Math.min(1, scene.errors()[i] / worst);
            area.lineTo(x(i), y + high - up);
            area.lineTo(x(i + 1), y + high - up);
        }
        area.lineTo(MARGIN + wide, y + high);
        g.fill(area);
        g.setColor(colors.axis());
        g.drawLine(MARGIN, y + high, MARGIN + (int) wide, y + high);
    }

    /** Draws the picture, and below it the chosen pixel's footprint, as large as both fit. */
    private void pictures(RowScene.FilteredImage image) {
        String whole = texts.text("picture", image.width(), image.height());
        String enlarged = texts.text("footprint");
        int left = plan.columnLeft();
        int width = plan.column();
        int lines = Wrapping.lines(whole, width, metrics::stringWidth).size();
        lines += Wrapping.lines(enlarged, width, metrics::stringWidth).size();
        int words = lines * metrics.getHeight() + 2 * BELOW_WORDS;
        int size = Math.min(width, (plan.height() - 2 * MARGIN - words - GAP) / 2);
        if (size < MARK) return;
        var painter = new FootprintPainter(g, image, choice.pixel());
        int y = say(whole, left, width, MARGIN);
        painter.whole(left, y, size);
        y = say(enlarged, left, width, y + size + GAP);
        painter.enlarged(left, y, size);
    }
}
