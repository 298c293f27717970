package rasterlab.app.study.front;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.ExactBound;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.score.SpeedFigures;

/**
 * A program's point on its topic's front, with the topic's methods beside it, as an exercise
 * measured them in one run: times as multiples of the reference's to the right, errors upwards.
 */
public final class SpeedChart {
    /** The one workload, which an exercise has no name for. */
    private static final String WORKLOAD = "";

    private final Study study;
    private final StudyWords words;

    /**
     * @param topic of the exercise
     */
    public SpeedChart(String topic, PublishedSpeed speed, Language language) {
        this.words = StudyWords.ofRatios(language);
        this.study = study(topic, speed);
    }

    private static Study study(String topic, PublishedSpeed speed) {
        SpeedFigures figures = speed.figures();
        double bound = ExactBound.of(Topics.named(topic));
        var points = new ArrayList<Measurement>();
        points.add(point(OwnMethods.NAME, figures.ratio(), figures.error(), bound));
        for (SpeedFigures.MethodSpeed one : figures.methods())
            points.add(point(one.name(), one.ratio(), one.error(), bound));
        return new Study(topic, speed.item(), speed.errorUnit(), points);
    }

    /** A measurement of three rounds: of so few, the interval is all that was seen. */
    private static Measurement point(
            String method, MedianInterval ratio, double error, double bound) {
        return new Measurement(
                method,
                WORKLOAD,
                1,
                Cost.of(List.of(ratio.low(), ratio.median(), ratio.high()), Map.of()),
                new Deviation(error, 0, 0, 0, ""),
                kind(error, bound),
                "");
    }

    private static Verdict.Kind kind(double error, double bound) {
        if (error <= bound) return Verdict.Kind.EXACT;
        return Double.isFinite(error) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
    }

    /**
     * Draws it from the upper left corner, on a ground that is there.
     *
     * @param size in the chart's own units
     */
    public void paint(ChartLook paper, Dimension size, Graphics2D graphics) {
        front(paper).paint(graphics, size.width, size.height);
    }

    FrontChart front(ChartLook paper) {
        return new FrontChart(study, WORKLOAD, words, paper);
    }

    /** The chart for people who do not see it: each method with its time and its error. */
    public String inWords() {
        List<Measurement> points = study.measurements();
        return words.costAxis(study)
                + "; "
                + words.errorAxis(study)
                + ": "
                + points.stream().map(words::point).collect(Collectors.joining("; "));
    }
}
