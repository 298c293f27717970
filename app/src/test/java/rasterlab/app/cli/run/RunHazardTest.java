package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.engine.study.Verdict.Kind.EXACT;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.cli.study.TopicSchemas;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.judging.InputJson;

/** {@code ./lab run TOPIC METHOD --hazard NAME}. */
class RunHazardTest {
    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void answersAsToTheSameInputRead(Topic<?, ?, ?> topic) {
        assertTrue(answered(topic) > 0, topic.name() + ": no hazard was answered");
    }

    private static <C, I> int answered(Topic<C, I, ?> topic) {
        int answered = 0;
        for (Hazard<I> hazard : topic.hazards()) {
            Optional<String> right = right(topic, hazard);
            if (right.isEmpty()) continue;
            String where = topic.name() + " " + right.get() + " " + hazard.name();
            Ran told = Ran.lab("run", topic.name(), right.get(), "--hazard", hazard.name());
            assertNotEquals(70, told.exitCode(), where + ": " + told.err());
            if (told.exitCode() != 0) continue;
            Ran read =
                    Ran.labReading(
                            lines(topic, hazard), "run", topic.name(), right.get(), "--lines");
            if (!read.out().contains("{\"error\"")) assertEquals(read.out(), told.out(), where);
            answered++;
        }
        return answered;
    }

    /** The inputs that are read as the hazard's; an empty line where what it has is not told. */
    private static <C, I> String lines(Topic<C, I, ?> topic, Hazard<I> hazard) {
        if (InputJson.of(topic, hazard.name()).isMissingNode()) return "\n";
        return topic.format().singles(hazard.input()).stream()
                .map(single -> InputJson.of(topic.format(), single))
                .collect(Collectors.joining("\n"));
    }

    /** A method that is right on the hazard, so that it ends. */
    private static <C, I> Optional<String> right(Topic<C, I, ?> topic, Hazard<I> hazard) {
        return topic.methods().stream()
                .map(Method::name)
                .filter(name -> hazard.recorded().getOrDefault(name, EXACT) == EXACT)
                .findFirst();
    }

    @ParameterizedTest(name = "./lab run {0} has what no input tells, and is not answered")
    @ValueSource(
            strings = {
                "line-plane formula --hazard three-points",
                "spline-function monotone --hazard overshoot"
            })
    void whatNoInputTellsIsAnsweredInWhole(String call) {
        String[] words = ("run " + call).split(" ");
        Ran ran = Ran.lab(words);
        ran.assertDone();
        for (String line : ran.out().split("\n"))
            assertEquals(
                    List.of(),
                    TopicSchemas.of(words[1]).output().validate(TopicSchemas.tree(line)),
                    line);
    }

    @Test
    void severalInputsAreAnsweredLineByLine() {
        Ran ran = Ran.lab("run", "color", "formula", "--hazard", "pure-colours");
        assertTrue(ran.out().lines().count() > 1, ran.out());
        assertTrue(ran.out().lines().allMatch(line -> line.startsWith("{\"rgb\":")), ran.out());
        ran.assertDone();
    }

    @Test
    void stepsAreAdded() {
        Ran ran = Ran.lab("run", "line", "bresenham", "--hazard", "steep", "--steps");
        assertTrue(ran.out().contains("\"steps\":[{"), ran.out());
        ran.assertDone();
    }

    @Test
    void anUnknownHazardIsToldThoseThereAre() {
        String known =
                Topics.named("line").hazards().stream()
                        .map(Hazard::name)
                        .collect(Collectors.joining(", "));
        Ran.lab("run", "line", "bresenham", "--hazard", "stepp")
                .assertComplains(
                        2,
                        "./lab run: no line hazard 'stepp'; there are "
                                + known
                                + "; did you mean 'steep'?");
    }

    @ParameterizedTest(name = "--hazard is passed over where there is {0}")
    @ValueSource(strings = {"line bresenham --lines", "bresenham --scene=a.scene.json"})
    void otherInputIsRefusedBesideAHazard(String call) {
        Ran.lab(("run --hazard steep " + call).split(" "))
                .assertComplains(
                        2,
                        "./lab run: --hazard NAME goes with TOPIC and METHOD, and not with --lines"
                                + " or --scene");
    }

    @ParameterizedTest
    @MethodSource("topics")
    void noNameOfAHazardNeedsQuotes(Topic<?, ?, ?> topic) {
        for (Hazard<?> hazard : topic.hazards())
            assertTrue(hazard.name().matches("[a-z0-9-]+"), hazard.name());
    }
}
