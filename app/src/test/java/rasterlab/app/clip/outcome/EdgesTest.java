package rasterlab.app.clip.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class EdgesTest {
    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("a covered edge is kept", e(0, 0, 4, 0), e(0, 0, 4, 0), ""),
                argumentSet("direction counts", e(0, 0, 4, 0), e(4, 0, 0, 0), ""),
                argumentSet(
                        "the middle is not cut out",
                        e(0, 0, 4, 0),
                        e(1, 0, 3, 0),
                        "[0.0, 0.0, 1.0, 0.0][3.0, 0.0, 4.0, 0.0]"),
                argumentSet(
                        "the end is not cut off",
                        e(0, 0, 4, 4),
                        e(2, 2, 9, 9),
                        "[0.0, 0.0, 2.0, 2.0]"),
                argumentSet(
                        "a parallel cuts", e(0, 0, 4, 0), e(0, 1, 4, 1), "[0.0, 0.0, 4.0, 0.0]"),
                argumentSet(
                        "a crossing cuts", e(0, 0, 4, 0), e(2, -1, 2, 1), "[0.0, 0.0, 4.0, 0.0]"),
                argumentSet(
                        "a neighbour cuts", e(0, 0, 4, 0), e(4, 0, 9, 0), "[0.0, 0.0, 4.0, 0.0]"),
                argumentSet(
                        "an edge that comes from beside cuts",
                        e(0, 0, 4, 0),
                        e(1, 1, 3, 0),
                        "[0.0, 0.0, 4.0, 0.0]"),
                argumentSet("a covered point is kept", e(2, 0, 2, 0), e(0, 0, 4, 0), ""),
                argumentSet(
                        "a point beside is lost",
                        e(2, 1, 2, 1),
                        e(0, 0, 4, 0),
                        "[2.0, 1.0, 2.0, 1.0]"),
                argumentSet(
                        "z is left out",
                        e(0, 0, 0, 0, 0, 4),
                        e(0, 0, 2, 0, 0, 4),
                        "[0.0, 0.0, 0.0, 0.0, 0.0, 2.0]"));
    }

    private static double[] e(double... ends) {
        return ends;
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void leavesWhatIsNotCovered(double[] edge, double[] other, String rest) {
        var left = new StringBuilder();
        Edges.minus(List.of(edge), List.of(other), 1e-9)
                .forEach(each -> left.append(Arrays.toString(each)));
        assertEquals(rest, left.toString());
    }
}
