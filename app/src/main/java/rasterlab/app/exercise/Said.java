package rasterlab.app.exercise;

import java.util.function.UnaryOperator;
import rasterlab.app.language.Language;

/** One sentence in every language of the window. */
record Said(String english, String russian) {
    static final Said NOTHING = new Said("", "");

    /**
     * @param inLanguage the sentence in the language of that code, "en" or "ru"
     */
    static Said of(UnaryOperator<String> inLanguage) {
        return new Said(inLanguage.apply("en"), inLanguage.apply("ru"));
    }

    Said above(Said next) {
        return new Said(english + "\n" + next.english, russian + "\n" + next.russian);
    }

    String in(Language language) {
        return language == Language.ENGLISH ? english : russian;
    }
}
