package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import rasterlab.tests.bench.language.BenchWords;

class RasterGoalsTest {
    @Test
    void everyGoalNamesTwoBenchmarksAndEachParameterOfTheirClass() throws Exception {
        for (Goal goal : RasterGoals.all()) {
            for (String name : List.of(goal.ours(), goal.peer()))
                assertTrue(
                        List.of(goal.benchmark().getMethods()).stream()
                                .filter(method -> method.getName().equals(name))
                                .allMatch(method -> method.isAnnotationPresent(Benchmark.class)),
                        goal + ": " + name + " is no benchmark");
            for (var field : goal.benchmark().getFields()) {
                var values = field.getAnnotation(Param.class);
                if (values == null) continue;
                String wanted = goal.parameters().get(field.getName());
                assertTrue(List.of(values.value()).contains(wanted), goal + ": " + field);
            }
        }
    }

    @Test
    void noTwoGoalsHaveOneName() {
        var works = RasterGoals.all().stream().map(Goal::work).toList();
        assertEquals(works.stream().distinct().toList(), works);
    }

    @Test
    void theRatioIsThePeersTimeByOursInTheMiddleRound() {
        Goal goal = RasterGoals.all().get(0);
        var bytes = new ByteArrayOutputStream();
        var rounds = List.of(round(goal, 10, 45), round(goal, 10, 30), round(goal, 20, 100));
        new GoalTable(List.of(goal), rounds)
                .print(BenchWords.ENGLISH, new PrintStream(bytes, true));
        assertTrue(bytes.toString().contains(" | 4.50 (3.00–5.00) | "), bytes.toString());
    }

    private static Map<Timing.Key, Timing> round(Goal goal, double ours, double peer) {
        return Map.of(
                key(goal, goal.ours()), new Timing(ours, ours - 1, ours + 1),
                key(goal, goal.peer()), new Timing(peer, peer - 1, peer + 1));
    }

    @Test
    void aGoalWithoutItsBenchmarkIsRefused() {
        assertThrows(
                IllegalArgumentException.class,
                () -> new Goal("work", LineBenchmark.class, "none", "graphics2d", Map.of(), 1));
    }

    private static Timing.Key key(Goal goal, String method) {
        return Timing.Key.of(goal.benchmark(), method, goal.parameters());
    }
}
