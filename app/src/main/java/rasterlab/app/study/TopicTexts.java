package rasterlab.app.study;

import java.util.Map;
import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;

/** What a lab says in the window's language about a topic's methods and hazards. */
record TopicTexts(Texts texts, String hazardKey) {
    /** A lab with texts of its own, and what stands before a hazard's name in their keys. */
    private record Source(String feature, String hazardKey) {}

    private static final Map<String, Source> SOURCES =
            Map.of(
                    "line", new Source("line", "hazard."),
                    "clip-segment", new Source("clip", "hazard.segments."),
                    "clip-polygon", new Source("clip", "hazard.polygon."),
                    "clip-volume", new Source("clip", "hazard.volume."),
                    "curve", new Source("spline", "hazard."),
                    "spline-function", new Source("spline", "hazard."),
                    "depth-buffer", new Source("row", "hazard."),
                    "texture-mapping", new Source("row", "hazard."),
                    "texture-filter", new Source("row", "hazard."));

    /** Empty where no lab has such texts: the engine's English serves then. */
    static Optional<TopicTexts> of(String topic, Language language) {
        return Optional.ofNullable(SOURCES.get(topic))
                .map(
                        source ->
                                new TopicTexts(
                                        Texts.of(source.feature(), "topic", language),
                                        source.hazardKey()));
    }

    /** What is special about the hazard; empty where the engine's English serves. */
    Optional<String> hazard(Hazard<?> hazard) {
        String key = hazardKey + hazard.name();
        return texts.has(key) ? Optional.of(texts.text(key)) : Optional.empty();
    }
}
