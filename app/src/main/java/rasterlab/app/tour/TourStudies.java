package rasterlab.app.tour;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;

/**
 * Studies for the parts of one tour: each is measured when it is first asked for, and only then.
 */
final class TourStudies {
    private final StudySettings settings;
    private final Texts texts;
    private final Consumer<String> progress;
    private final Map<String, Study> studies = new HashMap<>();

    /**
     * @param settings how long each study takes its time
     * @param texts the tour's
     * @param progress told about each topic whether it is measured or only shown again
     */
    TourStudies(StudySettings settings, Texts texts, Consumer<String> progress) {
        this.settings = settings;
        this.texts = texts;
        this.progress = progress;
    }

    Study of(Topic<?, ?, ?> topic) {
        String step = studies.containsKey(topic.name()) ? "study.again" : "study.measuring";
        progress.accept(texts.text(step, topic.name()));
        return studies.computeIfAbsent(topic.name(), name -> measure(topic));
    }

    private Study measure(Topic<?, ?, ?> topic) {
        return StudyRunner.measure(
                topic, settings, step -> {}, Thread.currentThread()::isInterrupted);
    }
}
