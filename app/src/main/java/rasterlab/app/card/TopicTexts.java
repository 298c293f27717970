package rasterlab.app.card;

import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * Words of a lab about a topic's methods and hazards, in one language.
 *
 * @param part what stands before names in the keys of a lab with several topics; "" for one
 * @param labels of the lab that shows the hazards
 * @param shownAs what stands before hazards' names in their keys
 */
public record TopicTexts(Texts texts, String part, Texts labels, String shownAs) {
    /** The texts of the card's topic. */
    public static TopicTexts of(TopicCard<?> card, Language language) {
        return of(card.texts(), card.labels(), language);
    }

    /**
     * @param texts where methods and hazards are explained
     * @param labels where hazards are called by their short names
     */
    public static TopicTexts of(TopicCard.Place texts, TopicCard.Place labels, Language language) {
        return new TopicTexts(
                Texts.of(texts.feature(), "topic", language),
                texts.part(),
                Texts.of(labels.feature(), language),
                labels.part());
    }

    /** The name of the hazard in the lab; empty where it does not show it. */
    public Optional<String> label(Hazard<?> hazard) {
        String key = "hazard." + shownAs + hazard.name();
        return labels.has(key) ? Optional.of(labels.text(key)) : Optional.empty();
    }

    /** A sentence on why the hazard is special. */
    public String hazard(Hazard<?> hazard) {
        return texts.text("hazard." + part + hazard.name());
    }

    /**
     * @param what "formula", "invariant", "cost", "failures" or "source"
     */
    public String about(Method<?> method, String what) {
        return texts.text(key(method) + "." + what);
    }

    /** The beginning of the keys of a method's texts. */
    public String key(Method<?> method) {
        String key = part + method.name();
        return texts.has(key + ".formula") ? key : method.name();
    }
}
