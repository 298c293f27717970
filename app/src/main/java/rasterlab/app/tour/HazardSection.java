package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Topic;

/** Every topic's method × hazard table. */
final class HazardSection implements TourPart {
    private final Function<Topic<?, ?, ?>, HazardMatrix> judge;

    HazardSection() {
        this(topic -> HazardMatrix.judged(topic, HazardTrial.WALL_LIMIT));
    }

    /**
     * @param judge gives the verdicts of a topic's methods
     */
    HazardSection(Function<Topic<?, ?, ?>, HazardMatrix> judge) {
        this.judge = judge;
    }

    @Override
    public String key() {
        return "hazards";
    }

    @Override
    public void make(TourPage page) {
        for (Topic<?, ?, ?> topic : Topics.all()) make(page, topic);
    }

    private void make(TourPage page, Topic<?, ?, ?> topic) {
        HazardMatrix matrix = judge.apply(topic);
        var called = TopicNames.in(page.texts().language());
        page.heading(page.texts().text("topic", called.topic(topic.name()), topic.name()));
        var words = new StudyWords(page.texts().language());
        List<String> heads = new ArrayList<>(List.of(page.texts().text("hazards.hazard")));
        heads.addAll(matrix.methods());
        List<List<String>> rows = new ArrayList<>();
        for (Hazard<?> hazard : topic.hazards()) {
            List<String> row = new ArrayList<>(List.of(called.hazard(topic, hazard)));
            for (String method : matrix.methods())
                row.add(verdict(words, matrix.cell(hazard.name(), method)));
            rows.add(row);
        }
        page.table(heads, rows);
        if (!matrix.asRecorded())
            throw new IllegalStateException(page.texts().text("hazards.differ"));
    }

    private static String verdict(StudyWords words, VerdictCell cell) {
        String verdict = words.verdict(cell.verdict().kind());
        return cell.asRecorded() ? verdict : verdict + " !";
    }
}
