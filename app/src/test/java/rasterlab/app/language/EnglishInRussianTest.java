package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Keeps English words out of the Russian sentences about what is refused. */
class EnglishInRussianTest {
    private static final Pattern REFUSAL =
            Pattern.compile("throw new \\w+\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*\\+?\\s*)+)[).]");

    /** Words of the sentence itself that are no part of the literal. */
    private static final Pattern GIVEN = Pattern.compile("%s %s");

    private static final Pattern LITERAL = Pattern.compile("\"((?:[^\"\\\\]|\\\\.)*)\"");

    @Test
    void noRefusalIsHalfTranslated() throws IOException {
        var half = new ArrayList<String>();
        List<String> refusals = new ArrayList<>();
        for (String module : List.of("engine", "exercises", "app"))
            refusals.addAll(refusals(Path.of("..", module, "src", "main", "java")));
        assertTrue(refusals.size() > 200, "only " + refusals.size() + " refusals were found");
        for (String english : refusals) {
            String said = Complaints.translated(Language.RUSSIAN, english);
            if (RussianWords.mixed(said)) half.add(english + " -> " + said);
        }
        assertEquals(List.of(), half);
    }

    /** The exceptions that are thrown, with a number in each place of the format. */
    private static List<String> refusals(Path sources) throws IOException {
        try (Stream<Path> files = Files.walk(sources)) {
            var found = new ArrayList<String>();
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                Matcher refusal = REFUSAL.matcher(Files.readString(file));
                while (refusal.find()) {
                    var sentence = new StringBuilder();
                    LITERAL.matcher(refusal.group(1))
                            .results()
                            .forEach(part -> sentence.append(part.group(1)));
                    if (!GIVEN.matcher(sentence).find())
                        found.add(sentence.toString().replaceAll("%[sd]", "7.0"));
                }
            }
            return found;
        }
    }
}
