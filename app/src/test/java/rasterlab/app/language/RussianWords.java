package rasterlab.app.language;

import java.util.regex.Pattern;

/** Tells a Russian sentence with English words in it. */
public final class RussianWords {
    private static final Pattern QUOTED = Pattern.compile("«[^»]*»|'[^']*'|`[^`]*`|\"[^\"]*\"");

    /** Words of names and notations have no blank between them, or a sign. */
    private static final Pattern TWO =
            Pattern.compile("(?<!\\S)\\(?[a-z]{2,} [a-z]{2,}(?![\\w./-])");

    private static final Pattern RUSSIAN = Pattern.compile("[а-яё]{2,}");

    private RussianWords() {}

    /** Whether two lower-case English words follow each other in a sentence with Russian words. */
    public static boolean mixed(String said) {
        String bare = QUOTED.matcher(said).replaceAll("");
        return RUSSIAN.matcher(bare).find() && TWO.matcher(bare).find();
    }
}
