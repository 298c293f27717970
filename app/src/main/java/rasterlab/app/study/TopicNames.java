package rasterlab.app.study;

import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/**
 * What topics and their hazards are called in the window's language. A hazard that a lab has among
 * its own is called as there.
 */
public record TopicNames(Texts own) {
    public static TopicNames in(Language language) {
        return new TopicNames(Texts.of("study", "names", language));
    }

    public String topic(String name) {
        return own.textOr("topic." + name, name);
    }

    public String hazard(Topic<?, ?, ?> topic, Hazard<?> hazard) {
        String key = "hazard." + topic.name() + "." + hazard.name();
        if (own.has(key)) return own.text(key);
        return TopicTexts.of(LabRooms.card(topic.name()), own.language())
                .label(hazard)
                .orElse(hazard.name());
    }
}
