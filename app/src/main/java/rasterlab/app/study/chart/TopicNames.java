package rasterlab.app.study.chart;

import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/** Names topics and their hazards in the window's language. */
public record TopicNames(Language language) {
    public static TopicNames in(Language language) {
        return new TopicNames(language);
    }

    public String topic(String name) {
        return Texts.ofTopic(name, language).textOr("name", name);
    }

    public String hazard(Topic<?, ?, ?> topic, Hazard<?> hazard) {
        return TopicTexts.of(topic.name(), language).title(hazard);
    }
}
