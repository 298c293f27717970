package rasterlab.engine.border;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ShrinkingTest {
    @Test
    void numbersThatDoNotMatterBecomeZeroAndOthersTheSmallestThatFail() {
        assertEquals(
                List.of(5.0, 0.0, 0.0),
                Shrinking.shrunk(List.of(37.25, -1e300, -0.0), few -> few.get(0) >= 5));
    }

    @Test
    void equalNumbersShrinkTogether() {
        assertEquals(
                List.of(5.0, 5.0),
                Shrinking.shrunk(
                        List.of(37.25, 37.25),
                        few -> few.get(0).equals(few.get(1)) && few.get(0) >= 5));
    }

    @Test
    void playedNumbersMakeTheSameInputAgain() {
        Draws random = Draws.random(28);
        double[] drawn = random.numbers(6);
        int picked = random.pick(7);
        Draws played = Draws.of(random.drawn());
        assertEquals(List.of(), differences(drawn, played.numbers(6)));
        assertEquals(picked, played.pick(7));
    }

    private static List<Integer> differences(double[] one, double[] other) {
        return IntStream.range(0, one.length)
                .filter(i -> Double.compare(one[i], other[i]) != 0)
                .boxed()
                .toList();
    }
}
