package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** One likely mistake in a right method is caught by the hazard that is there for it. */
@Tag("slow")
class MutantsTest {
    private static final Duration AMPLE = Duration.ofMinutes(2);

    static Stream<Named<Topic<?, ?, ?>>> topics() {
        return Topics.all().stream().map(topic -> Named.of(topic.name(), topic));
    }

    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void eachIsCaughtByTheHazardOfItsMistake(Topic<C, I, O> topic) {
        assertAll(topic.mutants().stream().map(mutant -> () -> caught(topic, mutant)));
    }

    private static <C, I, O> void caught(Topic<C, I, O> topic, Mutant<C> mutant) {
        Hazard<I> hazard =
                topic.hazards().stream()
                        .filter(each -> each.name().equals(mutant.hazard()))
                        .findFirst()
                        .orElseThrow(() -> new AssertionError("no hazard of " + mutant));
        Verdict verdict = HazardTrial.judge(topic, method(mutant), hazard, AMPLE);
        assertNotEquals(right(hazard), verdict.kind(), mutant + " gets away");
        assertNotEquals(Verdict.Kind.CRASHED, verdict.kind(), mutant + ": " + verdict.detail());
    }

    /** A mutant that is right on nothing would be rubbish, which everything catches. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void eachIsRightOnSomethingElse(Topic<C, I, O> topic) {
        List<Judged<C>> inputs = inputs(topic).map(input -> Judged.of(topic, input)).toList();
        for (Mutant<C> mutant : topic.mutants())
            assertTrue(
                    inputs.stream().anyMatch(input -> input.isRight(method(mutant))),
                    mutant + " is right on nothing");
    }

    /** An input whose right answer is worked out once, when it is first asked for. */
    private record Judged<C>(Verdict.Kind right, Supplier<Function<Method<C>, Verdict>> judging) {
        static <C, I, O> Judged<C> of(Topic<C, I, O> topic, Hazard<I> hazard) {
            var known = new ArrayList<Function<Method<C>, Verdict>>();
            return new Judged<>(
                    MutantsTest.right(hazard),
                    () -> {
                        if (known.isEmpty())
                            known.add(
                                    HazardTrial.trying(topic, hazard.input(), AMPLE)
                                            .andThen(HazardTrial.MethodAnswer::verdict));
                        return known.get(0);
                    });
        }

        boolean isRight(Method<C> method) {
            return judging.get().apply(method).kind() == right;
        }
    }

    private static <I> Stream<Hazard<I>> inputs(Topic<?, I, ?> topic) {
        Stream<Hazard<I>> smallest =
                topic.workloads().get(0).inputs().stream()
                        .map(input -> new Hazard<>("workload", input, Map.of()));
        return Stream.concat(topic.hazards().stream(), smallest);
    }

    /** The right verdict: exact; where no method is, refused. */
    private static Verdict.Kind right(Hazard<?> hazard) {
        boolean refused =
                hazard.recorded().containsValue(Verdict.Kind.REFUSED)
                        && !hazard.recorded().containsValue(Verdict.Kind.EXACT);
        return refused ? Verdict.Kind.REFUSED : Verdict.Kind.EXACT;
    }

    private static <C> Method<C> method(Mutant<C> mutant) {
        return Method.failing("mutant", mutant.implementation());
    }

    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void thereAreFiveToFifteenOfDifferentNames(Topic<C, I, O> topic) {
        List<String> names = topic.mutants().stream().map(Mutant::name).toList();
        assertTrue(names.size() >= 5 && names.size() <= 15, names.size() + " mutants");
        assertEquals(names.size(), new HashSet<>(names).size(), () -> "one stands twice: " + names);
    }

    /** Grading names both, and none is mistaken for the other. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void noNameIsThatOfAMethod(Topic<C, I, O> topic) {
        var methods = topic.methods().stream().map(Method::name).toList();
        for (Mutant<C> mutant : topic.mutants())
            assertFalse(methods.contains(mutant.name()), mutant + " is a method, too");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "The last pixel", "last pixel", "-last", "last-", "a--b"})
    void aNameIsLowerCaseWordsWithHyphens(String name) {
        var thrown =
                assertThrows(
                        IllegalArgumentException.class, () -> new Mutant<>(name, "both-ends", ""));
        assertTrue(thrown.getMessage().contains("got '" + name + "'"), thrown.getMessage());
    }

    @Test
    void aNameHasAtMost40Characters() {
        String most = "a".repeat(40);
        assertEquals(most, new Mutant<>(most, "both-ends", "").name());
        assertThrows(
                IllegalArgumentException.class, () -> new Mutant<>(most + "a", "both-ends", ""));
    }
}
