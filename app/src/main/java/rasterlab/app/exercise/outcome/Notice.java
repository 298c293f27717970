package rasterlab.app.exercise.outcome;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * Something to tell the user, in words of the window's language only where it is shown.
 *
 * @param key of the text, behind {@code notice.}
 * @param arguments what stands in its places
 * @param quoted what stands in the place behind them, in the window's language
 */
public record Notice(String key, List<String> arguments, LocalizedText quoted) {
    public static final Notice NONE = of("");

    public Notice {
        arguments = List.copyOf(arguments);
    }

    public static Notice of(String key, String... arguments) {
        return new Notice(key, List.of(arguments), LocalizedText.NOTHING);
    }

    /** A notice around a sentence that comes in every language. */
    public static Notice quoting(String key, LocalizedText sentence) {
        return new Notice(key, List.of(), sentence);
    }

    public boolean isEmpty() {
        return key.isEmpty();
    }

    private Object[] arguments(Language language) {
        return Stream.concat(
                        arguments.stream().map(each -> Complaints.translated(language, each)),
                        Stream.of(quoted.in(language)))
                .toArray();
    }

    public String in(Texts texts) {
        return isEmpty() ? "" : texts.text("notice." + key, arguments(texts.language()));
    }
}
