package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.study.TopicSchemas;
import rasterlab.engine.Topics;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/** Writes the inputs on which methods fail by the formats of their topics, and reads them again. */
class WrittenInputsTest {
    /**
     * Inputs that cannot be had from outside, or that are refused there before a method sees them.
     */
    private static final String EXCEPT =
            """
            circle negative-radius: not read: /radius
            ellipse too-large: not read: /rx
            ellipse negative-radius: not read: /ry
            fill seed-outside: not read: /seed/0
            fill connectivity-6: not read: /connectivity
            polygon-fill no-number: not told: point 1 must be finite, got (NaN, 5.0)
            line-plane three-points: not told: a plane is told by a point of it, not by c
            line-plane parallel: not told: a plane is told by a point of it, not by c
            line-plane in-the-plane: not told: a plane is told by a point of it, not by c
            line-plane nearly-parallel: not told: a plane is told by a point of it, not by c
            line-plane huge: not told: a plane is told by a point of it, not by c
            line-plane tiny: not told: a plane is told by a point of it, not by c
            line-plane vanishing-slope: not told: a plane is told by a point of it, not by c
            line-plane beyond-doubles: not told: a plane is told by a point of it, not by c
            line-plane point-near-the-start: not told: a plane is told by a point of it, not by c
            clip-segment not-a-number: not read: /segments/0/0
            clip-segment infinite: not read: /segments/0/0
            clip-polygon not-a-number: not read: /polygon/1/0
            clip-volume not-a-number: not read: /segments/0/0
            clip-volume infinite: not read: /segments/0/5
            hidden-surfaces depth-1-at-1000: not told: one eye is told, which sees without end
            hidden-surfaces depth-10-at-100000: not told: one eye is told, which sees without end
            hidden-surfaces depth-50-at-900000: not told: one eye is told, which sees without end
            hidden-surfaces depth-hair-at-900000: not told: one eye is told, which sees without end
            spline-function not-a-number: not read: /y/1
            spline-function widths-at-the-limit: not read: /at/0
            spline-function overshoot: not told: that the shape counts is not told
            color brighter-than-white: not read: /rgb/0
            texture-filter hair: not told: a picture is told in greys, got 0
            """;

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void anInputIsReadAsItWasWritten(Topic<?, ?, ?> topic) throws IOException {
        List<String> expected =
                EXCEPT.lines().filter(line -> line.startsWith(topic.name() + " ")).toList();
        assertEquals(expected, failures(topic));
    }

    private static <I> List<String> failures(Topic<?, I, ?> topic) throws IOException {
        var failures = new ArrayList<String>();
        Format<?, I, ?> format = topic.format();
        TopicSchemas schemas = TopicSchemas.of(topic.name());
        for (Hazard<I> hazard : topic.hazards())
            for (I input : format.singles(hazard.input())) {
                Optional<String> failure = failure(format, input, schemas);
                if (failure.isPresent())
                    failures.add(topic.name() + " " + hazard.name() + ": " + failure.get());
            }
        return failures;
    }

    private static <I> Optional<String> failure(
            Format<?, I, ?> format, I input, TopicSchemas schemas) throws IOException {
        String json;
        try {
            json = written(format, input);
        } catch (IllegalArgumentException e) {
            return Optional.of("not told: " + e.getMessage());
        }
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        try {
            I read = format.read(StrictJson.read(text, text.length, format.input(), format.open()));
            assertEquals(List.of(), schemas.input().validate(TopicSchemas.tree(json)), json);
            return SameParts.difference(input, read);
        } catch (InvalidInput e) {
            return Optional.of("not read: " + e.place());
        }
    }

    private static <I> String written(Format<?, I, ?> format, I input) throws IOException {
        var bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
            json.writeStartObject();
            format.writeInput(input, new ProgramJson(json));
            json.writeEndObject();
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
