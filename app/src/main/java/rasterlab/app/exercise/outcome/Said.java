package rasterlab.app.exercise.outcome;

import java.util.function.UnaryOperator;
import rasterlab.app.language.Language;

/** One sentence in every language of the window. */
public record Said(String english, String russian) {
    public static final Said NOTHING = new Said("", "");

    /**
     * @param inLanguage the sentence in the language of that code, "en" or "ru"
     */
    public static Said of(UnaryOperator<String> inLanguage) {
        return new Said(inLanguage.apply("en"), inLanguage.apply("ru"));
    }

    public Said above(Said next) {
        return new Said(english + "\n" + next.english, russian + "\n" + next.russian);
    }

    public String in(Language language) {
        return language == Language.ENGLISH ? english : russian;
    }
}
