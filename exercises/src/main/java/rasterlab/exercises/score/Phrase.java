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

    /** A message of one sentence; a longer one in English. */
    public static Phrase of(Message message) {
        if (message.sentences().size() != 1) return quoted(message.in("en"));
        Message.Sentence one = message.sentences().get(0);
        return new Phrase(one.key(), List.copyOf(one.arguments()));
    }

    /** The words of somebody else, in the language they are in. */
    public static Phrase quoted(String text) {
        return of("quoted", text);
    }

    /** A sentence of the engine, which is said in the language of whoever reads it. */
    public static Phrase ofTheEngine(String english) {
        return of("engine", english);
    }

    /**
     * The phrase in words; English where there are none in that language.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return Message.of(
                        key, arguments.stream().map(each -> argumentText(each, language)).toArray())
                .in(language);
    }

    private static Object argumentText(Object argument, String language) {
        return argument instanceof Phrase phrase ? phrase.in(language) : argument;
    }

    /** The phrase in English. */
    @Override
    public String toString() {
        return in("en");
    }
}
