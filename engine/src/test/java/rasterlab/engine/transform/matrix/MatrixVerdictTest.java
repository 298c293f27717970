package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.time.Duration;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Answers that are no matrix of the right size. */
class MatrixVerdictTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("shapes")
    void isWrongAndSaysWhatIsMissing(double[][] answer, String detail) {
        var topic = new MatrixTopic();
        var method = Method.<MatrixFormula>failing("own", (name, parameters) -> anew(answer));
        var hazard = new Hazard<>("one", MatrixCall.of("IDENTITY"), Map.of());
        Verdict verdict = HazardTrial.judge(topic, method, hazard, Duration.ofMinutes(2));
        assertEquals(Verdict.Kind.WRONG, verdict.kind());
        assertEquals(detail, verdict.detail());
    }

    private static double[][] anew(double[][] rows) {
        return rows == null
                ? null
                : Stream.of(rows)
                        .map(row -> row == null ? null : row.clone())
                        .toArray(double[][]::new);
    }

    static Stream<Arguments> shapes() {
        return Stream.of(
                argumentSet("no matrix stops the table", null, "no matrix where 4 rows are right"),
                argumentSet(
                        "a plane's matrix stops the table",
                        new double[3][3],
                        "3 rows where 4 rows are right"),
                argumentSet("one row is several", new double[1][4], "1 row where 4 rows are right"),
                argumentSet(
                        "one cell is several", new double[4][1], "row 1 has 1 cell, right are 4"),
                argumentSet(
                        "a short row stops the table",
                        new double[][] {{1, 0, 0, 0}, {0, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                        "row 2 has 3 cells, right are 4"),
                argumentSet(
                        "a row that is left out stops the table",
                        new double[][] {{1, 0, 0, 0}, null, {0, 0, 1, 0}, {0, 0, 0, 1}},
                        "row 2 has 0 cells, right are 4"));
    }
}
