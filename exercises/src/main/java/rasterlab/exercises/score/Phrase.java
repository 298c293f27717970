package rasterlab.exercises.score;

import java.util.List;

/**
 * Words of ours as data, in whose places other such words may stand: in the language of whoever
 * reads them.
 *
 * @param key of a text of {@link Message}
 * @param arguments what stands in its places {0}, {1}, …; a phrase among them is said in the same
 *     language, all others as they are
 */
public record Phrase(String key, List<Object> arguments) {
    public Phrase {
        arguments = List.copyOf(arguments);
    }

    public static Phrase of(String key, Object... arguments) {
        return new Phrase(key, List.of(arguments));
    }

    /** What somebody else says, in the language it is in. */
    public static Phrase quoted(String text) {
        return of("quoted", text);
    }

    /**
     * In words; English where there are none in that language.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return Message.of(key, arguments.stream().map(each -> said(each, language)).toArray())
                .in(language);
    }

    private static Object said(Object argument, String language) {
        return argument instanceof Phrase phrase ? phrase.in(language) : argument;
    }

    /** In English. */
    @Override
    public String toString() {
        return in("en");
    }
}
