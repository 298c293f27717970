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

    /**
     * Which form a noun takes behind a number.
     *
     * <p>Source: Unicode CLDR, Language Plural Rules, cardinal numbers of English and Russian.
     *
     * @return {@code one}, {@code few}, {@code many} or {@code other}; English has one and other
     */
    public String plural(double number) {
        double size = Math.abs(number);
        if (this == ENGLISH) return size == 1 ? "one" : "other";
        if (size != Math.rint(size)) return "other";
        double last = size % 10;
        boolean teen = size % 100 >= 11 && size % 100 <= 14;
        if (last == 1 && !teen) return "one";
        return last >= 2 && last <= 4 && !teen ? "few" : "many";
    }

    /** The language of the system, English when the window does not speak that one. */
    public static Language of(Locale system) {
        return system.getLanguage().equals(RUSSIAN.locale.getLanguage()) ? RUSSIAN : ENGLISH;
    }
}
