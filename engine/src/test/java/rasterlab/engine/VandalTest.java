package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

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

/** A method that overwrites what it is given answers another question than the topic's. */
@Tag("slow")
class VandalTest {
    private static final Duration AMPLE = Duration.ofMinutes(2);

    /** Their contracts hand out no array but those to fill, only numbers and values of numbers. */
    private static final Set<String> WITHOUT_ARRAYS =
            Set.of(
                    "line",
                    "circle",
                    "ellipse",
                    "fill",
                    "point-in-triangle",
                    "clip-segment",
                    "clip-volume",
                    "depth-buffer",
                    "hidden-surfaces",
                    "texture-mapping");

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void neverIsExactAndNeverChangesTheTopicsOwnInput(Topic<C, I, O> topic) {
        boolean found = false;
        for (Hazard<I> hazard : topic.hazards())
            for (Method<C> method : topic.methods()) {
                if (hazard.recorded().get(method.name()) != Verdict.Kind.EXACT) continue;
                String before = Written.out(hazard.input());
                var vandal = new Vandal(method.implementation());
                Method<C> vandalizing = new Method<>("vandal", method.about(), vandal.method());
                Verdict verdict = HazardTrial.judge(topic, vandalizing, hazard, AMPLE);
                String place = topic.name() + ", " + hazard.name() + ", " + method.name();
                assertEquals(before, Written.out(hazard.input()), place);
                if (vandal.foundSomething())
                    assertNotEquals(Verdict.Kind.EXACT, verdict.kind(), place);
                found |= vandal.foundSomething();
            }
        assertEquals(!WITHOUT_ARRAYS.contains(topic.name()), found, "found an array");
    }
}
