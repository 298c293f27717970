package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict.Kind;

class LineHazardTest {
    private static final LineTopic TOPIC = new LineTopic();

    @Test
    void noMethodIsEverWrongButTheTextbookOnesAndTheFloatDda() {
        Set<String> failing =
                TOPIC.hazards().stream()
                        .flatMap(hazard -> hazard.recorded().entrySet().stream())
                        .filter(entry -> entry.getValue() != Kind.EXACT)
                        .filter(entry -> entry.getValue() != Kind.REFUSED)
                        .map(Map.Entry::getKey)
                        .collect(Collectors.toSet());
        Set<String> faulty =
                TOPIC.methods().stream()
                        .filter(Method::faulty)
                        .map(Method::name)
                        .collect(Collectors.toSet());
        faulty.add("dda-float");
        assertEquals(faulty, failing);
    }

    @Test
    void bresenhamAndMidpointAreExactOnEveryHazard() {
        for (var hazard : TOPIC.hazards())
            for (String method : List.of("bresenham", "midpoint"))
                assertEquals(Kind.EXACT, hazard.recorded().get(method), hazard.name());
    }
}
