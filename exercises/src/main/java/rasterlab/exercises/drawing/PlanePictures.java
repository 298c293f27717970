package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.exercises.drawing.ThreePictures.DrawnPicture;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PictureBytes;

/** Draws the answer of a case whose output lies in the plane, to scale. */
public final class PlanePictures {
    /** Width of the lines of an answer, in pixels. */
    static final double LINE = 2.4;

    /** Figures of each kind that are looked at. */
    static final int MOST = 1000;

    private static final double GIVEN_LINE = 1.6;
    private static final String ENGLISH = "en";
    private static final String COMMA = "ru";

    private final List<PlaneFigure> given;
    private final List<PlaneFigure> expected;
    private final List<PlaneFigure> actual;
    private final double tolerance;
    private final PlotAxes axes;
    private final PlaneToPixels view;

    private PlanePictures(
            List<PlaneFigure> given,
            List<PlaneFigure> expected,
            List<PlaneFigure> actual,
            double tolerance,
            YAxis axis,
            String language) {
        this.given = first(given);
        this.expected = first(expected);
        this.actual = first(actual);
        this.tolerance = tolerance;
        PlaneBox box = PlaneBox.around(this.given, this.expected, this.actual);
        axes = new PlotAxes(box, axis == YAxis.UP, language);
        view = axes.view();
    }

    /**
     * Draws what is given in gray in each picture, with what is expected, what is actual, or their
     * difference: what agrees is dark, what is missing is dashed with minus marks, what is extra
     * has plus marks. A segment that is right in part is dark in that part. Where all differences
     * are smaller than a dot, a ring is around the first.
     *
     * <p>The pictures show the surroundings of the window and of what is expected, with the same
     * scale in x and y unless they are thinner than 1:20. At most the first 1000 figures of each
     * list count.
     *
     * @param given the case's input, as far as it can be drawn
     * @param expected the right answer
     * @param actual the answer to look at
     * @param tolerance the most by which a coordinate of a right answer may differ, at least 0
     * @param axis the direction in which y grows
     * @return three pictures of one size: expected, actual, difference
     */
    public static List<CasePicture> of(
            List<PlaneFigure> given,
            List<PlaneFigure> expected,
            List<PlaneFigure> actual,
            double tolerance,
            YAxis axis) {
        if (!(tolerance >= 0))
            throw new IllegalArgumentException("tolerance must be at least 0, got " + tolerance);
        Function<String, PlanePictures> in =
                language -> new PlanePictures(given, expected, actual, tolerance, axis, language);
        return in.apply(ENGLISH).drawn(() -> in.apply(COMMA));
    }

    /**
     * @param other the same with a decimal comma
     */
    private List<CasePicture> drawn(Supplier<PlanePictures> other) {
        var comparison = new PlaneComparison(expected, actual, tolerance);
        var texts = new PlaneTexts(view, given);
        return ThreePictures.of(
                new DrawnPicture(
                        png(other, it -> it.one(it.expected, Ink.EXPECTED)),
                        texts.expected(expected)),
                new DrawnPicture(
                        png(other, it -> it.one(it.actual, Ink.ACTUAL)), texts.actual(actual)),
                new DrawnPicture(
                        png(other, it -> it.difference(comparison)), texts.difference(comparison)));
    }

    private PictureBytes png(
            Supplier<PlanePictures> other, Function<PlanePictures, byte[]> drawing) {
        byte[] usual = drawing.apply(this);
        return axes.hasFractions()
                ? PictureBytes.of(usual, Map.of(COMMA, () -> drawing.apply(other.get())))
                : PictureBytes.alike(usual);
    }

    private byte[] one(List<PlaneFigure> figures, Color color) {
        BufferedImage image = image();
        paint(
                image,
                g -> {
                    var painter = new PlanePainter(g, view);
                    painter.fills(figures, color);
                    painter.lines(given, Ink.GIVEN, GIVEN_LINE);
                    painter.lines(figures, color, LINE);
                    axes.tag(g, tag("", figures), "", color);
                });
        return PngBytes.small(image);
    }

    private byte[] difference(PlaneComparison comparison) {
        BufferedImage image = image();
        new PlaneFill(view, axes.width(), axes.height()).paint(image, expected, actual);
        paint(
                image,
                g -> {
                    new PlanePainter(g, view).lines(given, Ink.GIVEN, GIVEN_LINE);
                    new PlaneDifference(comparison, view, tolerance).paint(g);
                    String missing = tag("− ", comparison.missing());
                    String extra = tag("+ ", comparison.extra());
                    axes.tag(g, missing, extra, Ink.MISSING);
                    axes.tag(g, extra, "", Ink.EXTRA);
                });
        return PngBytes.small(image);
    }

    /** Paper with the axes and the fill of what is given. */
    private BufferedImage image() {
        var image = new BufferedImage(axes.width(), axes.height(), BufferedImage.TYPE_INT_RGB);
        paint(
                image,
                g -> {
                    g.setColor(Ink.PAPER);
                    g.fillRect(0, 0, image.getWidth(), image.getHeight());
                    axes.paint(g);
                    new PlanePainter(g, view).fills(given, Ink.GIVEN);
                });
        return image;
    }

    private static void paint(BufferedImage image, Consumer<Graphics2D> painting) {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        painting.accept(g);
        g.dispose();
    }

    /** The coordinate because of which figures are not drawn; empty where all are. */
    private static String tag(String sign, List<PlaneFigure> figures) {
        if (figures.stream().allMatch(PlaneFigure::isFinite)) return "";
        boolean none =
                figures.stream()
                        .flatMap(each -> each.points().stream())
                        .anyMatch(each -> Double.isNaN(each.x()) || Double.isNaN(each.y()));
        return sign + (none ? "NaN" : "∞");
    }

    private static List<PlaneFigure> first(List<PlaneFigure> figures) {
        return List.copyOf(figures.subList(0, Math.min(MOST, figures.size())));
    }
}
