package rasterlab.engine.texture.filter;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Mutant;

/** The mistakes of the bilinear and the trilinear lookup show. */
class LookupMutantsTest {
    /** Levels that an exercise may allow for rounding. */
    private static final double ROUNDING = 4;

    private static final FilterTopic TOPIC = new FilterTopic();

    static Stream<Arguments> mutants() {
        return Stream.of("linear", "trilinear")
                .flatMap(
                        method ->
                                TOPIC.mutants(method).stream()
                                        .map(mutant -> arguments(method, mutant)));
    }

    @DisplayName("a mistake does not show on its hazard")
    @ParameterizedTest
    @MethodSource("mutants")
    void aMutantIsFarFromItsMethodOnItsHazard(String method, Mutant<TextureFilter> mutant) {
        FilteredPixels input =
                TOPIC.hazards().stream()
                        .filter(one -> one.name().equals(mutant.hazard()))
                        .map(Hazard::input)
                        .findFirst()
                        .orElseThrow();
        double[] right = colors(TOPIC.method(method).implementation(), input);
        double[] wrong = colors(mutant.implementation(), input);
        double worst = TOPIC.compare(input, right, wrong).worst();
        assertTrue(worst > ROUNDING, () -> mutant + " is off by " + worst + " levels");
    }

    private static double[] colors(TextureFilter method, FilteredPixels input) {
        return TOPIC.record(method, input, TOPIC.mostItems());
    }
}
