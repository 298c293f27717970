package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.run.TopicRunner;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/** Reads what {@code ./lab methods} says of JSON in Russian. */
class FormWordsTest {
    private static final Pattern NAME = Pattern.compile("\"[^\"]+\"");

    /** Two words one after the other, or one that names nothing. */
    private static final Pattern ENGLISH =
            Pattern.compile(
                    "(?<![-\\w(])[a-z]{2,} [a-z]{2,}\\b(?! +[-|])|\\b(and|is|of|or|the|then|where)\\b");

    private final FormWords english = new FormWords(Language.ENGLISH);
    private final FormWords russian = new FormWords(Language.RUSSIAN);

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    @ParameterizedTest(name = "the JSON of {0} is explained in English")
    @MethodSource("topics")
    void isRussian(String topic) {
        TopicRunner<?> run = TopicRunner.named(topic);
        var said = new TreeSet<>(russian.vocabulary(run.format().topic()).values());
        said.add(russian.reads(run));
        said.add(russian.answers(run));
        for (String each : said)
            assertFalse(ENGLISH.matcher(NAME.matcher(each).replaceAll("")).find(), each);
    }

    @ParameterizedTest(name = "a name of the JSON of {0} is translated or dropped")
    @MethodSource("topics")
    void namesStay(String topic) {
        TopicRunner<?> run = TopicRunner.named(topic);
        assertEquals(names(english.reads(run)), names(russian.reads(run)));
        assertEquals(names(english.answers(run)), names(russian.answers(run)));
        assertEquals(
                english.vocabulary(run.format().topic()).keySet(),
                russian.vocabulary(run.format().topic()).keySet());
    }

    private static Set<String> names(String form) {
        return NAME.matcher(form)
                .results()
                .map(MatchResult::group)
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
