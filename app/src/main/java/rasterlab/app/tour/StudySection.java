package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.Shown;
import rasterlab.app.study.chart.StudyChart;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/** Every topic's study as a chart and a table. */
final class StudySection implements TourPart {
    /** The sign in place of the numbers of a method that did not end or crashed. */
    private static final String NOT_TIMED = "–";

    private final TourStudies studies;

    StudySection(TourStudies studies) {
        this.studies = studies;
    }

    @Override
    public String key() {
        return "study";
    }

    @Override
    public void make(TourPage page) {
        for (Topic<?, ?, ?> topic : Topics.all()) make(page, topic);
    }

    private void make(TourPage page, Topic<?, ?, ?> topic) {
        String name = TopicNames.in(page.texts().language()).topic(topic.name());
        page.heading(page.texts().text("topic", name, topic.name()));
        Study study = studies.of(topic);
        String caption = page.texts().text("study.caption", name);
        page.large(
                page.picture(
                        "study-" + topic.name(),
                        StudyChart.image(study, page.texts().language()),
                        caption));
        var words = new StudyWords(page.texts().language());
        List<List<String>> rows = new ArrayList<>();
        for (Measurement measured : study.measurements())
            rows.add(row(measured, words, page.texts().locale()));
        page.table(
                page.texts().text("study.heads", words.item(study), words.errorUnit(study)), rows);
    }

    /** A measurement with its numbers as the locale writes them. */
    static List<String> row(Measurement measured, StudyWords words, Locale locale) {
        String verdict = words.verdict(measured.kind());
        if (!measured.cost().timed())
            return List.of(
                    measured.method(),
                    String.valueOf(measured.size()),
                    NOT_TIMED,
                    NOT_TIMED,
                    NOT_TIMED,
                    NOT_TIMED,
                    verdict);
        return List.of(
                measured.method(),
                String.valueOf(measured.size()),
                String.format(locale, "%.2f", measured.cost().medianNanos()),
                String.format(
                        locale,
                        "%.2f–%.2f",
                        measured.cost().lowNanos(),
                        measured.cost().highNanos()),
                Shown.number(measured.error().worst(), locale),
                String.valueOf(measured.error().missing() + measured.error().extra()),
                verdict);
    }
}
