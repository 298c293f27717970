package rasterlab.engine.signmap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.predicate.Spacing;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

class SignMapTest {
    /** A topic that asks a question, by its name in messages. */
    private record SignRequest(Topic<?, ?, ?> topic, SignSubject signs) {
        @Override
        public String toString() {
            return topic.name();
        }
    }

    static Stream<SignRequest> topics() {
        return Topics.all().stream()
                .flatMap(
                        topic ->
                                SignSubject.of(topic).map(s -> new SignRequest(topic, s)).stream());
    }

    @ParameterizedTest(name = "a method that promises to be right errs near its border: {0}")
    @MethodSource("topics")
    void rightMethodsHaveNoWrongArea(SignRequest asked) {
        for (Method<?> method : asked.topic().methods()) {
            if (!method.promisesToBeRight()) continue;
            SignMap map = asked.signs().map(method.name());
            assertEquals(0, map.extra() + map.missing() + map.unanswered(), method.name());
        }
    }

    @ParameterizedTest(name = "the point is far from the border: {0}")
    @MethodSource("topics")
    void bothAnswersAreRightSomewhere(SignRequest asked) {
        for (String method : asked.signs().methods()) {
            SignMap map = asked.signs().map(method);
            var seen = new ArrayList<Integer>();
            for (int row = 0; row < map.size(); row++)
                for (int column = 0; column < map.size(); column++)
                    if (!seen.contains(map.exact(column, row))) seen.add(map.exact(column, row));
            assertTrue(seen.containsAll(List.of(0, 1)), method + " " + seen);
        }
    }

    /**
     * Each map in {@code maps.txt}, point by point: more, less and no answers, and a sum over all
     * answers and what is right.
     */
    @Test
    void mapsAreThoseThatWereRead() throws IOException {
        var subjects = new ArrayList<>(SignSubject.basic());
        Topics.all().forEach(topic -> SignSubject.of(topic).ifPresent(subjects::add));
        for (String line : read()) {
            String[] words = line.split("[/ ]");
            SignMap map = SignSubject.find(words[0], subjects).map(words[1]);
            assertEquals(line, written(map));
        }
    }

    private static List<String> read() throws IOException {
        try (InputStream in = SignMapTest.class.getResourceAsStream("maps.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
    }

    private static String written(SignMap map) {
        var sum = new CRC32();
        for (int row = 0; row < map.size(); row++)
            for (int column = 0; column < map.size(); column++) {
                sum.update(map.answer(column, row));
                sum.update(map.exact(column, row));
            }
        return "%s/%s %d %d %d %08x"
                .formatted(
                        map.subject(),
                        map.method(),
                        map.extra(),
                        map.missing(),
                        map.unanswered(),
                        sum.getValue());
    }

    /** The block structure of the paper's first figure: which point is subtracted matters. */
    @Test
    void orientationErrsByThePointThatIsSubtracted() {
        SignSubject orientation = SignSubject.basic().get(0);
        assertEquals(5346, orientation.map("from-p").extra() + orientation.map("from-p").missing());
        assertEquals(2804, orientation.map("from-q").extra() + orientation.map("from-q").missing());
        assertEquals(5474, orientation.map("from-r").extra() + orientation.map("from-r").missing());
        assertEquals(0, orientation.map("robust").share());
    }

    @Test
    void onTheLineIsZeroAndAboveItIsPositive() {
        SignMap map = SignSubject.basic().get(0).map("robust");
        assertEquals(0, map.exact(7, 7));
        assertEquals(1, map.exact(7, 8));
        assertEquals(-1, map.exact(8, 7));
        assertEquals(Math.nextUp(map.x(7)), map.x(8));
    }

    @Test
    void neighboursAreThoseOfTheNumbersThatTheMethodHas() {
        assertEquals(Math.nextUp(0.5), Spacing.DOUBLE.above(0.5, 1));
        assertEquals(Math.nextUp(0.5f), Spacing.FLOAT.above(0.5, 1));
        assertEquals(103, Spacing.WHOLE.above(100, 3));
    }
}
