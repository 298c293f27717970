package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.study.Spoilt;
import rasterlab.app.cli.study.TopicSchemas;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/** A refused input is refused at the field that is wrong, whose name is not said twice. */
class RefusalPlacesTest {
    /** The faults of the input as a whole: which of its fields are there. */
    private static final Pattern WHOLE =
            Pattern.compile(
                    "/: expected (a JSON object|either|one of) .*|/(surplus|\\w+): missing.*");

    private static final Pattern PLACED = Pattern.compile("/([^:]+): .+", Pattern.DOTALL);

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    @DisplayName("a refusal names no field of the input, or another one than is wrong")
    void namesTheFieldThatIsWrong(Topic<?, ?, ?> topic) throws IOException {
        Set<String> known = new TreeSet<>(Set.of("surplus"));
        topic.format().input().stream().map(Field::name).forEach(known::add);
        int placed = 0;
        for (String input : GoldenFile.inputs(topic.name()))
            for (Spoilt spoilt : Spoilt.all(TopicSchemas.tree(input))) {
                Optional<String> refusal = refusal(topic.format(), spoilt.value());
                if (refusal.isEmpty() || WHOLE.matcher(refusal.get()).matches()) continue;
                String what = spoilt.how() + " in " + input + ": " + refusal.get();
                Matcher found = PLACED.matcher(refusal.get());
                assertTrue(found.matches(), what);
                assertTrue(known.contains(found.group(1).split("/")[0]), what);
                placed++;
            }
        assertTrue(placed > 10, topic.name() + ": only " + placed + " were refused");
    }

    @ParameterizedTest
    @MethodSource("topics")
    @DisplayName("a refusal says a field's name behind its place again")
    void saysAFieldsNameOnce(Topic<?, ?, ?> topic) throws IOException {
        var twice = new TreeSet<String>();
        for (String input : GoldenFile.inputs(topic.name()))
            for (Spoilt spoilt : Spoilt.all(TopicSchemas.tree(input)))
                refusal(topic.format(), spoilt.value())
                        .filter(refusal -> refusal.matches("(?s)/(.*/)?([\\w-]+): \\2 .*"))
                        .ifPresent(twice::add);
        twice.remove("/light/attenuation: attenuation needs a number above 0, got 0, 0 and 0");
        assertEquals(Set.of(), twice);
    }

    private static Optional<String> refusal(Format<?, ?, ?> format, JsonNode input) {
        byte[] text = input.toString().getBytes(StandardCharsets.UTF_8);
        try {
            format.read(StrictJson.read(text, text.length, format.input(), format.open()));
            return Optional.empty();
        } catch (InvalidInput | IllegalArgumentException refused) {
            return Optional.of(refused.getMessage());
        }
    }
}
