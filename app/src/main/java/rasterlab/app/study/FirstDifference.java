package rasterlab.app.study;

import java.util.List;
import rasterlab.app.language.Texts;

/** What comparisons of pixels say in English, in the window's language. */
final class FirstDifference {
    private static final String PLACE = "(\\(-?\\d+, -?\\d+\\))";

    /** A sentence of the engine, and the key of ours with the places as $1 and $2. */
    private record Sentence(String english, String key) {}

    private static final List<Sentence> SENTENCES =
            List.of(
                    new Sentence("pixel {} is missing, {} is drawn", "difference.swapped"),
                    new Sentence("pixel {} is missing", "difference.missing"),
                    new Sentence("pixel {} is extra", "difference.extra"));

    private FirstDifference() {}

    /** The sentence with what is about pixels translated; the rest stays as it is. */
    static String said(Texts texts, String detail) {
        String said = detail;
        for (Sentence each : SENTENCES)
            said = said.replaceAll(each.english().replace("{}", PLACE), texts.text(each.key()));
        return said;
    }
}
