package rasterlab.app.study.chart;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.knowm.xchart.XYChart;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.score.SpeedFigures;

/**
 * A program's point on its topic's chart, with the topic's methods beside it, as an exercise
 * measured them in one run: times as multiples of the reference's to the right, errors upwards.
 */
public final class SpeedChart {
    private final Study study;
    private final StudyWords words;

    /**
     * @param topic of the exercise
     */
    public SpeedChart(String topic, PublishedSpeed speed, Language language) {
        this.words = new StudyWords(language);
        this.study = study(topic, speed);
    }

    private static Study study(String topic, PublishedSpeed speed) {
        SpeedFigures figures = speed.figures();
        var points = new ArrayList<Measurement>();
        points.add(point(OwnMethods.NAME, figures.ratio(), figures.error()));
        for (SpeedFigures.Method one : figures.methods())
            points.add(point(one.name(), one.ratio(), one.error()));
        return new Study(topic, speed.item(), speed.errorUnit(), points);
    }

    private static Measurement point(String method, MedianInterval ratio, double error) {
        return new Measurement(
                method,
                "",
                1,
                new Cost(ratio.median(), ratio.low(), ratio.high(), Map.of()),
                new Deviation(error, 0, 0, 0, ""),
                Verdict.Kind.EXACT,
                "");
    }

    /**
     * @param size in the chart's own units
     */
    public void paint(ChartLook paper, Dimension size, Graphics2D graphics) {
        XYChart chart = chart(paper);
        StudyChart.fitTitle(chart, size.width, graphics);
        chart.paint(graphics, size.width, size.height);
    }

    XYChart chart(ChartLook paper) {
        XYChart chart =
                StudyChart.chart(study, words, paper, point -> words.called(point.method()));
        chart.setXAxisTitle(words.ratioAxis(study));
        chart.getStyler().setLegendVisible(false);
        return chart;
    }

    /** The same for people who do not see it: each method with its time and its error. */
    public String inWords() {
        List<Measurement> points = study.measurements();
        return words.ratioAxis(study)
                + "; "
                + words.errorAxis(study)
                + ": "
                + points.stream().map(words::point).collect(Collectors.joining("; "));
    }
}
