package rasterlab.engine.light.face;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.FaceShader;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Mutant;

/** The mistakes of Gouraud's shading show where just that shading is asked for. */
class GouraudMutantsTest {
    /** Levels that are seen well. */
    private static final double SEEN = 1;

    private static final FaceTopic TOPIC = new FaceTopic();
    private static final FaceShader RIGHT = TOPIC.method("gouraud").implementation();

    static Stream<Mutant<FaceShader>> mutants() {
        return TOPIC.mutants("gouraud").stream()
                .filter(one -> !one.name().equals("no-area-refused"));
    }

    @DisplayName("a mistake does not show on its hazard")
    @ParameterizedTest
    @MethodSource("mutants")
    void aMutantIsFarFromGouraudOnItsHazard(Mutant<FaceShader> mutant) {
        FacePoints input = input(mutant.hazard());
        double worst = TOPIC.compare(input, shades(RIGHT, input), shades(mutant, input)).worst();
        assertTrue(worst > SEEN, () -> mutant + " is off by " + worst + " levels");
    }

    @DisplayName("two mistakes give the same shades everywhere, so that neither can be told")
    @ParameterizedTest
    @MethodSource("mutants")
    void noTwoAreAlikeOnEveryHazard(Mutant<FaceShader> mutant) {
        List<String> alike =
                mutants()
                        .filter(
                                other ->
                                        TOPIC.hazards().stream()
                                                .allMatch(h -> same(mutant, other, h)))
                        .map(Mutant::name)
                        .toList();
        assertEquals(List.of(mutant.name()), alike);
    }

    @Test
    void aFaceWithoutAreaIsRefusedByTheMutantOfThatNameAlone() {
        FacePoints flat = input("zero-area-face");
        assertTrue(shades(RIGHT, flat)[0] > 0);
        FaceShader refusing =
                TOPIC.mutants("gouraud").stream()
                        .filter(one -> one.name().equals("no-area-refused"))
                        .findFirst()
                        .orElseThrow()
                        .implementation();
        assertThrows(IllegalArgumentException.class, () -> shades(refusing, flat));
    }

    private static boolean same(
            Mutant<FaceShader> one, Mutant<FaceShader> other, Hazard<FacePoints> hazard) {
        FacePoints input = hazard.input();
        Optional<double[]> first = answer(one, input);
        Optional<double[]> second = answer(other, input);
        if (first.isEmpty() || second.isEmpty()) return first.isEmpty() && second.isEmpty();
        return TOPIC.compare(input, first.get(), second.get()).worst() < 1e-6;
    }

    /** The shades; empty where the mutant refuses the face. */
    private static Optional<double[]> answer(Mutant<FaceShader> mutant, FacePoints input) {
        try {
            return Optional.of(shades(mutant, input));
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
    }

    private static FacePoints input(String hazard) {
        return TOPIC.hazards().stream()
                .filter(one -> one.name().equals(hazard))
                .map(Hazard::input)
                .findFirst()
                .orElseThrow();
    }

    private static double[] shades(Mutant<FaceShader> mutant, FacePoints input) {
        return shades(mutant.implementation(), input);
    }

    private static double[] shades(FaceShader method, FacePoints input) {
        return TOPIC.record(method, input, TOPIC.mostItems());
    }
}
