package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** A method that overwrites what it is to read answers another question than the topic's. */
@Tag("slow")
class VandalTest {
    private static final Duration AMPLE = Duration.ofMinutes(2);

    /** Topics whose contracts hand out arrays to fill, in which nothing is read before. */
    private static final Set<String> WITH_ARRAYS_TO_FILL = Set.of("depth-buffer");

    /** Contracts that hand out numbers and values of numbers. */
    private static final Set<String> WITHOUT_ARRAYS =
            Set.of(
                    "line",
                    "circle",
                    "ellipse",
                    "fill",
                    "point-in-triangle",
                    "clip-segment",
                    "clip-volume",
                    "hidden-surfaces",
                    "texture-mapping");

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void isExactOnlyInArraysToFillAndNeverChangesTheTopicsOwnInput(Topic<C, I, O> topic) {
        boolean toFill = WITH_ARRAYS_TO_FILL.contains(topic.name());
        boolean found = false;
        for (Hazard<I> hazard : topic.hazards()) {
            var trying = HazardTrial.trying(topic, hazard.input(), AMPLE);
            for (Method<C> method : topic.methods()) {
                if (hazard.recorded().get(method.name()) != Verdict.Kind.EXACT) continue;
                String before = Written.out(hazard.input());
                var vandal = new Vandal(method.implementation());
                Method<C> vandalizing = Method.failing("vandal", vandal.method());
                Verdict verdict = trying.apply(vandalizing).verdict();
                String place = topic.name() + ", " + hazard.name() + ", " + method.name();
                assertEquals(before, Written.out(hazard.input()), place);
                if (vandal.foundSomething())
                    assertEquals(toFill, verdict.kind() == Verdict.Kind.EXACT, place);
                found |= vandal.foundSomething();
            }
        }
        assertEquals(!WITHOUT_ARRAYS.contains(topic.name()), found, "found an array");
    }
}
