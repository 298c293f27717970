package rasterlab.app.language;

import java.util.Locale;

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

    /** The language of the system, English when the window does not speak that one. */
    public static Language of(Locale system) {
        return system.getLanguage().equals(RUSSIAN.locale.getLanguage()) ? RUSSIAN : ENGLISH;
    }
}
