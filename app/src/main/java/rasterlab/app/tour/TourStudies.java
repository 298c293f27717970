package rasterlab.app.tour;

import java.util.HashMap;
import java.util.Map;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;

/**
 * Studies for the parts of one tour: each is measured when it is first asked for, and only then.
 */
final class TourStudies {
    private final Map<String, Study> measured = new HashMap<>();

    Study of(Topic<?, ?, ?> topic) {
        return measured.computeIfAbsent(topic.name(), name -> measured(topic));
    }

    private static Study measured(Topic<?, ?, ?> topic) {
        return StudyRunner.measure(
                topic,
                StudySettings.quick(),
                progress -> {},
                Thread.currentThread()::isInterrupted);
    }
}
