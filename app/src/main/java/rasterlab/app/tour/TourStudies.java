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
    private final Map<String, Study> studies = new HashMap<>();

    Study of(Topic<?, ?, ?> topic) {
        return studies.computeIfAbsent(topic.name(), name -> measure(topic));
    }

    private static Study measure(Topic<?, ?, ?> topic) {
        return StudyRunner.measure(
                topic,
                StudySettings.quick(),
                progress -> {},
                Thread.currentThread()::isInterrupted);
    }
}
