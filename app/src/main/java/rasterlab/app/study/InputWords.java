package rasterlab.app.study;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.app.language.Texts;

/** Translates the English names of inputs to the window's language. */
final class InputWords {
    /** A sentence of the engine, and the key of ours with what its groups found. */
    private record Sentence(Pattern english, String key) {
        static Sentence of(String english, String key) {
            return new Sentence(Pattern.compile(english), key);
        }
    }

    private static final List<Sentence> SENTENCES =
            List.of(
                    Sentence.of("(\\d+) polygons seen from (.+)", "input.polygons"),
                    Sentence.of("(\\d+) faces in (\\d+)×(\\d+) pixels", "input.faces"),
                    Sentence.of("(\\d+) faces, eye (.+), inside (.+)", "input.body"),
                    Sentence.of("(\\d+) lines and the plane (.+)", "input.lines"),
                    Sentence.of("(\\d+) corners, (.+), in (\\d+)×(\\d+) pixels", "input.corners"),
                    Sentence.of("(\\d+) knots, (.+), (\\d+) places", "input.knots"),
                    Sentence.of("(.+) of (\\d+), flatness (.+)", "input.curve.flat"),
                    Sentence.of("(.+) of (\\d+), (\\d+) points", "input.curve.points"),
                    Sentence.of(
                            "from (.+) with '(.+)', connectivity (\\d), in a picture of (\\d+) rows",
                            "input.fill"),
                    Sentence.of("half-axes (.+), (.+) about (.+)", "input.ellipse"),
                    Sentence.of("radius (.+) about (.+)", "input.circle"),
                    Sentence.of("(.+→.+) in (.+)", "input.segment"),
                    Sentence.of("\\[(.*), … (\\d+) points]", "input.points"));

    private InputWords() {}

    /** The sentence; one that is none of these stays as it is. */
    static String translated(Texts texts, String english) {
        for (Sentence each : SENTENCES) {
            Matcher found = each.english().matcher(english);
            if (found.matches()) return texts.text(each.key(), groups(texts, found));
        }
        return word(texts, english);
    }

    /** A constant's name in words; what is none stays as it is. */
    private static String word(Texts texts, String constant) {
        return texts.textOr("word." + constant, constant);
    }

    /** Whole numbers as such, for what is counted, and constants in words. */
    private static Object[] groups(Texts texts, Matcher found) {
        var groups = new Object[found.groupCount()];
        for (int i = 0; i < groups.length; i++) {
            String group = found.group(i + 1);
            groups[i] =
                    group.matches("\\d{1,18}") ? (Object) Long.valueOf(group) : word(texts, group);
        }
        return groups;
    }
}
