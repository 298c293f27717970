package rasterlab.app.study.front;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LeaderColumn;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Regime;
import rasterlab.engine.study.Study;

/**
 * The error of each method along the size of its input: exact results in one band below, those that
 * have no error to tell, or no answer, in a row above. Strips at the top are the regimes, each with
 * the method that is best there, grey where that is open.
 */
public final class ErrorByInputChart implements StudyPicture {
    private static final int TOP = 62;
    private static final int STRIP = 40;
    private static final int BAND = 36;
    private static final Color EXACT = new Color(0, 158, 115, 32);
    private static final Color FAILED = new Color(213, 94, 0, 32);

    /** The strip where it is open which method is best. */
    private static final Color OPEN = new Color(128, 128, 128);

    private final Study study;
    private final StudyWords words;
    private final ChartLook paper;
    private final List<Measurement> points;
    private final List<Regime> regimes;
    private final MethodLines lines;

    /** The errors over the workloads that differ in nothing but their size. */
    public ErrorByInputChart(Study study, StudyWords words, ChartLook paper) {
        this.study = study;
        this.words = words;
        this.paper = paper;
        String kind = SizesChart.kindOfMost(study);
        points =
                study.measurements().stream()
                        .filter(one -> SizesChart.kind(one).equals(kind))
                        .filter(one -> one.cost().timed() || isFailed(one))
                        .sorted(Comparator.comparingInt(Measurement::size))
                        .toList();
        regimes =
                Regime.along(study, points.stream().map(Measurement::workload).distinct().toList());
        List<String> methods =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        lines = new MethodLines(MethodLines.looks(study.topic(), methods, paper), paper);
    }

    private static boolean isFailed(Measurement one) {
        return !one.isAnswered();
    }

    /** Whether a point has a place in the row of failures. */
    private static boolean isEndless(Measurement one) {
        return isFailed(one) || Double.isInfinite(ParetoFront.error(one));
    }

    @Override
    public void paint(Graphics2D graphics, double width, double height) {
        new ChartPage(
                        paper,
                        words.locale(),
                        TOP,
                        words.byInputTitle(study),
                        methods().stream().map(words::called).toList(),
                        words.byInputNote(study, regimes))
                .paint(
                        graphics,
                        width,
                        height,
                        (frame, plot) -> paintPoints(graphics, frame, plot));
    }

    private List<String> methods() {
        return points.stream().map(Measurement::method).distinct().toList();
    }

    private void paintPoints(Graphics2D graphics, PlotFrame frame, Rectangle2D plot) {
        List<Double> sizes = points.stream().map(one -> (double) one.size()).toList();
        List<Double> errors =
                points.stream()
                        .filter(one -> !isEndless(one))
                        .map(ParetoFront::error)
                        .filter(error -> error > 0)
                        .toList();
        double failed =
                plot.getMinY()
                        + (points.stream().anyMatch(ErrorByInputChart::isEndless) ? BAND : 0);
        double exact = errors.isEmpty() ? failed : plot.getMaxY() - BAND;
        LogScale across = LogScale.over(sizes, plot.getMinX(), plot.getMaxX());
        LogScale up = LogScale.over(errors, exact - 6, failed + 10);
        band(graphics, FAILED, plot, plot.getMinY(), failed);
        band(graphics, EXACT, plot, exact, plot.getMaxY());
        frame.axisRight(across, sizes.stream().distinct().toList(), words.sizeAxis(study));
        if (errors.isEmpty()) frame.wordsUp(words.errorAxis(study));
        else frame.axisUp(up, words.errorAxis(study));
        frame.besideLeft(words.exactShort(), (exact + plot.getMaxY()) / 2);
        List<String> above = wordsAbove();
        for (int i = 0; i < above.size(); i++)
            frame.besideLeft(
                    above.get(i),
                    plot.getMinY() + (failed - plot.getMinY()) * (i + 0.5) / above.size());
        strips(graphics, across, plot);
        var labels = new ArrayList<LeaderColumn.LeaderLabel>();
        for (String method : methods())
            labels.add(
                    lines.draw(
                            graphics,
                            method,
                            words.called(method),
                            places(
                                    method,
                                    one ->
                                            new Point2D.Double(
                                                    across.at(one.size()),
                                                    isEndless(one)
                                                            ? (failed + plot.getMinY()) / 2
                                                            : ParetoFront.error(one) == 0
                                                                    ? (exact + plot.getMaxY()) / 2
                                                                    : up.at(
                                                                            ParetoFront.error(
                                                                                    one))))));
        MethodLines.name(graphics, labels, plot);
    }

    /** The meaning of the row of failures: each kind that there is. */
    private List<String> wordsAbove() {
        var said = new ArrayList<String>();
        if (points.stream().anyMatch(one -> isEndless(one) && !isFailed(one)))
            said.add(words.notRightShort());
        if (points.stream().anyMatch(ErrorByInputChart::isFailed)) said.add(words.noAnswerShort());
        return said;
    }

    private List<Point2D> places(String method, Function<Measurement, Point2D> place) {
        return points.stream().filter(one -> one.method().equals(method)).map(place).toList();
    }

    private static void band(
            Graphics2D graphics, Color color, Rectangle2D plot, double top, double bottom) {
        graphics.setColor(color);
        graphics.fill(new Rectangle2D.Double(plot.getMinX(), top, plot.getWidth(), bottom - top));
    }

    /** The regimes above the plot, each from half the way to its neighbour. */
    private void strips(Graphics2D graphics, LogScale across, Rectangle2D plot) {
        graphics.setFont(LeaderColumn.FONT);
        double left = plot.getMinX();
        for (int i = 0; i < regimes.size(); i++) {
            Regime regime = regimes.get(i);
            double right =
                    i + 1 < regimes.size()
                            ? across.at(Math.sqrt((double) regime.to() * regimes.get(i + 1).from()))
                            : plot.getMaxX();
            graphics.setColor(
                    regime.isOpen() ? OPEN : lines.looks().get(regime.methods().get(0)).color());
            graphics.fill(new Rectangle2D.Double(left, STRIP + 14, right - left - 1, 5));
            graphics.setColor(paper.ink());
            String name = words.best(regime);
            if (graphics.getFontMetrics().stringWidth(name) < right - left)
                graphics.drawString(name, (float) left + 2, STRIP + 10);
            left = right;
        }
    }
}
