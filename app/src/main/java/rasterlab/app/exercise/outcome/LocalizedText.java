package rasterlab.app.exercise.outcome;

import java.util.function.UnaryOperator;
import rasterlab.app.language.Language;

/** One sentence in every language of the window. */
public record LocalizedText(String english, String russian) {
    public static final LocalizedText NOTHING = new LocalizedText("", "");

    /**
     * @param inLanguage the sentence in the language of that code, "en" or "ru"
     */
    public static LocalizedText of(UnaryOperator<String> inLanguage) {
        return new LocalizedText(inLanguage.apply("en"), inLanguage.apply("ru"));
    }

    public LocalizedText above(LocalizedText next) {
        return new LocalizedText(english + "\n" + next.english, russian + "\n" + next.russian);
    }

    public String in(Language language) {
        return language == Language.ENGLISH ? english : russian;
    }
}
