package rasterlab.app.card;

import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * Words about a topic, its methods and its hazards, in one language.
 *
 * @param texts all of the topic; those on a method begin with its name
 */
public record TopicTexts(Texts texts) {
    public static TopicTexts of(String topic, Language language) {
        return new TopicTexts(Texts.ofTopic(topic, language));
    }

    /**
     * Returns the name of a mode of a lab, which may be a topic.
     *
     * @param lab the lab's texts, with its modes that are none
     */
    public static String mode(Texts lab, String code) {
        String key = "mode." + code;
        return lab.has(key) ? lab.text(key) : of(code, lab.language()).texts.text("mode");
    }

    /** The short name of the hazard; empty where it has none. */
    public Optional<String> label(Hazard<?> hazard) {
        String key = "label." + hazard.name();
        return texts.has(key) ? Optional.of(texts.text(key)) : Optional.empty();
    }

    /** The short name of the hazard; that of the command line where it has none. */
    public String title(Hazard<?> hazard) {
        return label(hazard).orElse(hazard.name());
    }

    /** A sentence on why the hazard is special. */
    public String hazard(Hazard<?> hazard) {
        return hazard(hazard.name());
    }

    /** The explanation of the hazard of that name. */
    public String hazard(String name) {
        return texts.text("hazard." + name);
    }

    /**
     * @param what "formula", "invariant", "cost", "failures" or "source"
     */
    public String about(Method<?> method, String what) {
        return texts.text(method.name() + "." + what);
    }

    /**
     * Tells the method's decision variable.
     *
     * @param english in the engine's words, taken where there are no others; "" for none
     */
    public String decision(Method<?> method, String english) {
        return english.isEmpty() ? "" : texts.textOr(method.name() + ".decision", english);
    }
}
