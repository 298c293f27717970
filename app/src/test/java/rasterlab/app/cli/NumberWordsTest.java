package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.run.TopicRunner;
import rasterlab.app.golden.GoldenFile;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.RussianWords;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/**
 * Keeps the forms in which Java prints numbers and records, and English words in Russian sentences,
 * out of what people read.
 */
@Tag("slow")
class NumberWordsTest {
    /** A double with Java's capital E, or a record with the names of its parts. */
    private static final Pattern JAVA = Pattern.compile("\\dE-?\\d|\\p{L}\\[\\p{L}+=|@[0-9a-f]{5}");

    private static final Pattern NUMBER = Pattern.compile("-?\\d+(?:\\.\\d+)?(?:[eE]-?\\d+)?");

    /** Numbers that some place of some topic refuses. */
    private static final List<String> BAD =
            List.of("0", "-1", "0.5", "1e300", "-1e-300", "1e18", "null");

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    @ParameterizedTest
    @MethodSource("topics")
    void noComplaintOfATopicHasThem(String topic) throws IOException {
        TopicRunner<?> run = TopicRunner.named(topic);
        Set<String> complaints = new TreeSet<>();
        for (String input : GoldenFile.inputs(topic))
            for (String bad : badInputs(input))
                for (String method : List.of(first(run), last(run)))
                    complaints.addAll(complaint(run, method, bad));
        assertTrue(!complaints.isEmpty(), "nothing was refused");
        var wrong = new ArrayList<String>();
        for (String each : complaints) wrong.addAll(wrongForms(each));
        assertEquals(List.of(), wrong);
    }

    /**
     * The sentence wherever it is shown, if one of Java's forms, or English in Russian, is in it
     * there.
     */
    private static List<String> wrongForms(String complaint) {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(
                                        Complaints.translated(language, complaint),
                                        Complaints.saidToTypist(language, complaint)))
                .filter(said -> JAVA.matcher(said).find() || RussianWords.mixed(said))
                .distinct()
                .toList();
    }

    private static String first(TopicRunner<?> run) {
        return run.format().topic().methods().get(0).name();
    }

    private static String last(TopicRunner<?> run) {
        return run.format().topic().methods().get(run.format().topic().methods().size() - 1).name();
    }

    /** The input with each of its numbers in turn replaced by each bad one. */
    private static List<String> badInputs(String input) {
        var bad = new ArrayList<String>();
        Matcher number = NUMBER.matcher(input);
        while (number.find())
            for (String each : BAD)
                bad.add(input.substring(0, number.start()) + each + input.substring(number.end()));
        bad.add(NUMBER.matcher(input).replaceAll("1e-200"));
        bad.add(NUMBER.matcher(input).replaceAll("1"));
        return bad;
    }

    private static List<String> complaint(TopicRunner<?> run, String method, String input) {
        byte[] text = input.getBytes(StandardCharsets.UTF_8);
        try {
            run.answer(method, text, text.length, false);
            return List.of();
        } catch (Complaint complaint) {
            return List.of(complaint.getMessage());
        }
    }
}
