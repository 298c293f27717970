package rasterlab.app.coordinates.list;

import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * Where a topic's methods and hazards are explained in other languages than the engine's.
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
        return in(language).textOr("hazard." + part + hazard.name(), hazard.description());
    }
}
