package rasterlab.app.coordinates.list;

import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * Tells where a topic's methods and hazards are explained.
 *
 * @param lab whose texts those are
 * @param part what stands before names in their keys, "" for nothing
 */
record TrialTexts(String lab, String part) {
    Texts in(Language language) {
        return Texts.of(lab, "topic", language);
    }

    /** What the keys of the method's texts begin with. */
    String key(Method<?> method) {
        return part + method.name();
    }

    /** What is special about the hazard. */
    String said(Hazard<?> hazard, Language language) {
        return in(language).text("hazard." + part + hazard.name());
    }
}
