package rasterlab.app.canvas;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** What a verdict says in English beside its kind, in the language of the window. */
public final class VerdictDetail {
    private static final Pattern PLACE = Pattern.compile("\\((-?\\d+), (-?\\d+)\\)");

    /** Of a method that does not end: how many of what it gave, and how many are right. */
    private static final Pattern ENDLESS =
            Pattern.compile("still going after (\\d+) (.+) where (\\d+) are right");

    /** A sentence of the engine, and the key of ours with the places as $1 and $2. */
    private record Sentence(String english, String key) {}

    private static final List<Sentence> SENTENCES =
            List.of(
                    new Sentence("pixel {} is missing, {} is drawn", "difference.swapped"),
                    new Sentence("pixel {} is missing", "difference.missing"),
                    new Sentence("pixel {} is extra", "difference.extra"));

    private VerdictDetail() {}

    /**
     * A first difference, a refusal or a deviation; what is none of them, such as a crash in Java's
     * own words, stays as it is.
     */
    public static String said(Language language, String detail) {
        return Complaints.said(language, difference(Texts.of("canvas", language), detail));
    }

    /** The sentence with what is about pixels translated; the rest stays as it is. */
    private static String difference(Texts texts, String detail) {
        String said = detail;
        for (Sentence each : SENTENCES)
            said =
                    Pattern.compile(each.english().replace("{}", "(" + PLACE + ")"))
                            .matcher(said)
                            .replaceAll(found -> inWords(texts, each, found));
        return ENDLESS.matcher(said)
                .replaceAll(
                        found ->
                                texts.text("difference.endless")
                                        .replace("$1", found.group(1))
                                        .replace("$2", found.group(2))
                                        .replace("$3", found.group(3)));
    }

    /** Of each place three groups are found: itself and its two numbers. */
    private static String inWords(Texts texts, Sentence sentence, MatchResult found) {
        String words = texts.text(sentence.key());
        for (int i = 0; 3 * i < found.groupCount(); i++)
            words =
                    words.replace(
                            "$" + (i + 1),
                            Shown.point(
                                    Integer.parseInt(found.group(3 * i + 2)),
                                    Integer.parseInt(found.group(3 * i + 3)),
                                    texts.locale()));
        return words;
    }
}
