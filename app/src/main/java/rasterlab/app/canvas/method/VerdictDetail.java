package rasterlab.app.canvas.method;

import java.util.List;
import java.util.function.BinaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** Translates the English detail of a verdict to the language of the window. */
public final class VerdictDetail {
    private static final Pattern PLACE = Pattern.compile("\\((-?\\d+), (-?\\d+)\\)");

    /** A method does not end: how many of what it gave, and how many are right. */
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
    public static String translated(Language language, String detail) {
        Texts texts = Texts.of("canvas", language);
        BinaryOperator<String> point =
                (x, y) -> Shown.point(Integer.parseInt(x), Integer.parseInt(y), texts.locale());
        return Complaints.translated(language, difference(texts, detail, point));
    }

    /** The detail on a terminal, with the numbers as one types them. */
    public static String saidToTypist(Language language, String detail) {
        if (language == Language.ENGLISH) return Complaints.saidToTypist(language, detail);
        Texts texts = Texts.of("canvas", language);
        String said = difference(texts, detail, "(%s, %s)"::formatted);
        return Complaints.saidToTypist(language, said);
    }

    /** The sentence with what is about pixels translated; the rest stays as it is. */
    private static String difference(Texts texts, String detail, BinaryOperator<String> point) {
        String said = detail;
        for (Sentence each : SENTENCES)
            said =
                    Pattern.compile(each.english().replace("{}", "(" + PLACE + ")"))
                            .matcher(said)
                            .replaceAll(found -> inWords(texts.text(each.key()), found, point));
        return ENDLESS.matcher(said)
                .replaceAll(
                        found ->
                                texts.text("difference.endless")
                                        .replace("$1", found.group(1))
                                        .replace("$2", found.group(2))
                                        .replace("$3", found.group(3)));
    }

    /** Puts in the places; three groups are found of each: itself and its two numbers. */
    private static String inWords(String text, MatchResult found, BinaryOperator<String> point) {
        String words = text;
        for (int i = 0; 3 * i < found.groupCount(); i++)
            words =
                    words.replace(
                            "$" + (i + 1),
                            point.apply(found.group(3 * i + 2), found.group(3 * i + 3)));
        return words;
    }
}
