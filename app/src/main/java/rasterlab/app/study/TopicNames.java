package rasterlab.app.study;

import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/**
 * Names topics and their hazards in the window's language, by texts {@code study.topic} and {@code
 * study.hazard} of the lab that shows them. A hazard that a lab has among its own is called as
 * there.
 */
public record TopicNames(Language language) {
    public static TopicNames in(Language language) {
        return new TopicNames(language);
    }

    /** The texts of the lab that shows the topic. */
    static Texts texts(String topic, Language language) {
        return Texts.of(LabRooms.card(topic).lab().texts(), language);
    }

    public String topic(String name) {
        return texts(name, language).textOr("study.topic." + name, name);
    }

    public String hazard(Topic<?, ?, ?> topic, Hazard<?> hazard) {
        Texts own = texts(topic.name(), language);
        String key = "study.hazard." + topic.name() + "." + hazard.name();
        if (own.has(key)) return own.text(key);
        return TopicTexts.of(LabRooms.card(topic.name()), language)
                .label(hazard)
                .orElse(hazard.name());
    }
}
