package rasterlab.app.language;

import java.util.Locale;
import rasterlab.exercises.words.PluralForms;

/** A language that the window speaks. */
public enum Language {
    ENGLISH(Locale.ENGLISH, "English"),
    RUSSIAN(Locale.forLanguageTag("ru"), "Русский");

    private final Locale locale;
    private final String ownName;

    Language(Locale locale, String ownName) {
        this.locale = locale;
        this.ownName = ownName;
    }

    public Locale locale() {
        return locale;
    }

    /** The language's name in itself, as a chooser shows it. */
    public String ownName() {
        return ownName;
    }

    /** The command of a shell that answers in this language, for {@code words} behind ./lab. */
    public String command(String words) {
        return "./lab " + (this == ENGLISH ? "" : "--lang " + locale.getLanguage() + " ") + words;
    }

    /**
     * Which form a noun takes behind a number.
     *
     * <p>Source: Unicode CLDR, Language Plural Rules, cardinal numbers of English and Russian.
     *
     * @return {@code one}, {@code few}, {@code many} or {@code other}; English has one and other
     */
    public String plural(double number) {
        return PluralForms.name(number, locale);
    }

    /** The language of the system, English when the window does not speak that one. */
    public static Language of(Locale system) {
        return system.getLanguage().equals(RUSSIAN.locale.getLanguage()) ? RUSSIAN : ENGLISH;
    }
}
